// Bonds of any stiffness, strength and fracture energy, between blocks of any size, density and speed:
// refused, or such that the world can be stepped, read, saved and restored.

#include "capi/extremes.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

hs_bond_def any_bond(Random& random) {
  hs_bond_def def = bond_def(any_number(random), any_number_or_zero(random));
  def.shear_stiffness = any_number_or_zero(random);
  def.cohesion = any_number_or_zero(random);
  if (random() % 2) def.residual_cohesion = random() % 2 ? def.cohesion : 0.5 * def.cohesion;
  if (random() % 2) def.friction_angle = uniform_between(random, 0, 1.5707963267948965);
  if (random() % 2) def.residual_friction_angle = uniform_between(random, 0, 1.57);
  if (random() % 2) def.tensile_fracture_energy = any_number_or_zero(random);
  if (random() % 2) def.shear_fracture_energy = any_number_or_zero(random);
  return def;
}

/// A row of two boxes; nothing bonded yet.
struct ExtremeRow {
  ExtremeRow(int dimension, Random& random) {
    const double size = any_size(random, dimension == 2 ? -74 : -50, dimension == 2 ? 74 : 50);
    hs_world_def def = world_def(dimension);
    if (random() % 2) def.time_step = any_number(random);
    if (random() % 2) def.gravity[1] = -any_number(random);
    world = make_world(context.get(), def);
    std::int32_t material = -1;
    require_ok(hs_world_add_material(world.get(), any_number(random), &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(any_number(random), any_number_or_zero(random));
    if (hs_world_set_elasticity(world.get(), material, &elasticity) != HS_OK) return;
    hs_law_def law = law_def(any_number(random), 0.5);
    law.stiffness_kind = std::int32_t(random() % 2);
    require_ok(hs_world_set_default_law(world.get(), &law), context.get());
    const double half = 0.5 * size;
    const Shape shape = dimension == 2 ? make_shape(context.get(), box(-half, -half, half, half))
                                       : make_polyhedron(context.get(), cube(size));
    for (int i = 0; i < 2; ++i) {
      hs_block_def block;
      require_ok(hs_block_def_init(&block, sizeof block, shape.get()), context.get());
      block.kind = random() % 2 ? HS_BLOCK_RIGID : HS_BLOCK_AFFINE;
      block.pose.position[0] = i * size;
      if (random() % 2) block.velocity[random() % std::uint64_t(dimension)] = any_number(random);
      if (hs_world_add_block(world.get(), shape.get(), &block, &blocks[i]) != HS_OK) return;
    }
    is_made = true;
  }

  Context context = make_context();
  World world;
  hs_block blocks[2] = {0, 0};
  bool is_made = false;
};

}  // namespace

TEST_CASE("a bond of any stiffness, strength and energy within the limits is refused or can be stepped") {
  Random random(11);
  int made = 0;
  for (int i = 0; i < 1000; ++i) {
    INFO("row " << i);
    ExtremeRow row(2 + i % 2, random);
    const hs_bond_def def = any_bond(random);
    if (!row.is_made) continue;
    INFO("stiffness " << def.normal_stiffness << " and " << def.shear_stiffness << ", strength "
                      << def.tensile_strength << " and " << def.cohesion);
    hs_world* world = row.world.get();
    const std::vector<unsigned char> before = saved(world);
    const hs_status status = hs_world_bond_blocks(world, row.blocks[0], row.blocks[1], &def);
    CHECK((status == HS_OK || status == HS_ERROR_ARGUMENT || status == HS_ERROR_STATE));
    if (status != HS_OK) {
      const bool is_unchanged = saved(world) == before;
      CHECK(is_unchanged);
      continue;
    }
    ++made;
    if (random() % 3 == 0) CHECK(hs_world_hold_bonds(world, 1) == HS_OK);
    if (random() % 3 == 0) {
      const hs_status weakened = hs_world_set_strength_factor(world, any_number(random));
      CHECK((weakened == HS_OK || weakened == HS_ERROR_ARGUMENT));
    }
    check_goes_on(row.context.get(), world, 1);
    check_goes_on(row.context.get(), world, 3);
    check_finite(world);
    check_rest(row.context.get(), world);
    CHECK(bonds_of(world).size() == 1);
  }
  std::printf("bonds at the ends of numbers: %d of 1000 made\n", made);
  CHECK(made > 300);
}

TEST_CASE("a bond too stiff for the mass of a block is refused, by name and value") {
  struct {
    Context context = make_context();
    World world = make_world(context.get(), world_def());
  } s;
  hs_context* c = s.context.get();
  hs_world* w = s.world.get();
  std::int32_t light = -1;
  require_ok(hs_world_add_material(w, 1e-299, &light), c);
  const hs_block one = add_block(c, w, box(0, 0, 1, 1), HS_BLOCK_RIGID);
  const hs_block other = add_block(c, w, box(1, 0, 2, 1), HS_BLOCK_FIXED);
  hs_bond_def across = bond_def(1e-6, 1), along = across;
  across.normal_stiffness = 1e10;
  along.shear_stiffness = 1e11;
  std::int64_t count = 77;
  const auto of_blocks = [&](const hs_bond_def& def) {
    return [&] { return hs_world_bond_blocks(w, one, other, &def); };
  };
  const auto of_materials = [&](const hs_bond_def& def) {
    return [&] { return hs_world_bond_materials(w, light, light, &def, &count); };
  };
  check_unchanged(s, "hs_world_bond_blocks",
                  {{"def.normal_stiffness", "1e+10", of_blocks(across)},
                   {"def.shear_stiffness", "1e+11", of_blocks(along)}});
  check_unchanged(s, "hs_world_bond_materials",
                  {{"def.normal_stiffness", "1e+10", of_materials(across)},
                   {"def.shear_stiffness", "1e+11", of_materials(along)}});
  CHECK(count == 77);
  const hs_bond_def soft = bond_def(1e-6, 1);
  CHECK(hs_world_bond_materials(w, light, light, &soft, &count) == HS_OK);
  CHECK(count == 1);
}

TEST_CASE("factors by which strengths are no more numbers are refused") {
  TwoBoxes s;
  hs_world* w = s.world.get();
  const hs_bond_def def = bond_def(1e8, 1e6);
  add_block(s.context.get(), w, box(3, 3, 4, 4), HS_BLOCK_RIGID);
  REQUIRE(hs_world_bond_materials(w, s.material, s.material, &def, nullptr) == HS_OK);
  const auto set = [&](double factor) { return [=] { return hs_world_set_strength_factor(w, factor); }; };
  check_unchanged(s, "hs_world_set_strength_factor",
                  {{"factor", "1e-303", set(1e-303)},
                   {"factor", "4.94066e-324", set(5e-324)},
                   {"factor", "9e-76", set(9e-76)},
                   {"factor", "1.1e+75", set(1.1e75)}});
  for (const double factor : {1e-75, 1e75, 1e-75, 1.0}) {
    CHECK(hs_world_set_strength_factor(w, factor) == HS_OK);
    check_goes_on(s.context.get(), w, 1);
  }
  hs_strength_report report;
  for (const double low : {1e-310, 9e-76}) {
    hs_strength_def search;
    REQUIRE(hs_strength_def_init(&search, sizeof search) == HS_OK);
    search.low = low;
    check_unchanged(s, "hs_world_find_strength_factor", {{"def.low", low < 1e-300 ? "1e-310" : "9e-76", [&] {
                                                            return hs_world_find_strength_factor(
                                                                w, &search, &report, sizeof report, nullptr);
                                                          }}});
  }
}

}  // namespace halfspace_test
