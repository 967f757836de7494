#pragma once

#include <type_traits>

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "narrow_phase/space/support.h"

namespace halfspace {

/// A polyhedron's outline as it is seen from another frame: its vertices and normals are turned as they are
/// asked for. A contact has few of them, and blocks may have many.
class SeenOutline {
 public:
  /// In its own frame. The outline must live as long.
  SeenOutline(const Outline<3>& outline) : SeenOutline(outline, nullptr) {}
  /// From the frame into which `rotation` turns, which must live as long, too.
  SeenOutline(const Outline<3>& outline, const Rotation<3>& rotation) : SeenOutline(outline, &rotation) {}
  SeenOutline(const Outline<3>& outline, Rotation<3>&& rotation) = delete;

  Vector<3> vertex(int i) const { return turned(outline_->vertex(i)); }
  Vector<3> normal(int f) const { return turned(outline_->normal(f)); }

  /// In its own frame: to ask much about many of its features, turn the question instead of each of them.
  const Outline<3>& unturned() const { return *outline_; }
  bool is_turned() const { return rotation_ != nullptr; }
  Vector<3> in_own_frame(const Vector<3>& v) const { return rotation_ ? rotation_->inverse() * v : v; }

  /// The vertex that lies deepest along a direction, of which one near it is known.
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

/// As what a contact is described from: in the plane, blocks are turned as a whole.
template <int D>
using Seen = std::conditional_t<D == 3, SeenOutline, Outline<2>>;

}  // namespace halfspace
