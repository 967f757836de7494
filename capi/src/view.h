#pragma once

#include <cstdint>
#include <cstring>

#include "check.h"
#include "geometry/vector.h"
#include "halfspace/view.h"

namespace halfspace::capi {

template <class View>
void require_view(const View& view, const char* name) {
  if (view.count < 0) {
    refuse(HS_ERROR_ARGUMENT, "%s.count is %lld; it must be >= 0", name, static_cast<long long>(view.count));
  }
  if (view.count == 0) return;
  if (!view.x) refuse(HS_ERROR_ARGUMENT, "%s.x is NULL", name);
  if (!view.y) refuse(HS_ERROR_ARGUMENT, "%s.y is NULL", name);
  const bool overlaps = view.count > 1 && view.stride == 0;
  if (view.stride % std::int64_t(sizeof(double)) != 0 || overlaps) {
    refuse(HS_ERROR_ARGUMENT, "%s.stride is %lld; it must be a multiple of 8 bytes and not 0", name,
           static_cast<long long>(view.stride));
  }
}

/// The address of component `first` of point i.
template <class Component>
Component* at(Component* first, std::int64_t stride, std::int64_t i) {
  return first + i * (stride / std::int64_t(sizeof(double)));
}

inline Vector<2> read_point(const hs_view& view, std::int64_t i) {
  return {*at(view.x, view.stride, i), *at(view.y, view.stride, i)};
}

inline Vector<2> read_finite_point(const hs_view& view, std::int64_t i, const char* name) {
  const Vector<2> p = read_point(view, i);
  if (!p.allFinite()) {
    refuse(HS_ERROR_ARGUMENT, "%s[%lld] is (%g, %g); it must be finite", name, static_cast<long long>(i),
           p.x(), p.y());
  }
  return p;
}

inline void write_point(const hs_mutable_view& view, std::int64_t i, const Vector<2>& p) {
  *at(view.x, view.stride, i) = p.x();
  *at(view.y, view.stride, i) = p.y();
  if (view.z) *at(view.z, view.stride, i) = 0;
}

/// A view of spins or torques: in 2D its z alone counts.
template <class View>
void require_turn_view(const View& view, const char* name) {
  if (view.count != 0) {
    require_view(view, name);
    if (!view.z) refuse(HS_ERROR_ARGUMENT, "%s.z is NULL", name);
  }
}

inline Angular<2> read_finite_turn(const hs_view& view, std::int64_t i, const char* name) {
  const double turn = *at(view.z, view.stride, i);
  if (!std::isfinite(turn)) {
    refuse(HS_ERROR_ARGUMENT, "%s[%lld].z is %g; it must be finite", name, static_cast<long long>(i), turn);
  }
  return Angular<2>(turn);
}

inline void write_turn(const hs_mutable_view& view, std::int64_t i, const Angular<2>& turn) {
  write_point(view, i, {0, 0});
  *at(view.z, view.stride, i) = turn[0];
}

/// HS_OK, or the note that `count` entries did not fit.
inline hs_status fits(std::int64_t count, std::int64_t capacity) {
  return count > capacity ? HS_NOTE_TRUNCATED : HS_OK;
}

}  // namespace halfspace::capi
