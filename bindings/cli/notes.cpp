#include "notes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "loads.h"
#include "text.h"
#include "vector.h"

namespace halfspace::cli {
namespace {

constexpr std::size_t most_lines = 5;  ///< of one kind of note

/// A length as a share of a thickness.
std::string share_of_it(double share) {
  return share < 1 ? rounded(100 * share, 3) + " % of" : rounded(share, 3) + " times";
}

std::string quoted(const std::string& name) { return '"' + name + '"'; }

/// Least width of a shape square to one of its faces. In the plane that is the least of all.
double thickness_of(const Context& context, const Shape& shape) {
  const hs_shape_properties properties = properties_of(context, shape);
  const Point centroid = point_of(properties.centroid);
  const std::vector<Point> vertices = vertices_of(context, shape);
  double thickness = std::numeric_limits<double>::infinity();
  for (const HalfSpace& face : halfspaces_of(context, shape)) {
    double farthest = 0;
    for (const Point& p : vertices)
      farthest = std::max(farthest, face.offset - dot(face.normal, minus(p, centroid)));
    thickness = std::min(thickness, farthest);
  }
  return thickness;
}

/// What the notes ask of a block at the start.
struct Body {
  hs_block_state state;
  double thickness;
  double volume;
  double speed;  ///< of its fastest point at most; of a prescribed motion also when it starts later
};

std::vector<Body> bodies_of(const Context& context, const Model& model, const Frame& frame) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < model.layout().blocks.size(); ++i) {
    const LayoutBlock& given = model.layout().blocks[i];
    const hs_shape_properties properties = properties_of(context, given.shape);
    const double speed =
        length(given.motion.velocity) + length(given.motion.angular_velocity) * properties.bounding_radius;
    bodies.push_back({frame.blocks[i].state, thickness_of(context, given.shape), properties.volume, speed});
  }
  return bodies;
}

/// Deeper than the rounding of where the two blocks are, and than what no one would see.
bool is_overlap(double depth, double thinner, const Body& a, const Body& b) {
  const double places =
      std::max(length(point_of(a.state.pose.position)), length(point_of(b.state.pose.position)));
  return depth > std::ldexp(thinner, -20) + std::ldexp(places, -44);
}

void note_overlaps(const Model& model, const std::vector<Body>& bodies, Faults& faults) {
  struct Found {
    std::size_t a, b;
    double depth, thinner;
  };
  std::vector<Found> found;
  for (const hs_contact& contact : model.contacts()) {
    const Body& a = bodies[contact.block_a];
    const Body& b = bodies[contact.block_b];
    const double thinner = std::min(a.thickness, b.thickness);
    if (is_overlap(-contact.gap, thinner, a, b))
      found.push_back({contact.block_a, contact.block_b, -contact.gap, thinner});
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& first, const Found& second) {
    return first.depth / first.thinner > second.depth / second.thinner;
  });
  const auto& blocks = model.layout().blocks;
  for (std::size_t i = 0; i < std::min(found.size(), most_lines); ++i) {
    const Found& pair = found[i];
    std::string text = quoted(blocks[pair.b].name) + " overlaps " + quoted(blocks[pair.a].name) +
                       " at the start by " + rounded(pair.depth, 3) + " m, " +
                       share_of_it(pair.depth / pair.thinner) +
                       " the thinner one's thickness: their springs drive them apart";
    if (i + 1 == most_lines && found.size() > most_lines)
      text += "; " + std::to_string(found.size() - most_lines) + " more pairs overlap less";
    faults.note(blocks[pair.b].place, blocks[pair.b].key, text);
  }
}

/// Is a point before a chain of segments (> 0) or behind it (< 0), as seen from what of the chain is nearest?
/// Beyond its ends it is neither.
double side_of(const std::vector<Point>& chain, const Point& p) {
  const auto right_of = [&](std::size_t i) {  // the direction to what is before segment i
    const Point along = minus(chain[i + 1], chain[i]);
    return times(1 / length(along), Point{along[1], -along[0], 0});
  };
  const std::size_t segments = chain.size() - 1;
  const bool is_closed = chain.front() == chain.back();
  double least = std::numeric_limits<double>::infinity();
  double side = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    const Point along = minus(chain[i + 1], chain[i]);
    const double share = std::clamp(dot(minus(p, chain[i]), along) / dot(along, along), 0.0, 1.0);
    const Point way = minus(p, plus(chain[i], times(share, along)));
    if (length(way) >= least) continue;
    least = length(way);
    Point before = right_of(i);
    const bool at_end = (share == 0 && i == 0) || (share == 1 && i + 1 == segments);
    if (share == 0) before = plus(before, right_of((i + segments - 1) % segments));
    if (share == 1) before = plus(before, right_of((i + 1) % segments));
    side = at_end && !is_closed ? 0 : dot(way, before);
  }
  return side;
}

/// Where a boundary's points are once it is placed.
std::vector<Point> placed(const Block& block) {
  const double sine = std::sin(block.placing.rotation[2]), cosine = std::cos(block.placing.rotation[2]);
  std::vector<Point> points;
  for (const Point& p : block.boundary)
    points.push_back(
        plus({cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1], 0}, block.placing.shift));
  return points;
}

void note_boundaries(const Scene& scene, const std::vector<Body>& bodies, Faults& faults) {
  for (const Block& block : scene.blocks) {
    if (block.boundary.empty()) continue;
    const std::vector<Point> chain = placed(block);
    int before = 0, behind = 0;
    for (const Body& body : bodies) {
      if (!moves_freely(body.state.kind)) continue;
      const double side = side_of(chain, point_of(body.state.pose.position));
      before += side > 0;
      behind += side < 0;
    }
    if (behind <= before) continue;
    const std::string most = before > 0 ? "most of what is free to move, " : "all that is free to move, ";
    faults.note(block.shape_place, block.making.key + ".boundary",
                quoted(block.making.name) + " seems to run the wrong way round: " + most +
                    std::to_string(behind) + (behind == 1 ? " block" : " blocks") +
                    ", is behind it; before it is what is at the right on the way from point to point");
  }
}

void note_time_step(const Scene& scene, const Model& model, Faults& faults) {
  const double given = scene.world.time_step, stable = model.report().stable_time_step;
  if (!(stable > 0 && given > stable)) return;
  faults.note(scene.time_step_place, "world.time_step",
              shortest(given) + " s is above the stable one, " + rounded(stable, 4) + " s");
}

/// The springs between two blocks.
class Springs {
 public:
  Springs(const Scene& scene, const Model& model) : scene_(scene), length_(model.report().potential_length) {}

  /// Force per depth of faces that meet squarely over the mean section of the smaller of two blocks.
  double stiffness(const Body& a, const Body& b) const {
    const hs_law_def& law = between(a.state.material, b.state.material);
    const double section = std::min(a.volume / a.thickness, b.volume / b.thickness);
    if (law.stiffness_kind == HS_STIFFNESS_NONE) return HUGE_VAL;  // nothing yields
    if (law.stiffness_kind == HS_STIFFNESS_PER_AREA) return law.normal_stiffness * section;
    if (law.stiffness_kind == HS_STIFFNESS_POTENTIAL) return 2 * law.normal_stiffness / length_ * section;
    return law.normal_stiffness;
  }

 private:
  const hs_law_def& between(int a, int b) const {
    for (const PairLaw& pair : scene_.laws) {
      if (std::minmax(pair.a, pair.b) == std::minmax(a, b)) return pair.law;
    }
    return scene_.default_law;
  }

  const Scene& scene_;
  double length_;
};

double inverse_mass(const Body& body) { return moves_freely(body.state.kind) ? 1 / body.state.mass : 0; }

/// The worst pair of all that a note is about.
struct Worst {
  void add(std::size_t one, std::size_t other, double depth, double size) {
    if (!(depth / size > share)) return;
    share = depth / size;
    block = one;
    partner = other;
    this->depth = depth;
  }
  double share = 0, depth = 0;
  std::size_t block = 0, partner = 0;
};

/// A single block that sinks in by 1 % is told, and one under a pile by 10 %.
void note_weights(const Scene& scene, const Model& model, const Frame& frame, const std::vector<Body>& bodies,
                  Faults& faults) {
  constexpr double told_share_alone = 0.01, told_share_in_a_pile = 0.1;
  const Point gravity = point_of(scene.world.gravity);
  const std::vector<double> loads = loads_of(frame, gravity);
  const Springs springs(scene, model);
  std::vector<std::int64_t> count_of(scene.materials.size());
  for (const Body& body : bodies) ++count_of[static_cast<std::size_t>(body.state.material)];
  Worst alone, in_a_pile;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    if (!moves_freely(body.state.kind)) continue;
    Body base = body;  // what it may lie on, as wide as the block itself
    for (std::size_t material = 0; material < count_of.size(); ++material) {
      base.state.material = static_cast<int32_t>(material);
      const bool is_alone = base.state.material == body.state.material && count_of[material] == 1;
      if (count_of[material] == 0 || is_alone) continue;
      const double stiffness = springs.stiffness(body, base);
      alone.add(i, i, body.state.mass * length(gravity) / stiffness, body.thickness);
      in_a_pile.add(i, i, loads[i] / stiffness, body.thickness);
    }
  }
  const bool is_pile = in_a_pile.share >= told_share_in_a_pile && in_a_pile.share > 1.01 * alone.share;
  const Worst& worst = is_pile ? in_a_pile : alone;
  if (worst.share < told_share_alone) return;
  const LayoutBlock& block = model.layout().blocks[worst.block];
  const std::string cause = is_pile ? "its weight and that of what is above it" : "its weight alone";
  faults.note(block.place, block.key,
              quoted(block.name) + " sinks " + rounded(worst.depth, 3) + " m, " + share_of_it(worst.share) +
                  " its thickness, into what it lies on by " + cause +
                  ": a stiffer normal_stiffness holds it up");
}

void note_speeds(const Scene& scene, const Model& model, const std::vector<Body>& bodies, Faults& faults) {
  constexpr double told_share = 0.1;
  const Springs springs(scene, model);
  Worst worst;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].speed == 0 || bodies[i].state.kind == HS_BLOCK_MESH) continue;
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const double inverse = inverse_mass(bodies[i]) + inverse_mass(bodies[j]);
      if (i == j || inverse == 0) continue;
      const Motion &one = model.layout().blocks[i].motion, &other = model.layout().blocks[j].motion;
      if (one.velocity == other.velocity && one.angular_velocity == other.angular_velocity) continue;
      const double depth = bodies[i].speed / std::sqrt(inverse * springs.stiffness(bodies[i], bodies[j]));
      worst.add(i, j, depth, std::min(bodies[i].thickness, bodies[j].thickness));
    }
  }
  if (worst.share < told_share) return;
  const LayoutBlock& block = model.layout().blocks[worst.block];
  faults.note(block.place, block.key,
              quoted(block.name) + " at " + rounded(bodies[worst.block].speed, 3) +
                  " m/s would be stopped by " + quoted(model.layout().blocks[worst.partner].name) +
                  " only at a depth of " + rounded(worst.depth, 3) + " m, " + share_of_it(worst.share) +
                  " the thinner one's thickness, v (m/k)^1/2: a stiffer normal_stiffness stops it earlier");
}

}  // namespace

void note_start(const Context& context, const Scene& scene, const Model& model, Faults& faults) {
  const Frame frame = model.frame();
  const std::vector<Body> bodies = bodies_of(context, model, frame);
  note_overlaps(model, bodies, faults);
  note_boundaries(scene, bodies, faults);
  note_time_step(scene, model, faults);
  note_weights(scene, model, frame, bodies, faults);
  note_speeds(scene, model, bodies, faults);
}

}  // namespace halfspace::cli
