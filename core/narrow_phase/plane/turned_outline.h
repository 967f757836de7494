#pragma once

#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "simd/two_lanes.h"

namespace halfspace {

/// An outline rotated to another frame, in its own memory: on the stack for most shapes.
class TurnedPolygon {
 public:
  TurnedPolygon(const Outline<2>& given, const Rotation<2>& rotation, Memory* memory)
      : given_(given), memory_(memory) {
    const int stride = Outline<2>::padded(given.count);
    components_ =
        stride <= max_inline ? inline_ : static_cast<double*>(memory_->allocate(bytes(), alignof(double)));
    const TwoLanes c = both(rotation.cosine), s = both(rotation.sine);
    const auto turn = [&](const double* x, const double* y, double* out_x, double* out_y) {
      const TwoLanes px = load_two(x), py = load_two(y);
      store_two(out_x, c * px - s * py);
      store_two(out_y, s * px + c * py);
    };
    double *x = component(0), *y = component(1), *nx = component(2), *ny = component(3);
    for (int i = 0, count = given.count; i < count; i += 2) {
      turn(given.x + i, given.y + i, x + i, y + i);
      turn(given.nx + i, given.ny + i, nx + i, ny + i);
      store_two(component(4) + i, load_two(given.offset + i));
    }
  }
  ~TurnedPolygon() {
    if (components_ != inline_) memory_->deallocate(components_, bytes(), alignof(double));
  }
  TurnedPolygon(const TurnedPolygon&) = delete;
  TurnedPolygon& operator=(const TurnedPolygon&) = delete;

  Outline<2> outline() const {
    return {given_.count, component(0), component(1), component(2), component(3), component(4)};
  }

 private:
  static constexpr int components = 5;
  static constexpr int max_inline = 32;

  int stride() const { return Outline<2>::padded(given_.count); }
  std::size_t bytes() const { return components * std::size_t(stride()) * sizeof(double); }
  double* component(int k) const { return components_ + k * stride(); }

  const Outline<2>& given_;
  Memory* memory_;
  double* components_;
  double inline_[components * max_inline];
};

}  // namespace halfspace
