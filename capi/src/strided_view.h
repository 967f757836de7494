#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "context_handle.h"
#include "geometry/vector.h"
#include "halfspace/view.h"
#include "pose_and_vector.h"

namespace halfspace::capi {

template <int D = 2, class View>
void require_view(const View& view, const char* name) {
  if (view.count < 0) {
    refuse(HS_ERROR_ARGUMENT, "%s.count is %lld; it must be >= 0", name, static_cast<long long>(view.count));
  }
  if (view.count == 0) return;
  if (!view.x) refuse(HS_ERROR_ARGUMENT, "%s.x is NULL", name);
  if (!view.y) refuse(HS_ERROR_ARGUMENT, "%s.y is NULL", name);
  if (D == 3 && !view.z) refuse(HS_ERROR_ARGUMENT, "%s.z is NULL", name);
  const bool overlaps = view.count > 1 && view.stride == 0;
  if (view.stride % std::int64_t(sizeof(double)) != 0 || overlaps) {
    refuse(HS_ERROR_ARGUMENT, "%s.stride is %lld; it must be a multiple of 8 bytes and not 0", name,
           static_cast<long long>(view.stride));
  }
}

/// Address of a component of point i; `first` is its address for point 0.
template <class Component>
Component* at(Component* first, std::int64_t stride, std::int64_t i) {
  return first + i * (stride / std::int64_t(sizeof(double)));
}

template <int D = 2>
Vector<D> read_point(const hs_view& view, std::int64_t i) {
  if constexpr (D == 2) {
    return {*at(view.x, view.stride, i), *at(view.y, view.stride, i)};
  } else {
    return {*at(view.x, view.stride, i), *at(view.y, view.stride, i), *at(view.z, view.stride, i)};
  }
}

template <int D = 2>
Vector<D> read_finite_point(const hs_view& view, std::int64_t i, const char* name) {
  const Vector<D> p = read_point<D>(view, i);
  for (const double component : p) {
    if (!is_within_limits(component)) {
      refuse(HS_ERROR_ARGUMENT, "%s[%lld] is %s; it must be finite and at most 1e75", name,
             static_cast<long long>(i), PointText(p).characters);
    }
  }
  return p;
}

/// All points of a view, each by read(i).
template <int D, class Read>
Array<Vector<D>> read_points(Memory* memory, const hs_view& view, const char* name, Read&& read) {
  require_view<D>(view, name);
  Array<Vector<D>> points(memory);
  points.reserve(std::size_t(view.count));
  for (std::int64_t i = 0; i < view.count; ++i) points.push_back(read(i));
  return points;
}
template <int D>
Array<Vector<D>> read_points(Memory* memory, const hs_view& view, const char* name) {
  return read_points<D>(memory, view, name, [&](std::int64_t i) { return read_point<D>(view, i); });
}
template <int D>
Array<Vector<D>> read_points(hs_context* context, const hs_view& view, const char* name) {
  return read_points<D>(&context->memory, view, name);
}
template <int D>
Array<Vector<D>> read_finite_points(hs_context* context, const hs_view& view, const char* name) {
  return read_points<D>(&context->memory, view, name,
                        [&](std::int64_t i) { return read_finite_point<D>(view, i, name); });
}

template <class Vector>
void write_point(const hs_mutable_view& view, std::int64_t i, const Eigen::MatrixBase<Vector>& p) {
  *at(view.x, view.stride, i) = p.x();
  *at(view.y, view.stride, i) = p.y();
  if (view.z) *at(view.z, view.stride, i) = z_of(p);
}

/// HS_NOTE_TRUNCATED if `count` exceeds the capacity, else HS_OK.
inline hs_status fits(std::int64_t count, std::int64_t capacity) {
  return count > capacity ? HS_NOTE_TRUNCATED : HS_OK;
}

/// Calls write(i) for as many of `count` entries as fit.
template <class Write>
hs_status write_all(std::int64_t count, std::int64_t capacity, Write&& write) {
  for (std::int64_t i = 0; i < std::min(count, capacity); ++i) write(int(i));
  return fits(count, capacity);
}

}  // namespace halfspace::capi
