#pragma once

// Every function of the C API as one call on a scene, for tests of what holds of all of them.

#include <functional>
#include <string>
#include <vector>

#include "capi/ledger.h"
#include "capi/polyhedra.h"
#include "capi/world_fixture.h"

namespace halfspace_test {

/// What calls write to, but for handles, whose values differ from run to run.
struct Written {
  hs_fault fault;
  hs_clean_report cleaning;
  hs_shape_properties properties;
  hs_contact contact;
  hs_impact impact;
  hs_block blocks[4];
  hs_block_state state;
  hs_deformation deformations[4];
  hs_world_report report;
  hs_pose poses[4];
  double vectors[2][128][3];
  std::int32_t indices[2][512];
  std::int64_t counts[2];
  std::size_t size;
};

/// Handles that calls make, or end.
struct Made {
  Context context;
  Shape shapes[2];
  World world;
};

/// A round block, of more vertices than fit on a stack, on a fixed box; all memory from a ledger.
struct Scene {
  explicit Scene(int dimension);

  int dimension;
  Ledger ledger;
  hs_context_def context_def = ledger.definition();
  Context context = make_context(&context_def);
  Points3 points;  // the round shape's
  Solid solid = cube();
  Halfspaces halfspaces;
  Shape round, box;
  World world;
  hs_block lower = 0, upper = 0;
  hs_pose poses[2];
  std::vector<unsigned char> snapshot;
  Written written;
  Made made;
};

/// When a call takes memory.
enum class Allocates { never, in_the_plane, always };

struct EntryPoint {
  std::string name;
  Allocates allocates;
  std::function<hs_status(Scene&)> call;
  void (*arrange)(Scene&) = nullptr;  // what must have happened before
};

std::vector<EntryPoint> entry_points();

/// A step after changes that leave different things known: contacts, forces, bonds.
std::vector<EntryPoint> steps_of_changed_worlds();

}  // namespace halfspace_test
