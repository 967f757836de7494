#pragma once

#include <type_traits>

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "narrow_phase/space/support.h"

namespace halfspace {

/// A polyhedron's outline in another frame: its vertices and normals are rotated on demand, as a contact
/// needs few of them.
class SeenOutline {
 public:
  /// In its own frame. The outline must outlive this.
  SeenOutline(const Outline<3>& outline) : SeenOutline(outline, nullptr) {}
  /// In the frame to which `rotation` rotates; the rotation must outlive this, too.
  SeenOutline(const Outline<3>& outline, const Rotation<3>& rotation) : SeenOutline(outline, &rotation) {}
  SeenOutline(const Outline<3>& outline, Rotation<3>&& rotation) = delete;

  Vector<3> vertex(int i) const { return turned(outline_->vertex(i)); }
  Vector<3> normal(int f) const { return turned(outline_->normal(f)); }

  /// In its own frame: for many features, rotate the direction instead of each of them.
  const Outline<3>& unturned() const { return *outline_; }
  bool is_turned() const { return rotation_ != nullptr; }
  Vector<3> in_own_frame(const Vector<3>& v) const { return rotation_ ? rotation_->inverse() * v : v; }

  /// The deepest vertex along a direction, searched from a nearby one.
  Support deepest_near(const Vector<3>& direction, int vertex) const {
    return walk_to_deepest(*outline_, in_own_frame(direction), vertex);
  }

  const Topology* topology;
  const double* offset;

 private:
  SeenOutline(const Outline<3>& outline, const Rotation<3>* rotation)
      : topology(outline.topology), offset(outline.offset), outline_(&outline), rotation_(rotation) {}
  Vector<3> turned(const Vector<3>& v) const { return rotation_ ? *rotation_ * v : v; }

  const Outline<3>* outline_;
  const Rotation<3>* rotation_;
};

/// The input of contact description: in 2D, blocks are rotated as a whole.
template <int D>
using Seen = std::conditional_t<D == 3, SeenOutline, Outline<2>>;

}  // namespace halfspace
