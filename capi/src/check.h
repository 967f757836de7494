#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/rotation.h"
#include "geometry/vector.h"
#include "guard.h"
#include "halfspace/view.h"
#include "simd/two_lanes.h"

namespace halfspace::capi {

/// What a refusal calls an argument: "pose", or "poses[3]" for one of an array. Put into words only then.
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

/// What goes in is no larger, as the coordinates of shapes are: no square is infinite then, nor its product
/// with a mass or a stiffness. False for NaN.
constexpr double largest_number = 1e75;
inline bool is_within_limits(double value) { return std::abs(value) <= largest_number; }

inline double require_finite(double value, const char* name) {
  if (!std::isfinite(value)) refuse(HS_ERROR_ARGUMENT, "%s is %g; it must be finite", name, value);
  return value;
}

/// `range` says in words what `holds` checked.
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

/// A point in words, "(1, 2)".
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

/// No struct of any version is larger: beyond it a size is garbage.
constexpr std::size_t largest_struct = 1u << 16;

/// Fills a caller's struct, whose size tells with which version of it the caller was compiled: as much of
/// ours as it holds, and zeros for what only a later version knows.
template <class Struct>
void write_sized(const Struct& ours, Struct* out, std::size_t size) {
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &ours, std::min(size, sizeof ours));
}

/// The size of a report, refused when it is below that of the report's first version.
inline void require_report_size(std::size_t size, std::size_t first_version) {
  if (size < first_version || size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "size is %zu; it must be that of the struct, from %zu to %zu", size,
           first_version, largest_struct);
  }
}

/// The defaults of a definition, given next to the functions that read it.
template <class Definition>
Definition default_definition();

/// A definition's size tells which version of it the caller was compiled with; a smaller or larger one than
/// ours is met by reading what both know.
template <class Definition>
Definition read_definition(const Definition* given, const char* name) {
  require_pointer(given, name);
  constexpr std::size_t least = 2 * sizeof(std::uint32_t);
  if (given->struct_size < least || given->struct_size > largest_struct) {
    refuse(HS_ERROR_ARGUMENT, "%s.struct_size is %u; fill the definition with its init function", name,
           given->struct_size);
  }
  Definition known = default_definition<Definition>();
  std::memcpy(static_cast<void*>(&known), given, std::min<std::size_t>(given->struct_size, sizeof known));
  known.struct_size = sizeof known;
  return known;
}

/// The init function behind every definition: the defaults, as much of them as the caller's struct holds.
template <class Definition>
hs_status write_definition(Definition* def, std::size_t size) {
  if (!def || size < 2 * sizeof(std::uint32_t) || size > largest_struct) return HS_ERROR_ARGUMENT;
  Definition defaults = default_definition<Definition>();
  defaults.struct_size = static_cast<std::uint32_t>(size);
  write_sized(defaults, def, size);
  return HS_OK;
}

template <int D>
struct Pose {
  Vector<D> position;
  Rotation<D> rotation;
};
using Pose2 = Pose<2>;

/// Says which part of a pose is wrong. Only called when one is.
template <int D>
[[noreturn]] void refuse_pose(const hs_pose& pose, const ArgumentName& argument) {
  const NameText name(argument);
  for (int i = 0; i < D; ++i) {
    const double p = pose.position[i];
    if (!is_within_limits(p)) {
      refuse(HS_ERROR_ARGUMENT, "%s->position[%d] is %g; it must be finite and at most 1e75", name.characters,
             i, p);
    }
  }
  const double* q = pose.rotation;
  refuse(HS_ERROR_ARGUMENT, "%s->rotation is (%.9g, %.9g, %.9g, %.9g); it must be a unit quaternion%s",
         name.characters, q[0], q[1], q[2], q[3], D == 2 ? " that turns about z" : "");
}

/// Quaternions about z as turns, and by how much their squared lengths are off 1. Number is a double, or
/// TwoLanes for those of two poses side by side.
template <class Number>
struct TurnAboutZ {
  CosineAndSine<Number> turn;
  Number fault;
};

template <class Number>
TurnAboutZ<Number> turn_about_z(const Number& z, const Number& w) {
  const Number deficit = 1.0 - (z * z + w * w);
  return {cosine_and_sine(z, w, deficit), magnitude(deficit)};
}

/// Of a quaternion's squared length: of a length off 1 by 1e-6. Other faults of a pose are weighed so that
/// this is their limit, too.
constexpr double largest_fault = 2e-6;
/// Of the squares of a quaternion's x and y: either may be 1e-6.
constexpr double weight_off_axis = 1e6;
/// Of coordinates: nothing unless they come near the 1e75 that shapes may have, and not a number for what is
/// not finite.
constexpr double weight_far_off = largest_fault / largest_number;

inline TurnAboutZ<TwoLanes> turns_about_z(const hs_pose& a, const hs_pose& b) {
  const TwoLanes zw_a = two_at(a.rotation + 2), zw_b = two_at(b.rotation + 2);
  return turn_about_z(firsts(zw_a, zw_b), seconds(zw_a, zw_b));
}

/// Are the x and y of both quaternions 0?
inline bool turn_exactly_about_z(const hs_pose& a, const hs_pose& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  const std::uint64_t any =
      bits(a.rotation[0]) | bits(a.rotation[1]) | bits(b.rotation[0]) | bits(b.rotation[1]);
  return any << 1 == 0;  // without the sign
}

/// False also for NaN.
inline bool is_tolerable(TwoLanes fault) { return fault[0] <= largest_fault && fault[1] <= largest_fault; }

/// By how much a quaternion's squared length is off 1.
inline double fault_of_quaternion(const double q[4]) {
  return magnitude(1.0 - ((q[0] * q[0] + q[1] * q[1]) + (q[2] * q[2] + q[3] * q[3])));
}

template <int D = 2>
Pose<D> read_pose(const hs_pose* pose, const ArgumentName& name);

template <>
inline Pose<2> read_pose(const hs_pose* pose, const ArgumentName& name) {
  require_pointer(pose, name);
  const double x = pose->position[0], y = pose->position[1];
  const double* q = pose->rotation;
  const TurnAboutZ<double> about_z = turn_about_z(q[2], q[3]);
  const double off_axis = q[0] * q[0] + q[1] * q[1];
  const bool is_near = is_within_limits(x) && is_within_limits(y);
  if (!(is_near && about_z.fault + weight_off_axis * off_axis <= largest_fault)) refuse_pose<2>(*pose, name);
  return {{x, y}, {about_z.turn.cosine, about_z.turn.sine}};
}

template <>
inline Pose<3> read_pose(const hs_pose* pose, const ArgumentName& name) {
  require_pointer(pose, name);
  const double *p = pose->position, *q = pose->rotation;
  const bool is_near = is_within_limits(p[0]) && is_within_limits(p[1]) && is_within_limits(p[2]);
  if (!(is_near && fault_of_quaternion(q) <= largest_fault)) refuse_pose<3>(*pose, name);
  return {{p[0], p[1], p[2]}, Rotation<3>::from_quaternion(q)};
}

inline void write_pose(const Vector<3>& position, const Rotation<3>& rotation, hs_pose& pose) {
  for (int i = 0; i < 3; ++i) pose.position[i] = position[i];
  rotation.write_quaternion(pose.rotation);
}

inline void write_pose(const Vector<2>& position, const Rotation<2>& rotation, hs_pose& pose) {
  // Half-angle formulas, from the larger of the two so that no digits cancel.
  const double c = rotation.cosine, s = rotation.sine;
  const double larger = std::sqrt(0.5 * (1 + std::abs(c)));
  const double z = c >= 0 ? 0.5 * s / larger : std::copysign(larger, s);
  const double w = c >= 0 ? larger : 0.5 * std::abs(s) / larger;
  pose = {{position.x(), position.y(), 0}, {0, 0, z, w}};
}

/// The third component, 0 in the plane.
template <class Vector>
double z_of(const Eigen::MatrixBase<Vector>& v) {
  if constexpr (Vector::SizeAtCompileTime == 2) {
    return 0;
  } else {
    return v.z();
  }
}

template <class Vector>
void write_vector(const Eigen::MatrixBase<Vector>& v, double out[3]) {
  out[0] = v.x();
  out[1] = v.y();
  out[2] = z_of(v);
}

}  // namespace halfspace::capi
