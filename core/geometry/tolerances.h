#pragma once

namespace halfspace {

// The fractions by which core answers questions of numbers, by question. One question has one name and one
// value. Each has its unit, or that of which it is a fraction; its meaning; what half or double of it puts at
// risk, by the code; and what noticed when tests/tolerances/vary tried both: tests that fail, only bits of
// the golden record, or nothing. Of values that are nearly 1, half and double are those of the difference
// from 1. Not here: ranges that are accepted from users, limits of an algorithm (sizes, counts, the least
// part of a step) and constants of mathematics, which stand where they are used.

// Rounding: what is it, and what is not?

/// The distance from 1 to the next number. A multiple of it that counts the operations of a formula stands
/// beside that formula.
constexpr double machine_epsilon = 0x1p-52;

/// Fraction of a distance from an origin. What some ten operations make of a place at that distance. Half: a
/// point on a face is beside it in one step and on it in the next. Double: faces that make an angle are one.
/// Noticed by bits.
constexpr double place_rounding = 16 * machine_epsilon;

/// 1 or a little more: a bound times this stays one after rounding. Half or double: the last digits of times
/// of impact.
/// Noticed by bits.
constexpr double bound_margin = 1 + 1e-9;

/// The same for squares of small angles between short edges, in which rounding is more. A thousandth of the
/// excess: regions that nobody tests.
/// Noticed by nothing.
constexpr double proof_margin = 1.001;

/// Multiple of the rounding of its corners. Error of the plane of a sliver, of a polytope about the origin.
/// Half: of many sides of nearly the same depth, one far away is missed. Double: more pairs are searched
/// twice.
/// Noticed by nothing.
constexpr double sliver_rounding = 1e8;

/// Fraction of themselves. Impulses, changes of velocity, masses and depths that differ by less are equal.
/// Half: the solver's noise makes impacts, and breaks bonds at their strength.
/// Noticed by bits.
constexpr double equal_within = 1e-6;

/// Fraction of the distance at which faces are flush. The face of a pressure stays while another is nearer to
/// the middle of the overlap by less. Half: contacts change their face by rounding.
/// Noticed by bits.
constexpr double same_face = 2e-9;

/// Fraction of the largest velocity. Rounding of velocities, below which no solver gets. Half: solves end by
/// their cap of iterations.
/// Noticed by nothing.
constexpr double velocity_rounding = 1e-14;

/// Fraction of the work of all impulses. Rounding of their sum. Half: rebounds without friction are solved
/// again.
/// Noticed by nothing.
constexpr double work_rounding = 1e-11;

/// The strain of a cell by rounding of places. It limits the distance of a body from its origin. Half or
/// double: the limit, in proportion.
/// Noticed by nothing.
constexpr double rounded_strain = 1e-3;

/// Minimum divisor, of any unit: smaller ones are 0.
/// Noticed by nothing.
constexpr double min_divisor = 1e-300;

// Parallel: do two directions differ, do two faces look at each other?

/// rad. Directions at a smaller angle, and unit vectors that differ by less. Above it their cross product is
/// a direction; below it rounding is. Half: contacts of edges have normals of rounding. Double: joints that
/// are nearly parallel are one. Not the parallel angle of a world, which is the user's: that makes a region
/// of two faces that are only nearly parallel.
/// Noticed by bits.
constexpr double strictly_parallel = 1e-6;

/// Cosine. A face whose normal is nearer to a direction lies in its plane and goes before its edge. Half or
/// double: edge contacts of flat wedges, here and there.
/// Noticed by nothing.
constexpr double in_plane_cosine = 1 - 1e-9;

/// rad. A block that turns less in a motion does not turn, for friction that sticks. Half: heaps at rest
/// solve for targets of rounding. Double: blocks creep outwards on slow turntables.
/// Noticed by bits.
constexpr double no_turn = 1e-7;

/// Sine. A face or an edge within this angle of the plane gives a manifold its points: so all that may touch
/// in a step do so together. Beyond it the nearest vertex does. Half: blocks rock when they land. Double:
/// points that never touch cost time.
/// Noticed by bits.
constexpr double facing_sine = 0.3;

/// Cosine. A corner looks at a face that lies at an angle across its way out, by so much at least: meshes
/// bend. Half: corners of bent meshes meet the side of a block. Double: they pass the end of a face.
/// Noticed by nothing.
constexpr double facing_cosine = 0.02;

/// Cosine between the lift of a block and the normal of the entry face that it reveals, at least. Half:
/// blocks that pass a corner enter by its side. Double: none may be an entry.
/// Half is noticed by bits, double by tests.
constexpr double revealed_cosine = 0.5;

/// Fraction of the sum of a convex combination. Half the digits of a double: between opposite, nearly
/// parallel planes a rate is 0 to rounding, and a basis with that pivot would be singular.
/// Noticed by nothing.
constexpr double singular_pivot = 0x1p-26;

// Touching: is a point on a face, is a gap one?

/// Fraction of a block's size, its radius or that of a face. Blocks cut along a joint, or read from a file,
/// touch up to rounding: a smaller gap or overlap counts as a common face, a point less deep is settled, and
/// a block slides over a joint whose edges are off by as little. Half: bonds of scenes with few digits are
/// missed. Double: joints that are thinner than this close.
/// Noticed by bits.
constexpr double touch_reach = 1e-6;

/// Fraction of a block's size. A point nearer to a face is on it; separations, and ends of faces, that differ
/// by less are equal; and a narrower region is a line. Far from the origin place_rounding is more. Half:
/// points bear in one step and not in the next.
/// Noticed by bits.
constexpr double face_reach = 1e-9;

/// Fraction of a length, or of a motion's duration. What is nearer to its end is at the end: a place on an
/// edge at the vertex, an impact at the start. Half or double: ends of edges that meet are counted twice or
/// missed.
/// Noticed by bits.
constexpr double end_reach = 1e-6;

/// Fraction of the smaller radius. Ends of bonds that are nearer to each other are one corner. Half: files
/// with few digits have rings that are open. Double: small faces beside large ones become one corner.
/// Noticed by nothing.
constexpr double corner_reach = 1e-4;

/// Fraction of the smaller radius. Points of a manifold that are nearer are the same from step to step, and
/// keep their impulse. Half: solves begin anew where blocks slide. Double: points of short faces exchange
/// their impulses.
/// Noticed by bits.
constexpr double same_point = 0.05;

/// Fraction of a block's size. Surfaces that differ by less are flush: files round coordinates, and supports
/// deflect; and an edge that lies on a face as nearly, or is as nearly parallel to another, has two points
/// there instead of one. Half: blocks catch at joints of floors that bear them. Double: they pass a step of
/// that height.
/// Noticed by bits.
constexpr double nearly_flush = 1e-3;

/// Fraction of a block's radius. Edges that lie deeper in each other are those of other sides. Half: edges
/// pass through each other. Double: edges of thin blocks meet those behind.
/// Noticed by nothing.
constexpr double other_side = 1e-2;

/// Fraction of the size of both blocks. Where closest points are nearer, detection decides whether blocks
/// touch: simplices of slivers in the plane have large errors. Half or double: time.
/// Noticed by nothing.
template <int D>
constexpr double sure_distance = D == 2 ? 0x1p-16 : 0x1p-40;

// Motion: how far may blocks go before a question is asked again?

/// Fraction of the thinner block's thickness, per motion. Below it two blocks cannot pass through each other
/// undetected, or past each other's middle. Half: more motions are divided, and a block may meet another
/// through another side. Double: thin blocks meet at their far side.
/// Noticed by tests.
constexpr double safe_thickness_fraction = 0.25;

/// Fraction of the thinner block's thickness. Manifolds are found where blocks would be at the end of a
/// motion: overlaps there up to this show the faces that meet. Half: more motions are divided. Double: blocks
/// pass each other.
/// Noticed by bits.
constexpr double manifold_thickness_fraction = 0.5;

/// Fraction of the thinner block's thickness. In a shorter motion the order in which faces close does not
/// matter. Half: time. Double: corners that meet at once enter by the wrong face.
/// Noticed by nothing.
constexpr double short_way = 0x1p-8;

/// Fraction of a block's radius. Blocks that have moved less against each other have the manifold that they
/// had, as long as they move: where they stand it is that of their place (an idea of Box2D v3 and Box3D,
/// Catto 2024). The search is repeated where they deviate by more from motion at constant velocity. Half:
/// time. Double: points stay on faces that turn.
/// Noticed by bits.
constexpr double same_manifold = 1e-3;

/// Fraction of a motion. A part this large is the whole: times of impact are accurate to rounding.
/// Noticed by bits.
constexpr double whole_part = 1 - 1e-12;

/// Fraction of a motion. Times of impact are accurate to this. Half: more trials. Double: energy of rebounds.
/// Noticed by bits.
constexpr double matched_time = 1e-3;

/// Fraction of the depth, per step. Penetration without springs loses this. Half: overlaps stay longer.
/// Double: heaps are pushed apart.
/// Noticed by bits.
constexpr double recovered_part = 0.25;

/// Fraction of the radius, per motion. Points of meshes that overlap at its start come apart by this. Half:
/// overlaps stay longer. Double: overlaps become velocities.
/// Half is noticed by bits, double by tests.
constexpr double recovered_way = 1e-7;

/// Fraction of the extent of a joint. One that has slid farther is replaced by contact, which computes the
/// current overlap of its faces. Half or double: the slip at which it is.
/// Noticed by nothing.
constexpr double slid_joint = 0.1;

// Converged: may a solver end, and has it found what was sought?

/// Fraction of the largest velocity, or of 1. Changes below it: the solution is that of the last iteration.
/// Half: the sweeps over points of meshes go on. Double: a point leaves its face.
/// Noticed by bits.
constexpr double converged_change = 1e-8;

/// Fraction of a block's size. Points of solutions that have converged are closer to their face than this, on
/// either side: loaded ones rest on it, deeper ones are reported. Half: walls of many blocks do not settle;
/// fast ones are reported. Double: gaps stay open.
/// Noticed by nothing.
constexpr double converged_gap = 1e-3;

/// Fraction of a tolerance. Solutions go on to this part of it, so that the next step begins within it. Half:
/// more iterations per step. Double: more steps with any.
/// Noticed by bits.
constexpr double solved_within = 0.1;

/// Fraction of a tolerance. A linear solve is refined to this, and smaller velocities are its noise. Half:
/// time. Double: active sets take noise for a slip.
/// Noticed by bits.
constexpr double refined_within = 1e-3;

/// Fraction of what was before. An iteration gains that leaves less: active sets are tried again, kept as a
/// start of sweeps, or not made stiffer. Half: tall stacks are left to sweeps. Double: sets cost time in
/// heaps.
/// Noticed by bits.
constexpr double worthwhile = 0.1;

/// Multiple of the least before. Active sets do not settle when one leaves more than this. Half: sets are
/// given up that would settle. Double: sets cost time in heaps.
/// Noticed by bits.
constexpr double diverged_ratio = 2;

/// Fraction of the least before. Changes that have not fallen below it in many sweeps stall. Half: solves go
/// on in vain. Double: they end early.
/// Noticed by bits.
constexpr double falling_ratio = 0.999;

/// Fraction of the present energy. When the numerical method has created more of it, the step is unstable.
/// Half: unstable worlds stop later. Double: they stop earlier.
/// Noticed by tests.
constexpr double created_ratio = 0.995;

/// Fraction of the work of all impulses. An impact may lose this and at most that beside what restitution
/// takes. Half: more trials, and, of the second, columns that bounce do not end straight. Double of the
/// second: energy of rebounds. No test sees the first.
/// Noticed by tests.
constexpr double min_loss = 1e-8, max_loss = 1e-3;

/// Multiple of the energy of the changes of velocity. Lacking work above it is a jam: where impulses have
/// converged it is 0. Half: heavy loads on slow solves are jams. Double: jams take more sweeps.
/// Noticed by nothing.
constexpr double jammed_ratio = 10;

/// Fraction of the work of prescribed blocks, regardless of sign. Those that move together, as the walls of a
/// box, do no work against each other. Half: boxes that turn are jams. Double: none is one.
/// Half is noticed by nothing, double by tests.
constexpr double jamming_work_fraction = 0.5;

// Resting: does a block stand? Fractions of the velocity that gravity gives in a step.

/// Blocks stand only by impulses within this tolerance; a world's own may be larger. Half: time. Double:
/// arches that ought to fall creep.
/// Half is noticed by bits, double by nothing.
constexpr double tolerance_to_stand = 1e-6;

/// Slower points do not approach or slip. Half: stacks at rest have impacts. Double: slow slips stick.
/// Noticed by bits.
constexpr double slow_fraction = 1e-3;

/// Blocks that are faster move past each other, and the next step finds another place. Half: heaps that come
/// to rest are swept more. Double: active sets cost time in heaps that move.
/// Noticed by bits.
constexpr double slip_fraction = 0.1;

/// Where sweeps change velocities by more, active sets do not settle. Half: stacks wait for them. Double:
/// sets cost time in heaps that move, and columns that bounce do not end straight.
/// Half is noticed by bits, double by tests.
constexpr double quiet_fraction = 0.5;

}  // namespace halfspace
