#pragma once

// Every function of the C API as one call on a scene, for tests of what holds of all of them.

#include <functional>
#include <string>
#include <vector>

#include "capi/ledger.h"
#include "capi/meshes.h"

namespace halfspace_test {

/// What calls write to, but for handles, whose values differ from run to run.
struct Written {
  hs_fault fault;
  hs_clean_report cleaning;
  hs_fit_report fitting;
  hs_shape_properties properties;
  hs_contact contact;
  hs_impact impact;
  hs_ray_hit hits[2];
  hs_closest_points closest;
  hs_block blocks[4];
  hs_block_state state;
  hs_block_state states[4];
  hs_deformation deformations[4];
  hs_world_report report;
  hs_mesh_properties mesh;
  hs_body_state body_state;
  hs_cell_state cells[4];
  hs_bond bonds[2];
  hs_bolt bolts[2];
  hs_note notes[2];
  hs_bond_event events[2];
  hs_bond_report bond_report;
  hs_balance balance;
  hs_strength_report strength;
  hs_share_info share;
  unsigned char packed[1 << 16];
  hs_share_plan plan;
  hs_body body;
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
  Mesh mesh;
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
  Mesh bar;
  World world;
  hs_block lower = 0, upper = 0;
  hs_block beside = 0;  // of the lower one, where there are bonds
  hs_block moved = 0;   // prescribed, where there are actions
  hs_body body = 0;     // where there are bodies
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

/// All of them.
std::vector<EntryPoint> entry_points();
std::vector<EntryPoint> entry_points_of_shapes_and_blocks();
std::vector<EntryPoint> entry_points_of_meshes();
std::vector<EntryPoint> entry_points_of_actions();
std::vector<EntryPoint> entry_points_of_bonds();
std::vector<EntryPoint> entry_points_of_compounds();
std::vector<EntryPoint> entry_points_of_rest();
std::vector<EntryPoint> entry_points_of_loads();
std::vector<EntryPoint> entry_points_of_shares();
std::vector<EntryPoint> entry_points_of_definitions();

/// A step after changes that leave different things known: contacts, forces, bonds.
std::vector<EntryPoint> steps_of_changed_worlds();
/// Calls for worlds with actions whose blocks and nodes come and go.
std::vector<EntryPoint> calls_on_worlds_with_actions();
/// Calls for worlds with bodies and bonds of which some have been removed or have failed.
std::vector<EntryPoint> calls_on_bodies_and_bonds();

// Functions that arrange scenes.

void make_material_elastic(Scene& scene);
void add_body(Scene& scene);
/// A box beside the lower one, which both touch with a whole face.
void add_box_beside(Scene& scene);
void bond_boxes(Scene& scene);

// Functions that make entries.

/// Calls make(&handle) and keeps what it made.
template <class Owner, class Make>
hs_status keep(Owner& owner, Make make) {
  auto* const untouched = reinterpret_cast<typename Owner::pointer>(0x10);
  typename Owner::pointer made = untouched;
  const hs_status status = make(&made);
  if (status == HS_OK) owner.reset(made);
  if (status != HS_OK && made != untouched) throw std::runtime_error("a failed call wrote a handle");
  return status;
}

template <class Def, class Init>
hs_status fill(Init init) {
  Def def;
  return init(&def, sizeof def);
}

inline hs_mutable_view room(Scene& s, int which) {
  double(*v)[3] = s.written.vectors[which];
  return {&v[0][0], &v[0][1], &v[0][2], sizeof v[0], 128};
}

}  // namespace halfspace_test
