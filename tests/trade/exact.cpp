#include "exact.h"

#include <cmath>
#include <cstddef>

namespace halfspace_trade {
namespace {

Quaternion product(const Quaternion& p, const Quaternion& q) {
  const auto& [a, b, c, d] = p;
  const auto& [x, y, z, w] = q;
  return {d * x + a * w + b * z - c * y, d * y - a * z + b * w + c * x, d * z + a * y - b * x + c * w,
          d * w - a * x - b * y - c * z};
}

/// Turn and spin about the body's own axes.
struct Turning {
  Quaternion turn{0, 0, 0, 1};
  Vector spin{};
};

Turning operator+(Turning p, const Turning& q) {
  for (std::size_t i = 0; i < 4; ++i) p.turn[i] += q.turn[i];
  for (std::size_t i = 0; i < 3; ++i) p.spin[i] += q.spin[i];
  return p;
}

Turning operator*(double s, Turning p) {
  for (double& x : p.turn) x *= s;
  for (double& x : p.spin) x *= s;
  return p;
}

Turning rate(const Turning& at, const Vector& inertia) {
  const auto& [x, y, z] = at.spin;
  const auto& [a, b, c] = inertia;
  Turning rate;
  rate.turn = product(at.turn, {x / 2, y / 2, z / 2, 0});
  rate.spin = {(b - c) * y * z / a, (c - a) * z * x / b, (a - b) * x * y / c};
  return rate;
}

}  // namespace

RockingSlab::RockingSlab(double width, double height, double tilt)
    : slenderness_(std::atan(width / height)),
      rate_squared_(0.75 * gravity / (0.5 * std::hypot(width, height))),
      tilt_(tilt) {}

double RockingSlab::spin_at(double tilt) const {
  return std::sqrt(2 * rate_squared_ * (std::cos(slenderness_ - tilt_) - std::cos(slenderness_ - tilt)));
}

// The integrand is smooth where the slab is let go with the tilt as tilt_ (1 - u^2).
double RockingSlab::time_to_impact() const {
  const auto integrand = [&](double u) { return 2 * tilt_ * u / spin_at(tilt_ * (1 - u * u)); };
  constexpr int panels = 20000;
  double sum = 0;
  for (int i = 0; i < panels; ++i) sum += integrand((i + 0.5) / panels);
  return sum / panels;
}

double RockingSlab::tilt_after_impact() const {
  const double kept = 1 - 1.5 * std::pow(std::sin(slenderness_), 2);
  const double flat = std::cos(slenderness_);
  return slenderness_ - std::acos(flat + kept * kept * (std::cos(slenderness_ - tilt_) - flat));
}

Quaternion turned_freely(const Body& body, double time) {
  const Vector inertia = mass_of(body, 3).inertia;
  constexpr int steps = 200000;
  const double h = time / steps;
  Turning at{{0, 0, 0, 1}, body.spin};  // as the body's axes are those of space at the start
  for (int i = 0; i < steps; ++i) {
    const Turning k1 = rate(at, inertia), k2 = rate(at + (h / 2) * k1, inertia),
                  k3 = rate(at + (h / 2) * k2, inertia), k4 = rate(at + h * k3, inertia);
    at = at + (h / 6) * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return at.turn;
}

double angle_between(const Quaternion& p, const Quaternion& q) {
  const Quaternion turn = product({-p[0], -p[1], -p[2], p[3]}, q);
  return 2 * std::atan2(std::hypot(turn[0], turn[1], turn[2]), std::abs(turn[3]));
}

}  // namespace halfspace_trade
