// Times of impact: at no sampled time before the one told do the shapes overlap by more than rounding.

#include <algorithm>

#include "fuzz/pair_rounding.h"

namespace halfspace_fuzz {
namespace {

using namespace halfspace_test;
using Real = long double;

struct Quaternion {
  Real x, y, z, w;
};

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y, p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
          p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w, p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z};
}

Quaternion turn_about(const double v[3], Real share) {
  const Real length = std::hypot(Real(v[0]), Real(v[1]), Real(v[2]));
  if (length == 0) return {0, 0, 0, 1};
  const Real s = std::sin(share * length / 2) / length;
  return {s * v[0], s * v[1], s * v[2], std::cos(share * length / 2)};
}

/// The place that the motion has come to, seen from `other`, so that what both share costs no digits.
hs_pose pose_at_time(const hs_motion_def& motion, const hs_motion_def& other, Real time) {
  hs_pose pose;
  for (int i = 0; i < 3; ++i) {
    pose.position[i] = double(Real(motion.start.position[i]) - other.start.position[i] +
                              time * (Real(motion.velocity[i]) - other.velocity[i]));
  }
  const double* q = motion.start.rotation;
  const Real length =
      std::sqrt(Real(q[0]) * q[0] + Real(q[1]) * q[1] + Real(q[2]) * q[2] + Real(q[3]) * q[3]);
  const Quaternion now = product(turn_about(motion.angular_velocity, time),
                                 {q[0] / length, q[1] / length, q[2] / length, q[3] / length});
  const Real components[] = {now.x, now.y, now.z, now.w};
  for (int i = 0; i < 4; ++i) pose.rotation[i] = double(components[i]);
  return pose;
}

struct Moving {
  Shape shape;
  hs_motion_def motion;
};

/// The rounding of a pose on the way, and of the verdict there.
double rounding_on_the_way(const Moving& a, const Moving& b, double time) {
  double way = 0;
  for (int i = 0; i < 3; ++i) {
    way += std::abs(b.motion.start.position[i] - a.motion.start.position[i]) +
           time * std::abs(b.motion.velocity[i] - a.motion.velocity[i]);
  }
  double turned = 0;
  for (const Moving* m : {&a, &b})
    turned += properties_of(m->shape.get()).bounding_radius *
              (1 + time * length(vector_of(m->motion.angular_velocity)));
  hs_pair_options options;
  hs_pair_options_init(&options, sizeof options);
  return rounding_of_gap(a.shape.get(), b.shape.get(), way) + 16 * 0x1p-53 * (way + turned) +
         aside(a.shape.get(), b.shape.get(), options.vertex_zone);
}

bool overlap_at(const Moving& a, const Moving& b, double time, double rounding) {
  const hs_pose at_a = pose_at_time(a.motion, a.motion, time), at_b = pose_at_time(b.motion, a.motion, time);
  hs_contact contact{};
  const hs_status status =
      hs_pair_detect(a.shape.get(), &at_a, b.shape.get(), &at_b, nullptr, nullptr, &contact);
  if (!succeeds_or(status, {HS_ERROR_ARGUMENT}, "detect")) return false;  // farther away than a pose may be
  return touches(contact) && contact.gap < -rounding;
}

Moving read_moving(Bytes& bytes, hs_context* context, int dimension) {
  Moving moving{read_hull(bytes, context, dimension), {}};
  hs_motion_def_init(&moving.motion, sizeof moving.motion);
  moving.motion.start = read_pose(bytes, dimension);
  read_into(moving.motion.velocity, bytes, dimension);
  if (bytes.flag()) return moving;
  const double share = bytes.positive();
  if (dimension == 3) read_into(moving.motion.angular_velocity, bytes, 3);
  moving.motion.angular_velocity[2] = share * bytes.number();
  return moving;
}

void strain(Bytes& bytes, hs_motion_def& motion) {
  for (double& g : motion.gradient) g += bytes.number() / 128;
  for (double& rate : motion.gradient_rate) rate = bytes.number() / 128;
}

void check_impact(const hs_impact& impact, double duration) {
  demand(impact.state >= HS_IMPACT_NEVER && impact.state <= HS_IMPACT_TOUCH, "the state is one of three");
  demand(impact.time >= 0 && impact.time <= duration, "the time is within the duration");
  demand(std::isfinite(impact.gap), "the gap is a number");
  if (impact.state == HS_IMPACT_NEVER) {
    demand(impact.time == duration, "never means all of the duration");
    return;
  }
  demand(std::abs(length(vector_of(impact.normal)) - 1) <= 64 * 0x1p-53, "the normal has unit length");
  for (const double x : impact.point) demand(std::isfinite(x), "shapes touch somewhere");
}

void run(Bytes bytes) {
  const Context context = make_context();
  const int dimension = bytes.between(2, 3);
  Moving a = read_moving(bytes, context.get(), dimension), b = read_moving(bytes, context.get(), dimension);
  if (!a.shape || !b.shape) return;
  const double duration = bytes.positive();
  const bool strains = bytes.below(4) == 0;
  if (strains) strain(bytes, bytes.flag() ? a.motion : b.motion);
  hs_impact impact{};
  const hs_status status =
      hs_pair_time_of_impact(a.shape.get(), &a.motion, b.shape.get(), &b.motion, duration, &impact);
  if (!succeeds_or(status, {HS_ERROR_ARGUMENT}, "time_of_impact")) return;
  check_impact(impact, duration);
  if (strains || impact.state == HS_IMPACT_AT_START) return;
  constexpr int samples = 48;
  for (int i = 0; i < samples; ++i) {
    const double time = impact.time * i / samples;
    demand(!overlap_at(a, b, time, rounding_on_the_way(a, b, impact.time)),
           "no touch is before the one told");
  }
}

}  // namespace
}  // namespace halfspace_fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  halfspace_fuzz::run({data, size});
  return 0;
}
