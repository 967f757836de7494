// halfspace/action.h: every argument of every function that can be wrong, and that nothing has changed
// afterwards.

#include <cstdio>
#include <limits>

#include "capi/action_world.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

std::string hexadecimal(std::uint64_t id) {
  char text[32];
  std::snprintf(text, sizeof text, "%llx", static_cast<unsigned long long>(id));
  return text;
}

/// The texts of numbers that no argument may be.
const std::pair<double, std::string> bad_numbers[] = {{nan, "nan"}, {inf, "inf"}, {1e76, "1e+76"}};

using D = hs_action_def;

/// Definitions of a kind that are refused for a block.
void check_definitions(ActionWorld& s, hs_block block, std::int32_t kind,
                       const std::vector<Spoiled<D>>& spoiled) {
  for (const Spoiled<D>& spoil : spoiled) {
    D def = action_def(kind);
    def.max_speed = 1;
    spoil.spoil(def);
    const auto call = [&] { return hs_world_add_action(s.world.get(), block, &def); };
    check_unchanged(s, "hs_world_add_action", {{spoil.member, spoil.value, call, spoil.status}});
  }
}

/// A block of a kind that cannot follow an action.
void check_cannot_follow(ActionWorld& s, hs_block block, const D& def, const std::string& why) {
  INFO("kind " << def.kind);
  check_unchanged(s, "hs_world_add_action",
                  {{hexadecimal(block), why, [&] { return hs_world_add_action(s.world.get(), block, &def); },
                    HS_ERROR_STATE}});
}

}  // namespace

TEST_CASE("a table refuses rows that are missing, out of order or not finite") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    hs_world* w = s.world.get();
    std::int32_t table = 7;
    const Points3 values(3);
    const hs_view good = view_of(values);
    const std::vector<double> times = {0, 1, 2};
    const auto add = [&](const std::vector<double>& at, hs_view view) {
      return [&, at, view] { return hs_world_add_table(w, at.data(), view, &table); };
    };
    check_unchanged(s, "hs_world_add_table",
                    {{"times", "NULL", [&] { return hs_world_add_table(w, nullptr, good, &table); }},
                     {"table", "NULL", [&] { return hs_world_add_table(w, times.data(), good, nullptr); }},
                     {"values.count", "0", add(times, {})},
                     {"values.count", "-1", add(times, {good.x, good.y, good.z, good.stride, -1})},
                     {"values.x", "NULL", add(times, {nullptr, good.y, good.z, good.stride, 3})},
                     {"values.y", "NULL", add(times, {good.x, nullptr, good.z, good.stride, 3})},
                     {"values.stride", "12", add(times, {good.x, good.y, good.z, 12, 3})},
                     {"values.stride", "0", add(times, {good.x, good.y, good.z, 0, 3})},
                     {"times[1]", "-1", add({0, -1, 2}, good)},
                     {"times[2]", "0.5", add({0, 1, 0.5}, good)},
                     {"times[2]", "1", add({1, 1, 1}, good)}});
    for (const auto& [bad, text] : bad_numbers) {
      check_unchanged(
          s, "hs_world_add_table",
          {{"times[0]", text, add({bad, bad, bad}, good)}, {"times[2]", text, add({0, 1, bad}, good)}});
      for (int k = 0; k < 3; ++k) {
        Points3 spoiled(3);
        (k == 0 ? spoiled[1].x : k == 1 ? spoiled[1].y : spoiled[1].z) = bad;
        check_unchanged(s, "hs_world_add_table",
                        {{"values[1]", bad == 1e76 ? "e+7" : text, add(times, view_of(spoiled))}});
      }
    }
    CHECK(hs_world_add_table(nullptr, times.data(), good, &table) == HS_ERROR_ARGUMENT);
    CHECK(table == 7);
    CHECK(hs_world_add_table(w, times.data(), good, &table) == HS_OK);
    CHECK(table == s.table + 1);
  }
}

TEST_CASE("an action refuses every bad member of its definition") {
  ActionWorld s(3);
  hs_world* w = s.world.get();
  check_unchanged(s, "hs_world_add_action",
                  {{"def", "NULL", [&] { return hs_world_add_action(w, s.rigid, nullptr); }}});
  std::vector<Spoiled<D>> any = {{"struct_size", "0", [](D& d) { d.struct_size = 0; }},
                                 {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
                                 {"def.kind", "-1", [](D& d) { d.kind = -1; }},
                                 {"def.kind", "99", [](D& d) { d.kind = 99; }},
                                 {"def.table", "-1", [](D& d) { d.table = -1; }, HS_ERROR_STALE_ID},
                                 {"def.table", "1", [](D& d) { d.table = 1; }, HS_ERROR_STALE_ID}};
  std::vector<Spoiled<D>> of_force = {{"def.place", "-1", [](D& d) { d.place = -1; }},
                                      {"def.place", "3", [](D& d) { d.place = 3; }}};
  std::vector<Spoiled<D>> of_servo = {
      {"def.max_speed", "0", [](D& d) { d.max_speed = 0; }},
      {"def.max_speed", "-2", [](D& d) { d.max_speed = -2; }},
      {"def.scale", "0", [](D& d) { d.scale[0] = d.scale[1] = d.scale[2] = 0; }}};
  for (const auto& [bad, text] : bad_numbers) {
    any.push_back({"def.start", text, [bad = bad](D& d) { d.start = bad; }});
    of_servo.push_back({"def.max_speed", text, [bad = bad](D& d) { d.max_speed = bad; }});
    for (const int k : {0, 1, 2}) {
      const std::string component = "[" + std::to_string(k) + "]";
      any.push_back({"def.scale" + component, text, [bad = bad, k](D& d) { d.scale[k] = bad; }});
      for (const std::int32_t place : {HS_PLACE_CARRIED, HS_PLACE_FIXED}) {
        of_force.push_back({"def.point" + component, text, [bad = bad, k, place](D& d) {
                              d.place = place;
                              d.point[k] = bad;
                            }});
      }
    }
  }
  check_definitions(s, s.rigid, HS_ACTION_FORCE, any);
  check_definitions(s, 0, HS_ACTION_ACCELERATION, any);
  check_definitions(s, s.affine, HS_ACTION_FORCE, of_force);
  check_definitions(s, s.prescribed, HS_ACTION_SERVO, of_servo);
  ActionWorld plane(2);  // where z gives a servo no direction
  check_definitions(plane, plane.prescribed, HS_ACTION_SERVO,
                    {{"def.scale", "0", [](D& d) { d.scale[0] = d.scale[1] = 0; }}});
  for (std::int32_t kind = HS_ACTION_VELOCITY; kind <= HS_ACTION_SERVO; ++kind) {
    if (kind == HS_ACTION_ACCELERATION) continue;
    check_definitions(s, 0, kind, {{"def.kind", std::to_string(kind), [](D&) {}}});
  }
  const D good = action_def(HS_ACTION_FORCE);
  CHECK(hs_world_add_action(nullptr, s.rigid, &good) == HS_ERROR_ARGUMENT);
}

TEST_CASE("a block that cannot follow an action refuses it") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    hs_block surface = 0;
    hs_block all[64];
    std::int64_t count = 0;
    require_ok(hs_world_get_blocks(s.world.get(), all, 64, &count), s.context.get());
    for (std::int64_t i = 0; i < count; ++i)
      if (state_of(s.world.get(), all[i]).kind == HS_BLOCK_MESH) surface = all[i];
    for (std::int32_t kind = HS_ACTION_VELOCITY; kind <= HS_ACTION_SERVO; ++kind) {
      D def = action_def(kind);
      def.max_speed = 1;
      const bool is_load = kind == HS_ACTION_FORCE || kind == HS_ACTION_TORQUE;
      check_cannot_follow(s, s.fixed, def, is_load ? "neither rigid nor affine" : "is not prescribed");
      check_cannot_follow(s, surface, def, "of a mesh");
      if (is_load) {
        check_cannot_follow(s, s.prescribed, def, "neither rigid nor affine");
      } else {
        check_cannot_follow(s, s.affine, def, "is not prescribed");
        check_cannot_follow(s, s.rigid, def, "hs_world_hold_block()");
      }
    }
    // A motion needs all of its axes held, and a rotation is not among them.
    require_ok(hs_world_hold_block(s.world.get(), s.rigid, HS_AXIS_X | HS_AXIS_ROTATION), s.context.get());
    D def = action_def(HS_ACTION_VELOCITY);
    check_cannot_follow(s, s.rigid, def, "not held along all axes");
    def.scale[1] = def.scale[2] = 0;
    s.act(s.rigid, def);
    check_cannot_follow(s, s.rigid, action_def(HS_ACTION_ANGULAR_VELOCITY), "is not prescribed");
  }
}

TEST_CASE("an action on nodes refuses what they cannot follow and nodes that there are not") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    hs_world* w = s.world.get();
    const std::int32_t count = std::int32_t(bar(dimension).nodes.size());
    const std::int32_t nodes[] = {0, 1}, negative[] = {0, -1}, beyond[] = {count, 0};
    Points3 scales(2, {1, 1, 1});
    const hs_view good = view_of(scales);
    const D force = action_def(HS_ACTION_FORCE);
    const auto add = [&](const std::int32_t* named, hs_view view) {
      return [&, named, view] { return hs_world_add_node_action(w, s.body, named, view, &force); };
    };
    check_unchanged(
        s, "hs_world_add_node_action",
        {{"nodes", "NULL", add(nullptr, good)},
         {"nodes[1]", "-1", add(negative, good)},
         {"nodes[0]", std::to_string(count), add(beyond, good)},
         {"scales.count", "-1", add(nodes, {good.x, good.y, good.z, good.stride, -1})},
         {"scales.x", "NULL", add(nodes, {nullptr, good.y, good.z, good.stride, 2})},
         {"scales.y", "NULL", add(nodes, {good.x, nullptr, good.z, good.stride, 2})},
         {"scales.stride", "12", add(nodes, {good.x, good.y, good.z, 12, 2})},
         {"def", "NULL", [&] { return hs_world_add_node_action(w, s.body, nodes, good, nullptr); }}});
    if (dimension == 3) {
      check_unchanged(s, "hs_world_add_node_action",
                      {{"scales.z", "NULL", add(nodes, {good.x, good.y, nullptr, good.stride, 2})}});
    }
    for (const auto& [bad, text] : bad_numbers) {
      scales[1].y = bad;
      check_unchanged(s, "hs_world_add_node_action",
                      {{"scales[1]", bad == 1e76 ? "e+7" : text, add(nodes, good)}});
    }
    scales[1].y = 1;
    const auto with = [&](std::int32_t kind, std::int32_t table, double start) {
      return [&, kind, table, start] {
        D def = action_def(kind, table);
        def.start = start;
        return hs_world_add_node_action(w, s.body, nodes, good, &def);
      };
    };
    check_unchanged(s, "hs_world_add_node_action",
                    {{"def.kind", "1", with(HS_ACTION_ANGULAR_VELOCITY, 0, 0)},
                     {"def.kind", "3", with(HS_ACTION_ANGULAR_ACCELERATION, 0, 0)},
                     {"def.kind", "5", with(HS_ACTION_TORQUE, 0, 0)},
                     {"def.kind", "6", with(HS_ACTION_SERVO, 0, 0)},
                     {"def.kind", "-1", with(-1, 0, 0)},
                     {"def.start", "nan", with(HS_ACTION_FORCE, 0, nan)},
                     {"def.table", "1", with(HS_ACTION_FORCE, 1, 0), HS_ERROR_STALE_ID}});
    CHECK(hs_world_add_node_action(nullptr, s.body, nodes, good, &force) == HS_ERROR_ARGUMENT);
    CHECK(hs_world_add_node_action(w, s.body, nullptr, {}, &force) == HS_OK);
  }
}

TEST_CASE("only rigid blocks are held, along axes of their dimension") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    hs_world* w = s.world.get();
    const auto hold = [&](hs_block block, std::int32_t axes) {
      return [=] { return hs_world_hold_block(w, block, axes); };
    };
    check_unchanged(s, "hs_world_hold_block",
                    {{"axes", "-1", hold(s.rigid, -1)}, {"axes", "16", hold(s.rigid, 16)}});
    if (dimension == 2) check_unchanged(s, "hs_world_hold_block", {{"axes", "4", hold(s.rigid, HS_AXIS_Z)}});
    for (const hs_block block : {s.fixed, s.prescribed, s.affine}) {
      check_unchanged(s, "hs_world_hold_block",
                      {{hexadecimal(block), "not rigid", hold(block, HS_AXIS_X), HS_ERROR_STATE}});
    }
    CHECK(hs_world_hold_block(nullptr, s.rigid, HS_AXIS_X) == HS_ERROR_ARGUMENT);
  }
}

TEST_CASE("prescribed velocities are set together or not at all") {
  for (const int dimension : {2, 3}) {
    INFO(dimension << "D");
    ActionWorld s(dimension);
    hs_world* w = s.world.get();
    const hs_block second = s.add(HS_BLOCK_PRESCRIBED, -2);
    const hs_block both[] = {s.prescribed, second}, with_rigid[] = {second, s.rigid},
                   with_gone[] = {second, s.gone};
    Points3 velocities(2, {1, 2, 3}), spins(2, {0, 0, 4});
    const hs_view good = view_of(velocities), turns = view_of(spins);
    const auto set = [&](const hs_block* blocks, hs_view linear, hs_view angular) {
      return [=] { return hs_world_prescribe_velocities(w, blocks, linear, angular); };
    };
    check_unchanged(
        s, "hs_world_prescribe_velocities",
        {{"blocks", "NULL", set(nullptr, good, {})},
         {"blocks[1]", hexadecimal(s.rigid), set(with_rigid, good, turns), HS_ERROR_STATE},
         {"blocks", hexadecimal(s.gone), set(with_gone, good, turns), HS_ERROR_STALE_ID},
         {"velocities.count", "-1", set(both, {good.x, good.y, good.z, good.stride, -1}, {})},
         {"velocities.x", "NULL", set(both, {nullptr, good.y, good.z, good.stride, 2}, {})},
         {"velocities.stride", "12", set(both, {good.x, good.y, good.z, 12, 2}, {})},
         {"angular_velocities.count", "1", set(both, good, {turns.x, turns.y, turns.z, turns.stride, 1})},
         {"angular_velocities.count", "-1", set(both, good, {turns.x, turns.y, turns.z, turns.stride, -1})},
         {"angular_velocities.z", "NULL", set(both, good, {turns.x, turns.y, nullptr, turns.stride, 2})},
         {"angular_velocities.stride", "12", set(both, good, {turns.x, turns.y, turns.z, 12, 2})}});
    for (const auto& [bad, text] : bad_numbers) {
      velocities[1].y = bad;
      check_unchanged(s, "hs_world_prescribe_velocities",
                      {{"velocities[1]", bad == 1e76 ? "e+7" : text, set(both, good, turns)}});
      velocities[1].y = 2;
      spins[1].z = bad;
      check_unchanged(s, "hs_world_prescribe_velocities",
                      {{"angular_velocities[1]", bad == 1e76 ? "e+7" : text, set(both, good, turns)}});
      spins[1].z = 4;
    }
    CHECK(hs_world_prescribe_velocities(w, both, good, turns) == HS_OK);
    CHECK(hs_world_prescribe_velocities(w, nullptr, {}, {}) == HS_OK);
    CHECK(hs_world_prescribe_velocities(nullptr, both, good, turns) == HS_ERROR_ARGUMENT);
  }
}

TEST_CASE("prescribed velocities have an energy that sums over blocks can hold") {
  ActionWorld s(2);
  hs_world* w = s.world.get();
  std::int32_t heavy = -1;
  require_ok(hs_world_add_material(w, 1e40, &heavy), s.context.get());
  const hs_block large =
      add_block(s.context.get(), w, box(-5e39, 10, 5e39, 1e40), HS_BLOCK_PRESCRIBED, heavy);
  const hs_block blocks[] = {s.prescribed, large};
  const Points3 velocities(2, {1, 0, 0}), spins(2, {0, 0, 1e60});
  check_unchanged(s, "hs_world_prescribe_velocities", {{"angular_velocity", "1e+60", [&] {
                                                          return hs_world_prescribe_velocities(
                                                              w, blocks, view_of(velocities), view_of(spins));
                                                        }}});
}

TEST_CASE("components that a dimension has not are not read") {
  ActionWorld s(2);
  const Points3 spins(1, {nan, nan, 4});
  const Points3 velocities(1, {1, 2, nan});
  CHECK(hs_world_prescribe_velocities(s.world.get(), &s.prescribed, view_of(velocities), view_of(spins)) ==
        HS_OK);
  CHECK(state_of(s.world.get(), s.prescribed).angular_velocity[2] == 4);
}

TEST_CASE("a stale block or body is refused by every function of actions that takes one") {
  ActionWorld s(2);
  hs_world* w = s.world.get();
  const D def = action_def(HS_ACTION_FORCE);
  for (const hs_block bad : {s.gone, hs_block(99), hs_block(~0ull)}) {
    const auto stale = [&](const char* function, std::function<hs_status()> call) {
      check_unchanged(s, function, {{"block", hexadecimal(bad), call, HS_ERROR_STALE_ID}});
    };
    stale("hs_world_add_action", [&] { return hs_world_add_action(w, bad, &def); });
    stale("hs_world_end_actions", [&] { return hs_world_end_actions(w, bad); });
    stale("hs_world_hold_block", [&] { return hs_world_hold_block(w, bad, HS_AXIS_X); });
  }
  const std::int32_t node = 0;
  const Points3 scales(1);
  for (const hs_body bad : {hs_body(0), s.gone_body, hs_body(99), hs_body(~0ull)}) {
    const auto stale = [&](const char* function, std::function<hs_status()> call) {
      check_unchanged(s, function, {{"body", hexadecimal(bad), call, HS_ERROR_STALE_ID}});
    };
    stale("hs_world_add_node_action",
          [&] { return hs_world_add_node_action(w, bad, &node, view_of(scales), &def); });
    stale("hs_world_end_node_actions", [&] { return hs_world_end_node_actions(w, bad); });
  }
  CHECK(hs_world_end_actions(nullptr, s.rigid) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_end_node_actions(nullptr, s.body) == HS_ERROR_ARGUMENT);
}

}  // namespace halfspace_test
