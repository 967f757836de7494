#include "halfspace/impact.h"

#include <cmath>

#include "geometry/deformed_outline.h"
#include "guard.h"
#include "narrow_phase/time_of_impact.h"
#include "pair_arguments.h"
#include "pose_and_vector.h"
#include "require.h"
#include "shape_handle.h"
#include "sized_struct.h"
#include "tensor.h"
#include "write_contact.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace halfspace::capi {

template <>
hs_motion_def default_definition() {
  hs_motion_def def{};
  def.start.rotation[3] = 1;
  def.gradient[0] = def.gradient[4] = def.gradient[8] = 1;
  return def;
}

namespace {

static_assert(HS_IMPACT_NEVER == int(Impact<2>::never) && HS_IMPACT_TOUCH == int(Impact<2>::touches) &&
              HS_IMPACT_AT_START == int(Impact<2>::touching_at_start));

constexpr double largest_turn = 1e6;  // rad

/// The name of a motion's member, "motion_a.velocity".
struct MemberName {
  MemberName(const char* motion, const char* member) {
    std::snprintf(characters, sizeof characters, "%s.%s", motion, member);
  }
  operator const char*() const { return characters; }

  char characters[40];
};

/// Component i of a rate times the duration.
double read_change(const double* rate, int i, double duration, double largest, const char* name) {
  const double change = duration * rate[i];
  if (!(std::abs(change) <= largest)) {
    refuse(HS_ERROR_ARGUMENT, "%s[%d] is %g; times duration it must be at most %g", name, i, rate[i],
           largest);
  }
  return change;
}

template <int D>
Angular<D> read_turn(const double* rate, double duration, const char* name) {
  const auto about = [&](int i) { return read_change(rate, i, duration, largest_turn, name); };
  if constexpr (D == 2) {
    return Angular<2>(about(2));
  } else {
    return {about(0), about(1), about(2)};
  }
}

template <int D>
Sweep<D> read_motion(const hs_motion_def* given, double duration, const char* name) {
  const hs_motion_def motion = read_definition(given, name);
  const Pose<D> start = read_pose<D>(&motion.start, MemberName(name, "start").characters);
  Sweep<D> sweep;
  sweep.position = start.position;
  for (int i = 0; i < D; ++i)
    sweep.way[i] = read_change(motion.velocity, i, duration, largest_number, MemberName(name, "velocity"));
  sweep.turn = read_turn<D>(motion.angular_velocity, duration, MemberName(name, "angular_velocity"));
  const MemberName gradient_name(name, "gradient");
  const Tensor<D> gradient = read_finite_tensor<D>(motion.gradient, gradient_name);
  const Tensor<D> stretch =
      duration * read_finite_tensor<D>(motion.gradient_rate, MemberName(name, "gradient_rate"));
  require_gradient<D>(gradient, gradient_name);
  require_gradient<D>(gradient + stretch, MemberName(name, "gradient at the end"));
  if (const std::optional<Collapse> collapse = collapse_on_the_way<D>(gradient, stretch)) {
    refuse(HS_ERROR_ARGUMENT,
           "%s.gradient_rate inverts the shape: its volume is %g times the initial volume after a fraction "
           "%g of duration",
           name, collapse->volume, collapse->time);
  }
  sweep.gradient = start.rotation.tensor() * gradient;
  sweep.stretch = start.rotation.tensor() * stretch;
  return sweep;
}

template <int D>
void write_impact(const Impact<D>& impact, const Vector<D>& position_of_a, double duration, hs_impact& out) {
  out = {};
  out.state = impact.state;
  out.time = impact.time * duration;
  if (impact.state == Impact<D>::never) return;
  const NamedPair pair = named(impact.pair);
  out.pair_kind = pair.kind;
  out.feature_a = pair.a;
  out.feature_b = pair.b;
  out.gap = impact.gap;
  write_vector(impact.normal, out.normal);
  write_vector(Vector<D>(position_of_a + impact.point), out.point);
}

template <int D>
void find_impact(const hs_shape& a, const hs_motion_def* motion_a, const hs_shape& b,
                 const hs_motion_def* motion_b, double duration, hs_impact& out) {
  const Sweep<D> sweep_of_a = read_motion<D>(motion_a, duration, "motion_a"),
                 sweep_of_b = read_motion<D>(motion_b, duration, "motion_b");
  const Outline<D> outline_of_a = as<D>(a).outline(), outline_of_b = as<D>(b).outline();
  Array<double> room(component_count(outline_of_a) + component_count(outline_of_b), &a.context->memory);
  const Impact<D> impact = time_of_impact(outline_of_a, sweep_of_a, outline_of_b, sweep_of_b, room.data());
  write_impact<D>(impact, sweep_of_a.position + impact.time * sweep_of_a.way, duration, out);
}

}  // namespace
}  // namespace halfspace::capi

hs_status hs_motion_def_init(hs_motion_def* def, size_t size) { return write_definition(def, size); }

hs_status hs_pair_time_of_impact(const hs_shape* shape_a, const hs_motion_def* motion_a,
                                 const hs_shape* shape_b, const hs_motion_def* motion_b, double duration,
                                 hs_impact* impact) {
  return guarded(context_of(shape_a ? shape_a : shape_b), "hs_pair_time_of_impact", [&] {
    require_pointer(shape_a, "shape_a");
    require_pointer(motion_a, "motion_a");
    require_pointer(shape_b, "shape_b");
    require_pointer(motion_b, "motion_b");
    require_pointer(impact, "impact");
    require_one_dimension(*shape_a, "shape_a", *shape_b, "shape_b");
    require(duration >= 0 && std::isfinite(duration), duration, "duration", "finite and >= 0");
    const auto find = shape_a->dimension() == 2 ? find_impact<2> : find_impact<3>;
    find(*shape_a, motion_a, *shape_b, motion_b, duration, *impact);
    return HS_OK;
  });
}
