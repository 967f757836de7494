#include "force/spring/overlap.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// A point of an outline in the contact's frame: its coordinate on the contact plane, and its depth behind
/// it.
struct SeenPoint {
  double s;
  double depth;
};

/// An outline in that frame: of the owner of the contact plane, behind the plane, or of the other block, in
/// front.
struct SeenOutline {
  const Outline<2>& outline;
  Vector<2> shift;
  Vector<2> tangent;
  Vector<2> normal;  // out of the owner
  double plane;      // height of the contact plane

  SeenPoint point(int vertex) const {
    const Vector<2> p = outline.vertex(vertex) + shift;
    return {tangent.dot(p), plane - normal.dot(p)};
  }
};

/// An edge in that frame; sign -1 on the far side of its block. One too steep for a slope covers nothing.
struct SeenEdge {
  SeenEdge() = default;
  SeenEdge(const SeenPoint& start, const SeenPoint& end, double sign_of_side)
      : from(start),
        slope((end.depth - start.depth) / (end.s - start.s)),
        lower_end(std::min(start.s, end.s)),
        upper_end(std::isfinite(slope) ? std::max(start.s, end.s) : lower_end),
        sign(sign_of_side) {}

  double depth_at(double s) const { return from.depth + slope * (s - from.s); }

  SeenPoint from;
  double slope;
  double lower_end;
  double upper_end;
  double sign;
};

/// Sums of trapezoids between edges of both outlines.
struct Profile {
  double twice_area = 0;
  double six_moments = 0;
  double three_squares = 0;  // of the depth
  double first = HUGE_VAL;
  double last = -HUGE_VAL;

  /// Adds the part where the other block's edge is deeper than the owner's.
  void add(const SeenEdge& of_owner, const SeenEdge& of_other) {
    double begin = std::max(of_owner.lower_end, of_other.lower_end);
    double end = std::min(of_owner.upper_end, of_other.upper_end);
    if (!(begin < end)) return;
    double at_begin = of_other.depth_at(begin) - of_owner.depth_at(begin);
    double at_end = of_other.depth_at(end) - of_owner.depth_at(end);
    if (at_begin <= 0 && at_end <= 0) return;
    if (at_begin < 0) begin = end - at_end / (at_end - at_begin) * (end - begin), at_begin = 0;
    if (at_end < 0) end = begin + at_begin / (at_begin - at_end) * (end - begin), at_end = 0;
    const double sum = at_begin + at_end, width = of_owner.sign * of_other.sign * (end - begin);
    twice_area += width * sum;
    six_moments += width * (begin * (sum + at_begin) + end * (sum + at_end));
    three_squares += width * (at_begin * at_begin + at_end * at_end + at_begin * at_end);
    first = std::min(first, begin);
    last = std::max(last, end);
  }

  Profile& operator+=(const Profile& more) {
    twice_area += more.twice_area;
    six_moments += more.six_moments;
    three_squares += more.three_squares;
    first = std::min(first, more.first);
    last = std::max(last, more.last);
    return *this;
  }
};

enum class Way { next, previous };

/// Calls `visit` for the edges of an outline from a vertex on, while they go `away` (1 deeper, -1 less deep),
/// up to a limit. The near side of a block goes `outward` along the contact plane, and the far side returns.
template <class Visitor>
void walk(const SeenOutline& seen, int start, const SeenPoint& at_start, Way way, double away, double limit,
          double outward, Visitor visit) {
  const auto neighbour = [&](int v) {
    return way == Way::next ? seen.outline.next(v) : seen.outline.previous(v);
  };
  SeenPoint here = at_start;
  for (int v = neighbour(start), before = start; away * here.depth < away * limit && v != start;
       before = std::exchange(v, neighbour(v))) {
    const SeenPoint there = seen.point(v);
    const double progress = away * (there.depth - here.depth);
    // An edge of the far side parallel to the plane is reached by both walks, and counted in one.
    if (progress < 0 || (progress == 0 && before != start && way == Way::previous)) return;
    visit(SeenEdge(here, there, outward * (there.s - here.s) < 0 ? -1 : 1));
    here = there;
  }
}

/// The owner's outline from one end of the contact's edge, to the depth of the other block. It is walked
/// once; edges beyond the stored ones are computed again.
class Flank {
 public:
  Flank(const SeenOutline& owner, int start, const SeenPoint& at_start, Way way, double reach, double outward)
      : owner_(owner), start_(start), at_start_(at_start), way_(way), reach_(reach), outward_(outward) {
    go_along([&](const SeenEdge& edge) {
      if (kept_count_ < most_kept)
        kept_[kept_count_++] = edge;
      else
        goes_on_ = true;
    });
  }

  void add_behind(const SeenEdge& of_other, Profile& sum) const {
    for (int i = 0; i < kept_count_; ++i) sum.add(kept_[i], of_other);
    if (goes_on_) add_others_behind(of_other, sum);
  }

 private:
  [[gnu::noinline]] void add_others_behind(const SeenEdge& of_other, Profile& sum) const {
    int i = 0;
    go_along([&](const SeenEdge& edge) {
      if (i++ >= most_kept) sum.add(edge, of_other);
    });
  }

  template <class Visitor>
  void go_along(Visitor visit) const {
    walk(owner_, start_, at_start_, way_, 1, reach_, outward_, visit);
  }

  static constexpr int most_kept = 4;
  const SeenOutline& owner_;
  int start_;
  SeenPoint at_start_;
  Way way_;
  double reach_;
  double outward_;
  int kept_count_ = 0;
  bool goes_on_ = false;
  SeenEdge kept_[most_kept];
};

int deepest_from(const SeenOutline& seen, int vertex) {
  double most = seen.point(vertex).depth;
  const auto climb = [&](auto neighbour) {
    for (int v = neighbour(vertex); seen.point(v).depth > most; v = neighbour(v)) {
      vertex = v;
      most = seen.point(v).depth;
    }
  };
  climb([&](int v) { return seen.outline.next(v); });
  climb([&](int v) { return seen.outline.previous(v); });
  return vertex;
}

}  // namespace

/// On a line through both blocks, with the upper and lower side of each, the length of the overlap is
/// (upper owner - lower other) - (upper owner - upper other) - (lower owner - lower other)
/// + (lower owner - upper other), with negative terms set to 0. Half the same sum of squares is its integral
/// over the penetration. So the force is the energy's derivative.
Overlap<2> measure_overlap(const Outline<2>& a, const Outline<2>& b, const Vector<2>& to_b,
                           const PotentialPair<2>& pair, const Vector<2>& normal) {
  const bool a_owns = pair.owner == 0;
  const Vector<2> out = a_owns ? normal : Vector<2>(-normal);
  const Vector<2> to_other = a_owns ? to_b : Vector<2>(-to_b);
  const Outline<2>& outline = a_owns ? a : b;
  const int start = pair.edge, end = outline.next(pair.edge);
  // The plane goes through the edge, or through its end where two vertices meet. Coordinates are relative to
  // the edge's midpoint, so that a mirrored pair has the same bits.
  const Vector<2> middle = 0.5 * (outline.vertex(start) + outline.vertex(end));
  const double plane =
      std::max(out.dot(outline.vertex(start) - middle), out.dot(outline.vertex(end) - middle));
  const SeenOutline owner{outline, -middle, perpendicular(out), out, plane};
  const SeenOutline other{a_owns ? b : a, to_other - middle, owner.tangent, out, plane};
  const int deepest = deepest_from(other, pair.vertex);
  const SeenPoint at_start = owner.point(start), at_end = owner.point(end), foremost = other.point(deepest);

  // The outlines have opposite directions: counter-clockwise on the other leads towards the start of the
  // edge. Each direction has its own sum, so that a mirrored pair has the same bits.
  SeenEdge edge(at_start, at_end, 1);
  edge.from = {0.5 * (at_start.s + at_end.s), 0.5 * (at_start.depth + at_end.depth)};
  const Flank flank[] = {{owner, start, at_start, Way::previous, foremost.depth, -1},
                         {owner, end, at_end, Way::next, foremost.depth, 1}};
  Profile same_side[2], other_side[2];
  const auto add_way = [&](int side, Way way, double outward) {
    walk(other, deepest, foremost, way, -1, 0, outward, [&](const SeenEdge& of_other) {
      same_side[side].add(edge, of_other);
      flank[side].add_behind(of_other, same_side[side]);
      flank[1 - side].add_behind(of_other, other_side[side]);
    });
  };
  add_way(0, Way::next, -1);
  add_way(1, Way::previous, 1);
  Profile sum = same_side[0], crossing = other_side[0];
  sum += same_side[1];
  crossing += other_side[1];
  sum += crossing;

  Overlap<2> overlap;
  if (!(sum.twice_area > 0)) return overlap;
  const auto at = [&](double s) {
    const Vector<2> here = middle + plane * out + s * owner.tangent;
    return a_owns ? here : Vector<2>(here + to_b);
  };
  overlap.content = 0.5 * sum.twice_area;
  overlap.depth_squared = sum.three_squares / 3;
  overlap.base = sum.last - sum.first;
  // The centroid of an area that is a difference of larger ones may be dominated by rounding.
  overlap.center = at(std::clamp(sum.six_moments / (3 * sum.twice_area), sum.first, sum.last));
  overlap.middle = at(0.5 * (sum.first + sum.last));
  overlap.spread = overlap.base * overlap.base / 12 * owner.tangent * owner.tangent.transpose();
  return overlap;
}

}  // namespace halfspace
