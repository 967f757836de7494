#pragma once

#include "detect/two_lanes.h"
#include "geometry/outline.h"
#include "geometry/rotation.h"
#include "geometry/vector.h"

namespace halfspace::capi {

/// An outline turned into another frame, in memory of its own: on the stack for most shapes.
class TurnedOutline {
 public:
  TurnedOutline(const Outline<2>& given, const Rotation<2>& rotation, Memory* memory)
      : given_(given), rotation_(rotation), memory_(memory) {
    const int stride = Outline<2>::padded(given.count);
    components_ =
        stride <= most_inline ? inline_ : static_cast<double*>(memory_->allocate(bytes(), alignof(double)));
    turn(given.x, given.y, component(0), component(1));
    turn(given.nx, given.ny, component(2), component(3));
  }
  ~TurnedOutline() {
    if (components_ != inline_) memory_->deallocate(components_, bytes(), alignof(double));
  }
  TurnedOutline(const TurnedOutline&) = delete;
  TurnedOutline& operator=(const TurnedOutline&) = delete;

  Outline<2> outline() const {
    return {given_.count, component(0), component(1), component(2), component(3), given_.offset};
  }

 private:
  static constexpr int most_inline = 32;

  int stride() const { return Outline<2>::padded(given_.count); }
  std::size_t bytes() const { return 4 * std::size_t(stride()) * sizeof(double); }
  double* component(int k) const { return components_ + k * stride(); }

  void turn(const double* x, const double* y, double* out_x, double* out_y) const {
    const TwoLanes c = both(rotation_.cosine), s = both(rotation_.sine);
    for (int i = 0, count = given_.count; i < count; i += 2) {
      const TwoLanes px = two_at(x + i), py = two_at(y + i);
      put_two_at(out_x + i, c * px - s * py);
      put_two_at(out_y + i, s * px + c * py);
    }
  }

  const Outline<2>& given_;
  Rotation<2> rotation_;
  Memory* memory_;
  double* components_;
  double inline_[4 * most_inline];
};

}  // namespace halfspace::capi
