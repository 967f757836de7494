#pragma once

// Calls of a fuzzer on compounds, actions, bolts, water, keys, and the pieces of a step.

#include "capi/loads.h"
#include "fuzz/body_calls.h"

namespace halfspace_fuzz {

class LoadCalls : public BodyCalls {
 protected:
  using BodyCalls::BodyCalls;

  void call_of_loads(int which) {
    switch (which) {
      case 0:
        return add_compound();
      case 1:
        return add_table();
      case 2:
      case 3:
        return add_action();
      case 4:
        return add_node_action();
      case 5:
        return hold_block();
      case 6:
        return add_or_remove_bolt();
      case 7:
        return set_water();
      case 8:
        return set_keys();
      default:
        return call_piece();
    }
  }

  bool may_be_planned_ = false;  // snapshots have no plan

  /// Ends what pieces have begun.
  void end_pieces() {
    may_be_planned_ = false;
    (void)hs_world_end_begin(world());
    (void)hs_world_end_step(world());
  }

 private:
  static constexpr std::size_t max_compounds = 2;
  static constexpr std::size_t max_tables = 3;

  std::int32_t any_table() { return bytes_.below(4) - 1; }

  /// Two boxes side by side, sometimes one in the other.
  void add_compound() {
    if (compounds_ >= max_compounds) return;
    const Point3 half = {bytes_.positive(), bytes_.positive(), bytes_.positive()};
    const Shape shape = hull_of(context_, dimension_, box_corners({-half.x, -half.y, -half.z}, half));
    if (!shape) return;
    const hs_shape* const shapes[2] = {shape.get(), shape.get()};
    const hs_pose poses[2] = {pose_at(0, 0), pose_at(bytes_.flag() ? half.x : 2 * half.x, 0)};
    hs_block_def def;
    if (!succeeds_or(hs_compound_def_init(&def, sizeof def, shapes, poses, 2),
                     {HS_ERROR_ARGUMENT, HS_ERROR_GEOMETRY}, "compound_def_init"))
      return;
    def.kind = bytes_.below(3);
    if (bytes_.flag()) def.pose = read_pose(bytes_, dimension_);
    hs_block block = 0;
    if (unless_refused("add_compound",
                       [&] { return hs_world_add_compound(world(), shapes, poses, 2, &def, &block); })) {
      ids_.push_back(block);
      ++compounds_;
    }
  }

  void add_table() {
    if (tables_ >= max_tables) return;
    const double times[2] = {bytes_.positive_or(0), bytes_.positive()};
    const Points3 values = {read_point(bytes_), read_point(bytes_)};
    std::int32_t table = -1;
    if (unless_refused("add_table",
                       [&] { return hs_world_add_table(world(), times, view_of(values), &table); }))
      ++tables_;
  }

  hs_action_def read_action() {
    hs_action_def def;
    hs_action_def_init(&def, sizeof def);
    def.kind = bytes_.below(8);
    def.table = any_table();
    def.place = bytes_.below(4);
    if (bytes_.flag()) read_into(def.scale, bytes_, 3);
    if (bytes_.flag()) read_into(def.point, bytes_, dimension_);
    def.max_speed = bytes_.positive_or(1);
    return def;
  }

  void add_action() {
    const hs_block block = bytes_.below(4) == 0 ? 0 : any_block();
    const hs_action_def def = read_action();
    unless_refused("add_action", [&] {
      return def.kind == 7 ? hs_world_end_actions(world(), block) : hs_world_add_action(world(), block, &def);
    });
  }

  void add_node_action() {
    const hs_body body = any_body();
    const std::int32_t nodes[] = {any_node(), any_node()};
    const Points3 scales = {read_point(bytes_), read_point(bytes_)};
    const hs_action_def def = read_action();
    unless_refused("add_node_action", [&] {
      return def.kind == 7 ? hs_world_end_node_actions(world(), body)
                           : hs_world_add_node_action(world(), body, nodes, view_of(scales), &def);
    });
  }

  void hold_block() {
    const hs_block block = any_block();
    const int axes = bytes_.below(16);
    unless_refused("hold_block", [&] { return hs_world_hold_block(world(), block, axes); });
  }

  void add_or_remove_bolt() {
    const hs_block a = any_block(), b = bytes_.flag() ? any_block() : 0;
    hs_bolt_def def = bolt_def(a, read_point(bytes_), b, read_point(bytes_), 1024 * bytes_.positive());
    if (dimension_ == 2) def.place_a[2] = def.place_b[2] = 0;
    def.pretension = bytes_.positive_or(0);
    def.yield_force = bytes_.positive_or(0);
    def.rupture_elongation = bytes_.positive_or(0);
    std::int64_t number = bytes_.below(3);
    const bool is_removed = bytes_.below(3) == 0;
    unless_refused("bolt", [&] {
      return is_removed ? hs_world_remove_bolt(world(), number) : hs_world_add_bolt(world(), &def, &number);
    });
  }

  void set_water() {
    const hs_water_def def = water_def(bytes_.positive_or(1000));
    const double height = bytes_.number();
    const Points3 table =
        dimension_ == 2 ? Points3{{-64, height, 0}, {64, height, 0}} : Points3{{0, 0, height}};
    const bool is_none = bytes_.flag();
    unless_refused("set_water",
                   [&] { return hs_world_set_water(world(), &def, is_none ? hs_view{} : view_of(table)); });
  }

  void set_keys() {
    std::vector<std::int64_t> keys;
    std::int64_t key = bytes_.raw<std::int8_t>();
    for (std::size_t i = 0; i < blocks_of(world()).size(); ++i) keys.push_back(key += bytes_.below(4) + 1);
    unless_refused("set_keys",
                   [&] { return hs_world_set_keys(world(), keys.data(), std::int64_t(keys.size())); });
  }

  /// One of the pieces of a step, whatever came before it. A refused one changes nothing.
  void call_piece() {
    hs_share_plan plan;
    hs_world* const w = world();
    may_be_planned_ = true;
    switch (bytes_.below(7)) {
      case 0:
        return void(unless_refused("begin", [&] { return hs_world_begin(w); }));
      case 1:
        return void(unless_refused("end_begin", [&] { return hs_world_end_begin(w); }));
      case 2:
        return void(unless_refused("plan_motion", [&] { return hs_world_plan_motion(w, &plan); }));
      case 3:
        return void(unless_refused("renew_list", [&] { return hs_world_renew_list(w, &plan); }));
      case 4:
        return void(unless_refused("move", [&] { return hs_world_move(w); }));
      case 5:
        return void(unless_refused("end_step", [&] { return hs_world_end_step(w); }));
      default:
        return step_in_pieces();
    }
  }

  /// The pieces in their order, with calls between them that the bytes choose.
  void step_in_pieces() {
    if (steps_ >= max_steps) return;
    ++steps_;
    hs_share_plan plan{};
    const auto between = [&] {
      if (bytes_.flag()) call_between_pieces(bytes_.byte());
    };
    unless_refused("begin", [&] { return hs_world_begin(world()); });
    between();
    unless_refused("end_begin", [&] { return hs_world_end_begin(world()); });
    between();
    unless_refused("plan_motion", [&] { return hs_world_plan_motion(world(), &plan); });
    between();
    unless_refused("renew_list", [&] { return hs_world_renew_list(world(), &plan); });
    between();
    unless_refused("move", [&] { return hs_world_move(world()); });
    between();
    end_pieces();
  }

  virtual void call_between_pieces(int byte) = 0;

  std::size_t compounds_ = 0;
  std::size_t tables_ = 0;
};

}  // namespace halfspace_fuzz
