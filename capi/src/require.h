#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/numbers.h"
#include "geometry/vector.h"
#include "guard.h"

namespace halfspace::capi {

/// The name of an argument in an error text: "pose", or "poses[3]" for an array element. It is formatted on
/// refusal only.
struct ArgumentName {
  ArgumentName(const char* alone) : name(alone) {}
  ArgumentName(const char* array, std::int64_t at) : name(array), index(at) {}

  const char* name;
  std::int64_t index = -1;
};

struct NameText {
  explicit NameText(const ArgumentName& of) {
    const auto index = static_cast<long long>(of.index);
    std::snprintf(characters, sizeof characters, index < 0 ? "%s" : "%s[%lld]", of.name, index);
  }

  char characters[48];
};

inline void require_pointer(const void* pointer, const ArgumentName& name) {
  if (!pointer) refuse(HS_ERROR_ARGUMENT, "%s is NULL", NameText(name).characters);
}

inline double require_finite(double value, const char* name) {
  if (!std::isfinite(value)) refuse(HS_ERROR_ARGUMENT, "%s is %g; it must be finite", name, value);
  return value;
}

/// `range` describes the condition `holds` in the error text.
inline double require(bool holds, double value, const char* name, const char* range) {
  if (!holds) refuse(HS_ERROR_ARGUMENT, "%s is %g; it must be %s", name, value, range);
  return value;
}

inline double require_from_zero(double value, const char* name) {
  return require(value >= 0 && is_within_limits(value), value, name, "from 0 to 1e75");
}
inline double require_above_zero(double value, const char* name) {
  return require(value > 0 && is_within_limits(value), value, name, "above 0 and at most 1e75");
}

inline void require_count(std::int64_t count, const char* name) {
  if (count < 0)
    refuse(HS_ERROR_ARGUMENT, "%s is %lld; it must be >= 0", name, static_cast<long long>(count));
}

/// Refuses a count above 2^bits.
inline void require_numbered(std::int64_t count, const char* name, int bits) {
  require_count(count, name);
  if (count > std::int64_t(1) << bits) {
    refuse(HS_ERROR_ARGUMENT, "%s is %lld; it must be at most 2^%d", name, static_cast<long long>(count),
           bits);
  }
}

/// Component i of an argument.
inline double require_component(double value, const char* name, int i) {
  if (!is_within_limits(value))
    refuse(HS_ERROR_ARGUMENT, "%s[%d] is %g; it must be finite and at most 1e75", name, i, value);
  return value;
}

/// A point as text, "(1, 2)".
struct PointText {
  template <int D>
  explicit PointText(const Eigen::Matrix<double, D, 1>& p) {
    int length = 0;
    for (int i = 0; i < D; ++i)
      length += std::snprintf(characters + length, sizeof characters - std::size_t(length), "%s%.17g",
                              i == 0 ? "(" : ", ", p[i]);
    std::snprintf(characters + length, sizeof characters - std::size_t(length), ")");
  }

  char characters[96];
};

/// Refuses points. The text names point `faulty` or, if that is below 0, all points as `whole`.
template <int D>
[[noreturn]] void refuse_points(const Array<Vector<D>>& points, std::int64_t faulty, const char* name,
                                const char* whole, const char* fault) {
  if (faulty < 0) refuse(HS_ERROR_GEOMETRY, "%s (%zu points) %s", whole, points.size(), fault);
  refuse(HS_ERROR_GEOMETRY, "%s[%lld] = %s %s", name, static_cast<long long>(faulty),
         PointText(points[std::size_t(faulty)]).characters, fault);
}

}  // namespace halfspace::capi
