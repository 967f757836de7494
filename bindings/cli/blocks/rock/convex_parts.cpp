#include "blocks/rock/convex_parts.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace halfspace::cli {
namespace {

/// Corners of a part, as indices of the polygon's corners, counter-clockwise.
using Loop = std::vector<std::size_t>;

/// The sine of a turn below which a corner is straight.
constexpr double straight = 1e-9;

class Division {
 public:
  explicit Division(std::vector<Point> polygon) : corners_(std::move(polygon)) {
    if (area_normal(corners_)[2] < 0) std::reverse(corners_.begin(), corners_.end());
  }

  std::vector<std::vector<Point>> parts() {
    clip_ears();
    merge();
    std::vector<std::vector<Point>> parts;
    for (const Loop& loop : loops_) {
      std::vector<Point>& part = parts.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (turn_at(loop, i) > straight) part.push_back(corners_[loop[i]]);
      }
    }
    return parts;
  }

 private:
  /// The sine of the left turn at b on the way from a to c.
  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    const Point before = minus(corners_[b], corners_[a]), after = minus(corners_[c], corners_[b]);
    return cross(before, after)[2] / (length(before) * length(after));
  }
  double turn_at(const Loop& loop, std::size_t i) const {
    return turn(loop[(i + loop.size() - 1) % loop.size()], loop[i], loop[(i + 1) % loop.size()]);
  }

  /// No other corner of the rest is in an ear or on its outline.
  bool is_ear(const Loop& rest, std::size_t i) const {
    if (turn_at(rest, i) <= straight) return false;
    const std::size_t n = rest.size();
    const std::size_t ear[] = {rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]};
    return std::none_of(rest.begin(), rest.end(), [&](std::size_t other) {
      if (std::find(std::begin(ear), std::end(ear), other) != std::end(ear)) return false;
      for (int k = 0; k < 3; ++k) {
        const Point edge = minus(corners_[ear[(k + 1) % 3]], corners_[ear[k]]);
        const Point to_other = minus(corners_[other], corners_[ear[k]]);
        if (cross(edge, to_other)[2] < -straight * length(edge) * length(to_other)) return false;
      }
      return true;
    });
  }

  /// The ear with the shortest new edge.
  std::size_t best_ear(const Loop& rest) const {
    std::size_t best = rest.size();
    double shortest = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      const std::size_t n = rest.size();
      const double cut = length(minus(corners_[rest[(i + 1) % n]], corners_[rest[(i + n - 1) % n]]));
      if ((best < n && cut >= shortest) || !is_ear(rest, i)) continue;
      best = i;
      shortest = cut;
    }
    return best;
  }

  void clip_ears() {
    Loop rest;
    for (std::size_t i = 0; i < corners_.size(); ++i) rest.push_back(i);
    while (rest.size() > 3) {
      const std::size_t i = best_ear(rest), n = rest.size();
      if (i == n) break;  // corners on one line up to rounding: the rest is one part
      const std::size_t before = rest[(i + n - 1) % n], after = rest[(i + 1) % n];
      loops_.push_back({before, rest[i], after});
      cuts_.emplace_back(before, after);
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    }
    loops_.push_back(rest);
  }

  /// The loop with an edge from a to b.
  std::optional<std::size_t> loop_along(std::size_t a, std::size_t b) const {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      for (std::size_t i = 0; i < loops_[l].size(); ++i) {
        if (loops_[l][i] == a && loops_[l][(i + 1) % loops_[l].size()] == b) return l;
      }
    }
    return std::nullopt;
  }

  /// A cut joins two ends of an ear: the ear has the edge from `after` to `before`, the other part its
  /// reverse.
  void merge() {
    for (const auto& [before, after] : cuts_) {
      const std::size_t ear = *loop_along(after, before), other = *loop_along(before, after);
      Loop joined = from(loops_[ear], before);
      const Loop rest = from(loops_[other], after);
      joined.insert(joined.end(), rest.begin() + 1, rest.end() - 1);
      bool is_convex = true;
      for (std::size_t i = 0; i < joined.size(); ++i) {
        const bool is_end = joined[i] == before || joined[i] == after;
        if (is_end && turn_at(joined, i) < -straight) is_convex = false;
      }
      if (!is_convex) continue;
      loops_[ear] = std::move(joined);
      loops_.erase(loops_.begin() + static_cast<std::ptrdiff_t>(other));
    }
  }

  /// The loop from one of its corners on.
  static Loop from(Loop loop, std::size_t corner) {
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), corner), loop.end());
    return loop;
  }

  std::vector<Point> corners_;
  std::vector<Loop> loops_;
  std::vector<std::pair<std::size_t, std::size_t>> cuts_;  ///< the ends of each
};

}  // namespace

std::vector<std::vector<Point>> convex_parts(std::vector<Point> polygon) {
  return Division(std::move(polygon)).parts();
}

}  // namespace halfspace::cli
