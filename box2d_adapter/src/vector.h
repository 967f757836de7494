#pragma once

#include <box2d/b2_math.h>

namespace halfspace::box2d {

struct Vector {
  double x = 0;
  double y = 0;

  Vector() = default;
  Vector(double x, double y) : x(x), y(y) {}
  explicit Vector(const b2Vec2& v) : x(v.x), y(v.y) {}
};

inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y}; }
inline Vector operator*(double s, const Vector& a) { return {s * a.x, s * a.y}; }
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

inline b2Vec2 rounded(const Vector& a) { return {float(a.x), float(a.y)}; }

/// A rotation in 2D, as cosine and sine.
struct Turn {
  double cosine = 1;
  double sine = 0;

  Turn inverse() const { return {cosine, -sine}; }
};

inline Vector operator*(const Turn& t, const Vector& v) {
  return {t.cosine * v.x - t.sine * v.y, t.sine * v.x + t.cosine * v.y};
}
inline Turn operator*(const Turn& s, const Turn& t) {
  return {s.cosine * t.cosine - s.sine * t.sine, s.sine * t.cosine + s.cosine * t.sine};
}

}  // namespace halfspace::box2d
