#include "oracles/exact_pair.h"

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfspace_test {
namespace {

template <class Number>
struct Complex {
  Number re;
  Number im;
};
template <class N>
Complex<N> operator*(const Complex<N>& a, const Complex<N>& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class N>
Complex<N> operator*(const N& s, const Complex<N>& a) {
  return {s * a.re, s * a.im};
}
template <class N>
Complex<N> operator+(const Complex<N>& a, const Complex<N>& b) {
  return {a.re + b.re, a.im + b.im};
}
template <class N>
Complex<N> operator-(const Complex<N>& a, const Complex<N>& b) {
  return {a.re - b.re, a.im - b.im};
}
template <class N>
Complex<N> conjugate(const Complex<N>& a) {
  return {a.re, N(0) - a.im};
}

/// The turn of a quaternion (z, w) is zeta / |q|^2 with zeta = (w + iz)^2: polynomial but for the common
/// denominator.
template <class N>
struct Turn {
  explicit Turn(const hs_pose& pose) {
    const Complex<N> q{N(pose.rotation[3]), N(pose.rotation[2])};
    zeta = q * q;
    denominator = q.re * q.re + q.im * q.im;
  }
  Complex<N> zeta;
  N denominator;
};

/// Both polygons in the owner's own frame, everything multiplied by the two denominators: polynomials in the
/// input, no division.
template <class N>
class Frame {
 public:
  Frame(const PlacedPolygon& owner, const PlacedPolygon& other)
      : owner_(owner), other_(other), turn_(owner.pose), other_turn_(other.pose) {
    scale_ = turn_.denominator * other_turn_.denominator;
    const Complex<N> back = conjugate(turn_.zeta);
    relative_turn_ = back * other_turn_.zeta;
    const Complex<N> apart = point(other.pose.position[0], other.pose.position[1]) -
                             point(owner.pose.position[0], owner.pose.position[1]);
    apart_ = other_turn_.denominator * (back * apart);
    for (const Point& p : *other.vertices) {
      vertices_.push_back(apart_ +
                          relative_turn_ * (point(p.x, p.y) - point(other.centroid.x, other.centroid.y)));
    }
  }

  /// Outer normal, not normalised: the edge turned by a right angle.
  Complex<N> normal(std::size_t edge) const {
    const Complex<N> along = vertex(edge + 1) - vertex(edge);
    return {along.im, N(0) - along.re};
  }

  /// Least height of the other's vertices over the edge, times |normal| and scale().
  N height(std::size_t edge) const {
    const Complex<N> n = normal(edge);
    const Complex<N> on_edge = scale_ * (vertex(edge) - point(owner_.centroid.x, owner_.centroid.y));
    const auto height_of = [&](const Complex<N>& p) {
      const Complex<N> d = p - on_edge;
      return n.re * d.re + n.im * d.im;
    };
    N least = height_of(vertices_[0]);
    for (std::size_t i = 1; i < vertices_.size(); ++i) {
      const N h = height_of(vertices_[i]);
      if (h < least) least = h;
    }
    return least;
  }

  const N& scale() const { return scale_; }

 private:
  static Complex<N> point(double x, double y) { return {N(x), N(y)}; }
  Complex<N> vertex(std::size_t i) const {
    const Point& p = (*owner_.vertices)[i % owner_.vertices->size()];
    return point(p.x, p.y);
  }

  const PlacedPolygon& owner_;
  const PlacedPolygon& other_;
  Turn<N> turn_;
  Turn<N> other_turn_;
  N scale_;
  Complex<N> relative_turn_;
  Complex<N> apart_;
  std::vector<Complex<N>> vertices_;
};

using Exact = CGAL::Mpzf;

int sign(const Exact& x) { return int(CGAL::sign(x)); }

int largest_sign(const PlacedPolygon& owner, const PlacedPolygon& other) {
  const Frame<Exact> frame(owner, other);
  int largest = -1;
  for (std::size_t e = 0; e < owner.vertices->size(); ++e) largest = std::max(largest, sign(frame.height(e)));
  return largest;
}

long double gap_in(const Frame<long double>& frame, std::size_t edge) {
  const Complex<long double> n = frame.normal(edge);
  return frame.height(edge) / (std::hypot(n.re, n.im) * frame.scale());
}

double bounding_radius(const PlacedPolygon& p) {
  double radius = 0;
  for (const Point& v : *p.vertices)
    radius = std::max(radius, std::hypot(v.x - p.centroid.x, v.y - p.centroid.y));
  return radius;
}

}  // namespace

double extent(const PlacedPolygon& a, const PlacedPolygon& b) {
  return bounding_radius(a) + bounding_radius(b) +
         std::hypot(b.pose.position[0] - a.pose.position[0], b.pose.position[1] - a.pose.position[1]);
}

long double gap_of_edge(const PlacedPolygon& owner, std::size_t edge, const PlacedPolygon& other) {
  return gap_in(Frame<long double>(owner, other), edge);
}

ExactVerdict exact_verdict(const PlacedPolygon& a, const PlacedPolygon& b) {
  // The same count of roundings as in rounding_bound, with the unit roundoff of long double, and room to
  // spare: the differences of doubles that rounding_bound counts once are rounded no more often here.
  const long double accuracy =
      2 * rounding_bound * 0.5L * std::numeric_limits<long double>::epsilon() * extent(a, b);
  ExactVerdict verdict{true, -std::numeric_limits<long double>::infinity(), accuracy, true};
  bool surely_apart = false;
  struct InDoubt {
    const PlacedPolygon* owner;
    const PlacedPolygon* other;
    std::size_t edge;
  };
  std::vector<InDoubt> in_doubt;
  const auto judge = [&](const PlacedPolygon& owner, const PlacedPolygon& other) {
    const Frame<long double> frame(owner, other);
    for (std::size_t e = 0; e < owner.vertices->size(); ++e) {
      const long double gap = gap_in(frame, e);
      verdict.largest_gap = std::max(verdict.largest_gap, gap);
      if (gap > accuracy)
        surely_apart = true;
      else if (gap >= -accuracy)
        in_doubt.push_back({&owner, &other, e});
    }
  };
  judge(a, b);
  judge(b, a);
  if (surely_apart) {
    verdict.touches = false;
    return verdict;
  }
  verdict.filter_was_enough = in_doubt.empty();
  for (const InDoubt& d : in_doubt) {
    if (sign(Frame<Exact>(*d.owner, *d.other).height(d.edge)) > 0) verdict.touches = false;
  }
  return verdict;
}

int sign_of_largest_gap(const PlacedPolygon& a, const PlacedPolygon& b) {
  return std::max(largest_sign(a, b), largest_sign(b, a));
}

}  // namespace halfspace_test
