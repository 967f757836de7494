#pragma once

#include <type_traits>

#include "narrow_phase/space/seen_outline.h"

namespace halfspace {

/// The identity, for frames of one orientation.
struct NoTurn {
  NoTurn inverse() const { return {}; }
  const Vector<3>& operator*(const Vector<3>& v) const { return v; }
};

/// A vertex of the Minkowski difference b - a, with the vertices of a and b of which it is the difference.
struct Corner {
  Vector<3> at;
  int a;
  int b;

  bool same_as(const Corner& other) const { return a == other.a && b == other.b; }
};

/// All differences of a point of b and a point of a, in the frame of a: it contains the origin if and only if
/// the blocks overlap, and its facets are their potential contact pairs (docs/theory.md). Block b stays in
/// its own frame; only results are rotated.
template <class Turn>
class MinkowskiDifference {
 public:
  MinkowskiDifference(const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b, const Turn& b_in_a)
      : a_(a), b_(b), to_b_(to_b), b_in_a_(b_in_a), a_in_b_(b_in_a.inverse()) {}

  /// The deepest corner along a direction; `near` is the start of the search.
  template <class Four = TwiceTwoLanes>
  [[gnu::always_inline]] Corner deepest_along(const Vector<3>& direction) const {
    return corner_of(deepest<Four>(a_, -direction).vertex,
                     deepest<Four>(b_, in_frame_of_b(direction)).vertex);
  }
  template <class Four = TwiceTwoLanes>
  [[gnu::always_inline]] Corner deepest_along(const Vector<3>& direction, const Corner& near) const {
    return corner_of(deepest<Four>(a_, -direction, near.a).vertex,
                     deepest<Four>(b_, in_frame_of_b(direction), near.b).vertex);
  }
  const Outline<3>& a() const { return a_; }
  const Outline<3>& b() const { return b_; }
  const Vector<3>& to_b() const { return to_b_; }
  /// Block b in the frame of a.
  SeenOutline seen_b() const {
    if constexpr (std::is_same_v<Turn, NoTurn>) {
      return b_;
    } else {
      return {b_, b_in_a_};
    }
  }
  Vector<3> normal_of_b(int face) const { return b_in_a_ * b_.normal(face); }
  Vector<3> from_frame_of_b(const Vector<3>& direction) const { return b_in_a_ * direction; }
  Vector<3> in_frame_of_b(const Vector<3>& direction) const { return a_in_b_ * direction; }
  Vector<3> vertex_of_b(int vertex) const { return b_in_a_ * b_.vertex(vertex) + to_b_; }

 private:
  Corner corner_of(int of_a, int of_b) const { return {vertex_of_b(of_b) - a_.vertex(of_a), of_a, of_b}; }

  const Outline<3>& a_;
  const Outline<3>& b_;
  Vector<3> to_b_;
  Turn b_in_a_;
  Turn a_in_b_;
};

}  // namespace halfspace
