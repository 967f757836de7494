#include "blocks/rock/convex_parts.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <queue>
#include <unordered_map>
#include <utility>

#include "blocks/rock/corner_tree.h"
#include "blocks/rock/outline.h"

namespace halfspace::cli {
namespace {

class Division {
 public:
  explicit Division(std::vector<Point> polygon) : corners_(std::move(polygon)) {
    if (area_normal(corners_)[2] < 0) std::reverse(corners_.begin(), corners_.end());
  }

  std::vector<std::vector<Point>> parts() {
    clip_ears();
    merge();
    std::vector<std::vector<Point>> parts;
    for (std::size_t loop = 0; loop < first_of_loop_.size(); ++loop) {
      if (merged_into_[loop] != loop) continue;
      std::vector<Point>& part = parts.emplace_back();
      std::size_t e = first_of_loop_[loop];
      do {
        const std::size_t corner = edges_[e].start;
        const double turn_here = turn(edges_[edges_[e].before].start, corner, end(e));
        if (turn_here < -straight) return {};
        if (turn_here > straight) part.push_back(corners_[corner]);
        e = edges_[e].after;
      } while (e != first_of_loop_[loop]);
    }
    return have_area_of_whole(parts) ? parts : std::vector<std::vector<Point>>{};
  }

 private:
  /// An edge of a part, counter-clockwise, from a corner on.
  struct Edge {
    std::size_t start, loop;
    std::size_t before = 0, after = 0;  ///< edges
  };
  /// The ends of an edge between two ears.
  using Cut = std::pair<std::size_t, std::size_t>;

  /// A corner that may be an ear, by the length of its cut. It counts if its neighbours are still the same.
  struct Candidate {
    double cut;
    std::size_t corner, version;

    bool operator>(const Candidate& other) const {
      return cut > other.cut || (cut == other.cut && corner > other.corner);
    }
  };

  std::size_t end(std::size_t edge) const { return edges_[edges_[edge].after].start; }

  /// The sine of the left turn at b on the way from a to c.
  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    const Point before = minus(corners_[b], corners_[a]), after = minus(corners_[c], corners_[b]);
    return cross(before, after)[2] / (length(before) * length(after));
  }

  /// The straight corners that parts leave out change their area by less than the square of the perimeter
  /// times `straight`.
  bool have_area_of_whole(const std::vector<std::vector<Point>>& parts) const {
    double missing = area_normal(corners_)[2], perimeter = 0;
    for (const std::vector<Point>& part : parts) missing -= area_normal(part)[2];
    for (std::size_t i = 0; i < corners_.size(); ++i)
      perimeter += length(minus(corners_[i], corners_[(i + 1) % corners_.size()]));
    return std::abs(missing) <= straight * perimeter * perimeter;
  }

  /// Clips the ear with the shortest cut until three corners are left. A corner that is no ear, as another
  /// one is in it, waits until that has been clipped.
  void clip_ears() {
    const std::size_t count = corners_.size();
    std::vector<std::size_t> before(count), after(count), version(count, 0);
    std::vector<std::vector<Candidate>> waiting(count);
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates;
    CornerTree rest(corners_);
    const auto propose = [&](std::size_t corner) {
      candidates.push(
          {length(minus(corners_[after[corner]], corners_[before[corner]])), corner, ++version[corner]});
    };
    for (std::size_t i = 0; i < count; ++i) {
      before[i] = (i + count - 1) % count;
      after[i] = (i + 1) % count;
    }
    for (std::size_t i = 0; i < count; ++i) propose(i);
    std::size_t left = count, last = 0;
    while (left > 3 && !candidates.empty()) {
      const Candidate candidate = candidates.top();
      candidates.pop();
      const std::size_t ear = candidate.corner, a = before[ear], c = after[ear];
      if (candidate.version != version[ear] || turn(a, ear, c) <= straight) continue;
      if (const auto inside = rest.corner_in({a, ear, c})) {
        waiting[*inside].push_back(candidate);
        continue;
      }
      add_loop({a, ear, c});
      cuts_.emplace_back(a, c);
      rest.remove(ear);
      --left;
      version[ear] = 0;  // no candidate has it
      after[a] = c;
      before[c] = a;
      propose(a);
      propose(c);
      for (const Candidate& waited : waiting[ear]) candidates.push(waited);
      if (last == ear) last = c;
    }
    // More than three if they are on one line up to rounding.
    std::vector<std::size_t> loop;
    for (std::size_t corner = last; loop.size() < left; corner = after[corner]) loop.push_back(corner);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    add_loop(loop);
  }

  void add_loop(const std::vector<std::size_t>& loop) {
    const std::size_t first = edges_.size(), count = loop.size();
    for (std::size_t i = 0; i < count; ++i) {
      edges_.push_back({.start = loop[i],
                        .loop = first_of_loop_.size(),
                        .before = first + (i + count - 1) % count,
                        .after = first + (i + 1) % count});
    }
    first_of_loop_.push_back(first);
  }

  /// A cut joins two ends of an ear: the ear has the edge from `after` to `before`, the other part its
  /// reverse. Both are merged if they are convex at its ends.
  void merge() {
    merged_into_.resize(first_of_loop_.size());
    std::iota(merged_into_.begin(), merged_into_.end(), std::size_t{0});
    const auto key = [&](std::size_t a, std::size_t b) { return std::uint64_t{a} * corners_.size() + b; };
    std::unordered_map<std::uint64_t, std::size_t> edge_along;
    for (std::size_t e = 0; e < edges_.size(); ++e) edge_along[key(edges_[e].start, end(e))] = e;
    for (const auto& [before, after] : cuts_) {
      Edge& of_ear = edges_[edge_along.at(key(after, before))];
      Edge& of_other = edges_[edge_along.at(key(before, after))];
      if (turn(edges_[of_other.before].start, before, end(of_ear.after)) < -straight ||
          turn(edges_[of_ear.before].start, after, end(of_other.after)) < -straight)
        continue;
      const std::size_t ear = loop_of(of_ear.loop), other = loop_of(of_other.loop);
      merged_into_[other] = ear;
      first_of_loop_[ear] = of_ear.after;
      join(of_ear.before, of_other.after);
      join(of_other.before, of_ear.after);
    }
  }

  void join(std::size_t edge, std::size_t after) {
    edges_[edge].after = after;
    edges_[after].before = edge;
  }

  /// The loop into which one has been merged; the way to it becomes shorter.
  std::size_t loop_of(std::size_t loop) {
    while (merged_into_[loop] != loop) loop = merged_into_[loop] = merged_into_[merged_into_[loop]];
    return loop;
  }

  std::vector<Point> corners_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> first_of_loop_;  ///< edges
  std::vector<std::size_t> merged_into_;    ///< loops
  std::vector<Cut> cuts_;
};

}  // namespace

std::vector<std::vector<Point>> convex_parts(std::vector<Point> polygon) {
  return Division(std::move(polygon)).parts();
}

}  // namespace halfspace::cli
