#include "narrow_phase/time_of_impact.h"

#include <algorithm>
#include <cmath>

#include "geometry/tolerances.h"
#include "narrow_phase/moving_block.h"
#include "narrow_phase/pair.h"
#include "narrow_phase/space/potential_pairs.h"

// Between two times the gap along a normal is the minimum over vertices of smooth functions with second
// derivatives up to `bend`. So it is above the straight line between its values at both times minus
// bend/2 (t - t1)(t2 - t). Two evaluations thus prove separation for some time (conservative advancement,
// Mirtich 1996, with second instead of first derivatives). The normal rotates with its feature: faces with
// the same rotation stay parallel, and convergence to the impact is quadratic. Where one normal's gap
// vanishes, the next is searched.

namespace halfspace {
namespace {

/// A unit normal from a to b that rotates at a constant rate.
template <int D>
struct TurningNormal {
  Vector<D> normal;  // at a time
  Angular<D> turn;   // rotation vector in the interval
  double time;

  Vector<D> at(double t) const { return Rotation<D>().turned_by((t - time) * turn) * normal; }
};

/// The gap at a time.
struct Look {
  double time;
  double gap;
};

Vector<2> normal_of(const Separation<2>& found, const Outline<2>& a, const Outline<2>& b) {
  return normal_of(a, b, found.pair);
}
Vector<3> normal_of(const Separation<3>& found, const Outline<3>&, const Outline<3>&) { return found.normal; }

/// The angular velocity of a unit vector with a given rate of change.
Angular<2> turn_by_rate(const Vector<2>& v, const Vector<2>& rate) { return Angular<2>(cross(v, rate)); }
Angular<3> turn_by_rate(const Vector<3>& v, const Vector<3>& rate) { return cross_product(v, rate); }

/// Finds the features at the impact where only a plane separated the blocks.
void name_features(const SeenOutline& a, const SeenOutline& b, const Vector<3>& to_b, Impact<3>& impact) {
  if (impact.pair.kind != PotentialPair<3>::vertex_vertex) return;
  impact.pair = initial_pair(a, b, to_b, {PairCache<3>::separated, impact.pair, impact.normal});
  impact.gap = refresh(a, b, to_b, impact.pair);
  impact.normal = normal_of(a, b, impact.pair);
}
void name_features(const Outline<2>&, const Outline<2>&, const Vector<2>&, Impact<2>&) {}

template <int D>
class MovingPair {
 public:
  MovingPair(const Outline<D>& a, const Sweep<D>& sweep_of_a, const Outline<D>& b, const Sweep<D>& sweep_of_b,
             double* room)
      : a_(a, sweep_of_a, room),
        b_(b, sweep_of_b, room + component_count(a)),
        to_b_(sweep_of_b.position - sweep_of_a.position),
        way_(sweep_of_b.way - sweep_of_a.way) {
    // Each gap is a sum of about ten products per component, each with an error of a few ulps.
    rounding_ = 64 * machine_epsilon *
                (to_b_.norm() + way_.norm() + a_.reach().radius * (1 + a_.angle()) +
                 b_.reach().radius * (1 + b_.angle()));
  }

  Impact<D> find() {
    Look now = {0, 0};
    Impact<D> impact = look_at(now.time);
    if (impact.gap <= 0) return at(impact, Impact<D>::touching_at_start);
    const auto [first, last] = when_within_reach();
    if (first > last) return {};
    if (first > 0) impact = look_at(now.time = first);
    for (int rounds = max_rounds; rounds > 0 && impact.gap > rounding_; --rounds) {
      const Look next = advance({now.time, impact.gap}, impact, last);
      if (next.time >= last) return {};
      if (next.time <= now.time) break;
      impact = look_at(now.time = next.time);
    }
    return at(impact, Impact<D>::touches);
  }

 private:
  static constexpr int max_rounds = 256;
  static constexpr int max_looks = 64;

  struct Span {
    double first;
    double last;
  };

  /// The time span in which the bounding spheres overlap.
  Span when_within_reach() const {
    const double radius = bound_margin * (a_.reach().radius + b_.reach().radius) + rounding_;
    const double square = way_.squaredNorm(), along = to_b_.dot(way_);
    if (!(square > 0)) return {0, to_b_.norm() > radius ? -1.0 : 1.0};
    const Vector<D> nearest = to_b_ - along / square * way_;
    const double height = radius * radius - nearest.squaredNorm();
    if (height < 0) return {1, 0};
    const double half = std::sqrt(height / square), middle = -along / square;
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
  }

  Vector<D> to_b_at(double time) const { return to_b_ + time * way_; }

  Impact<D> look_at(double time) {
    const Outline<D> a = a_.outline_at(time), b = b_.outline_at(time);
    const Separation<D> found = find_largest_separation(a, b, to_b_at(time));
    Impact<D> impact{Impact<D>::touches, time, found.pair, normal_of(found, a, b), found.gap};
    turn_ = turn_of(found.pair, impact.normal, time, a, b);
    return impact;
  }
  /// Adds the data that only the final result needs.
  Impact<D> at(Impact<D> impact, typename Impact<D>::State state) {
    impact.state = state;
    const Vector<D> to_b = to_b_at(impact.time);
    const Outline<D> a = a_.outline_at(impact.time), b = b_.outline_at(impact.time);
    name_features(a, b, to_b, impact);
    PotentialPair<D> pair = impact.pair;
    Contact<D> contact;
    describe_contact(a, b, to_b, pair, DetectOptions(), contact);
    impact.point = middle_of(contact);
    return impact;
  }
  double gap_along(const TurningNormal<D>& turning, double time) const {
    const Vector<D> normal = turning.at(time);
    return (b_.depth_along(normal, time) + a_.depth_along(-normal, time)) + normal.dot(to_b_at(time));
  }

  /// Bound of the gap's second derivative along a normal.
  double bend(const Angular<D>& turn, double last) const {
    const double speed = turn.norm(), farthest = std::max(to_b_.norm(), to_b_at(last).norm());
    return bound_margin *
           (a_.bend(turn) + b_.bend(turn) + 2 * swept(turn, way_).norm() + speed * speed * farthest);
  }

  /// The time up to which the gap is proven open by two evaluations; at most that of the second.
  static double proven(const Look& from, const Look& to, double bend) {
    const double span = to.time - from.time;
    const double slope = (to.gap - from.gap) / span - 0.5 * bend * span;
    if (slope >= 0) return to.time;
    const double square = slope * slope - 2 * bend * from.gap;
    if (square < 0) return to.time;
    return std::min(to.time, from.time + 2 * from.gap / (std::sqrt(square) - slope));
  }

  Look advance(const Look& start, const Impact<D>& impact, double last) const {
    const TurningNormal<D> with_feature{impact.normal, turn_, start.time},
        fixed{impact.normal, Angular<D>::Zero(), start.time};
    const Look one = advance(start, with_feature, last);
    if (one.time >= last) return one;
    const Look other = advance(start, fixed, last);
    return one.time >= other.time ? one : other;
  }

  Look advance(const Look& start, const TurningNormal<D>& turning, double last) const {
    const double bend = this->bend(turning.turn, last);
    const double rounding = rounding_ * (1 + turning.turn.norm());
    const auto look = [&](double time) { return Look{time, gap_along(turning, time) - rounding}; };
    Look low = look(start.time);
    double closing = 0;
    for (int looks = max_looks; looks > 0 && low.gap > 0; --looks) {
      double span = last - low.time;
      if (bend > 0) span = std::min(span, 1.5 * std::sqrt(4 * low.gap / bend));
      if (closing > 0) span = std::min(span, low.gap / closing);
      const Look high = look(low.time + span);
      const double time = proven(low, high, bend);
      if (time >= last) return {last, high.gap};
      if (time <= low.time) break;
      const Look next = time >= high.time ? high : look(time);
      closing = (low.gap - next.gap) / (time - low.time);
      const bool is_small = next.gap <= 8 * rounding;
      low = next;
      if (is_small) break;
    }
    return low;
  }

  Angular<D> turn_of(const PotentialPair<2>& pair, const Vector<2>& normal, double time, const Outline<2>&,
                     const Outline<2>&) const {
    return turn_of_face(pair.owner == 0 ? a_ : b_, normal, time);
  }
  Angular<D> turn_of(const PotentialPair<3>& pair, const Vector<3>& normal, double time, const Outline<3>& a,
                     const Outline<3>& b) const {
    using Pair = PotentialPair<3>;
    if (pair.kind == Pair::face_vertex) return turn_of_face(a_, normal, time);
    if (pair.kind == Pair::vertex_face) return turn_of_face(b_, normal, time);
    if (pair.kind == Pair::vertex_vertex) return Vector<3>::Zero();
    const Vector<3> along_a = edge_vector(a, pair.a), along_b = edge_vector(b, pair.b);
    const Vector<3> across = cross_product(along_a, along_b);
    const Vector<3> rate = cross_product(rate_of(a_, along_a, time), along_b) +
                           cross_product(along_a, rate_of(b_, along_b, time));
    return cross_product(normal, rate) / across.dot(normal);
  }

  static Vector<D> rate_of(const MovingBlock<D>& block, const Vector<D>& along, double time) {
    return swept(block.turn(), along) + block.stretching_at(time) * along;
  }
  static Angular<D> turn_of_face(const MovingBlock<D>& block, const Vector<D>& normal, double time) {
    return block.turn() + turn_by_rate(normal, Vector<D>(-(block.stretching_at(time).transpose() * normal)));
  }

  MovingBlock<D> a_;
  MovingBlock<D> b_;
  Vector<D> to_b_;  // at the start
  Vector<D> way_;   // displacement of b relative to a
  double rounding_;
  Angular<D> turn_ = Angular<D>::Zero();
};

}  // namespace

template <int D>
Impact<D> time_of_impact(const Outline<D>& a, const Sweep<D>& sweep_of_a, const Outline<D>& b,
                         const Sweep<D>& sweep_of_b, double* room) {
  return MovingPair<D>(a, sweep_of_a, b, sweep_of_b, room).find();
}

template Impact<2> time_of_impact(const Outline<2>&, const Sweep<2>&, const Outline<2>&, const Sweep<2>&,
                                  double*);
template Impact<3> time_of_impact(const Outline<3>&, const Sweep<3>&, const Outline<3>&, const Sweep<3>&,
                                  double*);

}  // namespace halfspace
