#include <algorithm>
#include <cmath>

#include "force/potential/field_force.h"
#include "force/potential/space/placed_block.h"
#include "force/potential/space/plan_lanes.h"
#include "force/potential/space/planned_force.h"
#include "geometry/polyhedron/volume_sums.h"

namespace halfspace {
namespace {

/// Evaluates a plan. A corner of the overlap is the origin, which keeps rounding errors small.
template <class Four>
class Follower {
 public:
  Follower(const PlanCode* plan, const Outline<3>& a, const Outline<3>& b, const Vector<3>& to_b)
      : code_(plan), blocks_{{a, Vector<3>::Zero()}, {b, to_b}} {}

  std::optional<PotentialForce<3>> force() {
    find_planes();
    find_planes_between();
    move_to_first_corner();
    find_corners();
    find_bounds();
    const VolumeAndSpread content = measure();
    // Corners that have merged are on all faces that meet there.
    if (!(content.volume > rounding_ * surface_of_bounds())) return std::nullopt;
    FieldForce<3> by[2];
    for (int owner = 0; owner < 2; ++owner) {
      sound(owner);
      if (!corners_are_where_they_were() || comes_near_others(owner)) return std::nullopt;
      sum_up_cells();
      const double divided = add_cells(owner, by[owner]);
      if (!(std::abs(divided - content.volume) <= 2 * rounding_ * surface_of_bounds())) return std::nullopt;
    }
    PotentialForce<3> force = sum_of<3>(by[0], by[1], blocks_[0].at, blocks_[1].at,
                                        content.moment / content.volume - blocks_[0].at, content.volume);
    force.spread = content.spread;
    return force;
  }

 private:
  using Lanes = Coordinates<Four>;

  PlanCode next() { return *code_++; }

  /// One code of each of the next four entries, of `codes_each` codes each; missing ones repeat the last.
  template <int codes_each>
  [[gnu::always_inline]] FourOf of_next_four(int which, int count = 4) const {
    const PlanCode* const code = code_ + which;
    const int last = count - 1;
    return {code[0], code[codes_each * std::min(1, last)], code[codes_each * std::min(2, last)],
            code[codes_each * std::min(3, last)]};
  }

  [[gnu::always_inline]] LanesOfPlanes<Four> planes(const FourOf& four) const {
    return {four.template lanes<Four>(normal_), four.template lanes<Four>(offset_)};
  }

  void find_planes() {
    Four largest_offset = all_four<Four>(0);
    for (int owner = 0; owner < 2; ++owner) {
      const auto& [outline, at] = blocks_[owner];
      which_matter_[owner] = code_;
      code_ += Outline<3>::padded(outline.face_count()) / 4;
      first_face_[owner] = plane_count_;
      for (int rest = next(); rest > 0; rest -= 4) {
        const FourOf faces = of_next_four<1>(0, rest);
        const Lanes normal = {faces.lanes<Four>(outline.nx), faces.lanes<Four>(outline.ny),
                              faces.lanes<Four>(outline.nz)};
        const Four offset = faces.lanes<Four>(outline.offset);
        normal_.put_four(plane_count_, normal);
        store_four(offset_ + plane_count_, offset + dot_product(normal, all_four<Four>(at)));
        largest_offset = max(largest_offset, offset);
        pass(rest, 1, plane_count_);
      }
    }
    first_face_[2] = plane_count_;
    rounding_ = plan_rounding_followed * plan_size(blocks_[1].at, reduce_max(largest_offset));
  }

  /// Advances past the next four entries of a list, or the rest of it, and counts them.
  void pass(int rest, int codes_each, int& count) {
    const int passed = std::min(rest, 4);
    code_ += codes_each * passed;
    count += passed;
  }

  void find_planes_between() {
    for (int rest = next(); rest > 0; --rest, ++plane_count_) {
      const int p = next(), q = next();
      normal_.put(plane_count_, normal_[p] - normal_[q]);
      offset_[plane_count_] = offset_[p] - offset_[q];
    }
    // Entries after the last plane are translated as well.
    normal_.put_four(plane_count_, Lanes{});
    store_four(offset_ + plane_count_, Four{});
  }

  void move_to_first_corner() {
    const Vector<3> origin = first_corner();
    for (PlacedBlock& block : blocks_) block.at -= origin;
    for (int f = 0; f < plane_count_; f += 4) {
      const Four height = dot_product(normal_.template four_from<Four>(f), all_four<Four>(origin));
      store_four(offset_ + f, load_four<Four>(offset_ + f) - height);
    }
  }

  Vector<3> first_corner() const {
    const PlanCode *of_a = code_, *of_b = of_a + 1 + of_a[0], *others = of_b + 1 + of_b[0];
    if (*of_a > 0) return blocks_[0].outline.vertex(of_a[1]) + blocks_[0].at;
    if (*of_b > 0) return blocks_[1].outline.vertex(of_b[1]) + blocks_[1].at;
    const auto plane = [&](int p) {
      return LanesOfPlanes<double>{{normal_.x[p], normal_.y[p], normal_.z[p]}, offset_[p]};
    };
    const Coordinates<double> corner = meeting(plane(others[1]), plane(others[2]), plane(others[3]));
    return {corner.x, corner.y, corner.z};
  }

  void find_corners() {
    for (const auto& [outline, at] : blocks_)
      for (int rest = next(); rest > 0; --rest) corners_.put(corner_count_++, outline.vertex(next()) + at);
    for (int rest = next(); rest > 0; rest -= 4) {
      const auto planes_of_corners = [&](int which) __attribute__((always_inline)) {
        return planes(of_next_four<3>(which, rest));
      };
      corners_.put_four(corner_count_,
                        meeting(planes_of_corners(0), planes_of_corners(1), planes_of_corners(2)));
      pass(rest, 3, corner_count_);
    }
    // Lanes after the last corner repeat the first one.
    for (int k = 0; k < 8; k += 4) corners_.put_four(corner_count_ + k, all_four<Four>(corners_[0]));
  }

  void find_bounds() {
    Lanes lower = corners_.template four_from<Four>(0), upper = lower;
    for (int c = 4; c < corner_count_; c += 4) {
      const Lanes here = corners_.template four_from<Four>(c);
      lower = {min(lower.x, here.x), min(lower.y, here.y), min(lower.z, here.z)};
      upper = {max(upper.x, here.x), max(upper.y, here.y), max(upper.z, here.z)};
    }
    const Vector<3> least(reduce_min(lower.x), reduce_min(lower.y), reduce_min(lower.z));
    const Vector<3> most(reduce_max(upper.x), reduce_max(upper.y), reduce_max(upper.z));
    center_ = 0.5 * (least + most);
    half_size_ = most - center_;
  }

  double surface_of_bounds() const {
    const Vector<3>& h = half_size_;
    return 8 * (h.x() * h.y() + h.y() * h.z() + h.z() * h.x());
  }

  /// Volume, moment and spread of the overlap.
  VolumeAndSpread measure() {
    const Vector<3> top = corners_[next()];
    const Lanes tops = all_four<Four>(top);
    SpreadSums<Four> sums;
    for (int rest = next(); rest > 0; rest -= 4, code_ += 12) {
      const auto seen_from_top = [&](int which) __attribute__((always_inline)) {
        return of_next_four<3>(which).template lanes<Four>(corners_) - tops;
      };
      sums.add(seen_from_top(0), seen_from_top(1), seen_from_top(2));
    }
    return with_origin_at(top, sums);
  }

  /// Depths of the corners behind the owner's planes, eight at a time, so that they share a plane's load.
  void sound(int owner) {
    Four shallowest = all_four<Four>(HUGE_VAL), deepest = all_four<Four>(-HUGE_VAL);
    for (int c = 0; c < corner_count_; c += 8) {
      const Lanes corners = corners_.template four_from<Four>(c),
                  others = corners_.template four_from<Four>(c + 4);
      Four least = all_four<Four>(HUGE_VAL), least_of_others = least;
      double* row = depth_ + c;
      for (int plane = first_face_[owner]; plane < first_face_[owner + 1]; ++plane, row += plan_depth(1, 0)) {
        const Lanes normal = all_four<Four>(normal_[plane]);
        const Four offset = all_four<Four>(offset_[plane]);
        const Four depth = offset - dot_product(normal, corners),
                   depth_of_others = offset - dot_product(normal, others);
        store_four(row, depth);
        store_four(row + 4, depth_of_others);
        least = min(depth, least);
        least_of_others = min(depth_of_others, least_of_others);
      }
      const Four rounding = all_four<Four>(rounding_);
      store_four(deepest_if_nearest_ + c, least + rounding);
      store_four(deepest_if_nearest_ + c + 4, least_of_others + rounding);
      shallowest = min(shallowest, min(least, least_of_others));
      deepest = max(deepest, max(least, least_of_others));
    }
    shallowest_ = reduce_min(shallowest);
    deepest_ = reduce_max(deepest);
  }

  /// Is no corner outside, each nearest to the same faces, and those of the overlap on the same ones? Then
  /// the topology is valid, and the cells are those of the owner's faces. NaN fails the test.
  bool corners_are_where_they_were() {
    bool all = shallowest_ >= -rounding_;
    for (int rest = next(); rest > 0; --rest) {
      const int depth = next();
      all &= depth_[depth] <= deepest_if_nearest_[corner_of_plan_depth(depth)];
    }
    for (int rest = next(); rest > 0; --rest) all &= depth_[next()] <= rounding_;
    return all;
  }

  /// By the bounds of the overlap, may a face be relevant now that was not before?
  bool comes_near_others(int owner) const {
    const auto& [outline, at] = blocks_[owner];
    const Lanes center = all_four<Four>(center_ - at), half_size = all_four<Four>(half_size_);
    const Four deepest = all_four<Four>(deepest_);
    const PlanCode* matter = which_matter_[owner];
    int near = 0;
    for (int f = 0; f < outline.face_count(); f += 4, ++matter) {
      const Lanes normal = {load_four<Four>(outline.nx + f), load_four<Four>(outline.ny + f),
                            load_four<Four>(outline.nz + f)};
      const Lanes slope = {abs(normal.x), abs(normal.y), abs(normal.z)};
      const Four depth = load_four<Four>(outline.offset + f) - dot_product(normal, center);
      near |= int(signs_of_four(depth - dot_product(slope, half_size) - deepest)) & ~*matter;
    }
    return near != 0;
  }

  /// Cells of the owner's faces: 24 times the moment, and six times the volume in the last lane.
  void sum_up_cells() {
    cell_count_ = next();
    std::fill_n(cells_, 4 * cell_count_, 0.0);
    for (int rest = next(); rest > 0; rest -= 4, code_ += 20) {
      const auto corners = [&](int which) __attribute__((always_inline)) {
        return of_next_four<5>(which).template lanes<Four>(corners_);
      };
      const Lanes top = corners(1), p = corners(2), q = corners(3), r = corners(4);
      const Four volume = sixfold_volume(p - top, q - top, r - top);
      const Lanes moment = volume * (top + p + q + r);
      Four cells[] = {moment.x, moment.y, moment.z, volume};
      transpose(cells);
      const auto [first, second, third, fourth] = of_next_four<5>(0);
      add_to_cell(first, cells[0]);
      add_to_cell(second, cells[1]);
      add_to_cell(third, cells[2]);
      add_to_cell(fourth, cells[3]);
    }
  }

  [[gnu::always_inline]] void add_to_cell(int face, const Four& moment_and_volume) {
    double* const cell = cells_ + 4 * face;
    store_four(cell, load_four<Four>(cell) + moment_and_volume);
  }

  /// Returns the volume of all cells. The terms of a face are multiples of its normal, row by row: of the
  /// cell, and of its energy.
  double add_cells(int owner, FieldForce<3>& sum) const {
    double volume = 0, energy = 0;
    Four cell_rows[3] = {}, energy_rows[3] = {};
    const double* cell = cells_;
    for (int plane = first_face_[owner], end = plane + cell_count_; plane < end; ++plane, cell += 4) {
      const Vector<3> normal = normal_[plane];
      const double energy_here =
          4 * offset_[plane] * cell[3] - (normal.x() * cell[0] + normal.y() * cell[1] + normal.z() * cell[2]);
      const Four moment_and_volume = load_four<Four>(cell);
      const Four to_foot = all_four<Four>(energy_here) * four_of<Four>(normal.x(), normal.y(), normal.z(), 0);
      for (int i = 0; i < 3; ++i) {
        const Four slope = all_four<Four>(normal[i]);
        cell_rows[i] = cell_rows[i] + slope * moment_and_volume;
        energy_rows[i] = energy_rows[i] + slope * to_foot;
      }
      volume += cell[3];
      energy += energy_here;
    }
    for (int i = 0; i < 3; ++i) {
      sum.force[i] = cell_rows[i][3] / 6;
      for (int k = 0; k < 3; ++k) {
        sum.at_cells(i, k) = cell_rows[i][k] / 24;
        sum.cells_to_feet(i, k) = energy_rows[i][k] / 24;
      }
    }
    sum.energy = energy / 24;
    return volume / 6;
  }

  const PlanCode* code_;
  PlacedBlock blocks_[2];
  const PlanCode* which_matter_[2];
  int first_face_[3];  // of a, of b, and of the planes between faces
  int plane_count_ = 0;
  int corner_count_ = 0;
  int cell_count_;                // of one owner
  Vector<3> center_, half_size_;  // of the overlap
  double rounding_;
  double shallowest_, deepest_;
  Places<most_plan_planes> normal_;
  alignas(32) double offset_[Places<most_plan_planes>::room];
  Places<most_plan_corners> corners_;
  alignas(32) double deepest_if_nearest_[Places<most_plan_corners>::room];
  alignas(32) double depth_[most_plan_faces * most_plan_corners];
  alignas(32) double cells_[4 * Places<most_plan_faces>::room];
};

}  // namespace

std::optional<PotentialForce<3>> follow(std::span<const PlanCode> plan, const Outline<3>& a,
                                        const Outline<3>& b, const Vector<3>& to_b) {
  return with_widest_lanes([&]<class Four>() __attribute__((always_inline)) {
    return Follower<Four>(plan.data(), a, b, to_b).force();
  });
}

}  // namespace halfspace
