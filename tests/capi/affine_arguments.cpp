// halfspace/affine.h: every argument of every function that can be wrong, and that nothing has changed
// afterwards.

#include <array>
#include <cstring>
#include <limits>

#include "capi/polyhedra.h"
#include "capi/unchanged.h"

namespace halfspace_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

using Nine = std::array<double, 9>;
constexpr Nine one{1, 0, 0, 0, 1, 0, 0, 0, 1}, none{};

Nine with(Nine values, std::size_t i, double value) {
  values[i] = value;
  return values;
}

/// An affine box beside two rigid ones, of the same material.
struct Boxes : TwoBoxes {
  hs_block affine = 0;

  Boxes() {
    const hs_elasticity_def elasticity = elasticity_def(1e8);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    affine = add_block(context.get(), world.get(), box(-3, 1, -2, 2), HS_BLOCK_AFFINE);
  }
};

/// The same in space, one alone.
struct Solid3D {
  Context context = make_context();
  World world;
  std::int32_t material = -1;
  hs_block affine = 0;

  Solid3D() {
    world = make_world(context.get(), world_def(3));
    require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
    const hs_elasticity_def elasticity = elasticity_def(1e8);
    require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
    const Shape shape = make_polyhedron(context.get(), cube());
    hs_block_def block;
    require_ok(hs_block_def_init(&block, sizeof block, shape.get()), context.get());
    block.kind = HS_BLOCK_AFFINE;
    require_ok(hs_world_add_block(world.get(), shape.get(), &block, &affine), context.get());
  }
};

}  // namespace

TEST_CASE("hs_world_set_elasticity refuses every bad definition") {
  Boxes s;
  hs_world* w = s.world.get();
  using D = hs_elasticity_def;
  std::vector<Spoiled<D>> spoiled = {{"struct_size", "0", [](D& d) { d.struct_size = 0; }},
                                     {"struct_size", "4294967295", [](D& d) { d.struct_size = 0xffffffffu; }},
                                     {"plane", "2", [](D& d) { d.plane = 2; }},
                                     {"plane", "-1", [](D& d) { d.plane = -1; }},
                                     {"young_modulus", "0", [](D& d) { d.young_modulus = 0; }},
                                     {"young_modulus", "-5", [](D& d) { d.young_modulus = -5; }},
                                     {"young_modulus", "nan", [](D& d) { d.young_modulus = nan; }},
                                     {"young_modulus", "inf", [](D& d) { d.young_modulus = inf; }},
                                     {"poisson_ratio", "-1", [](D& d) { d.poisson_ratio = -1; }},
                                     {"poisson_ratio", "0.5", [](D& d) { d.poisson_ratio = 0.5; }},
                                     {"poisson_ratio", "nan", [](D& d) { d.poisson_ratio = nan; }},
                                     {"damping_time", "-1", [](D& d) { d.damping_time = -1; }},
                                     {"damping_time", "nan", [](D& d) { d.damping_time = nan; }},
                                     {"damping_time", "inf", [](D& d) { d.damping_time = inf; }}};
  for (const auto& bad : spoiled) {
    hs_elasticity_def def = elasticity_def(1e8);
    bad.spoil(def);
    check_unchanged(s, "hs_world_set_elasticity",
                    {{bad.member, bad.value, [&] { return hs_world_set_elasticity(w, 0, &def); }}});
  }
  const hs_elasticity_def good = elasticity_def(2e8);
  check_unchanged(
      s, "hs_world_set_elasticity",
      {{"elasticity", "NULL", [&] { return hs_world_set_elasticity(w, 0, nullptr); }},
       {"material", "-1", [&] { return hs_world_set_elasticity(w, -1, &good); }, HS_ERROR_STALE_ID},
       {"material", "1", [&] { return hs_world_set_elasticity(w, 1, &good); }, HS_ERROR_STALE_ID}});
  CHECK(hs_world_set_elasticity(nullptr, 0, &good) == HS_ERROR_ARGUMENT);

  Solid3D solid;
  hs_elasticity_def sheet = good;
  sheet.plane = HS_PLANE_STRESS;
  check_unchanged(solid, "hs_world_set_elasticity",
                  {{"plane", "HS_PLANE_STRAIN in 3D",
                    [&] { return hs_world_set_elasticity(solid.world.get(), 0, &sheet); }}});
}

TEST_CASE("an affine block of a material that is not elastic is refused") {
  TwoBoxes s;
  const Shape shape = make_shape(s.context.get(), box(0, 5, 1, 6));
  hs_block_def def;
  REQUIRE(hs_block_def_init(&def, sizeof def, shape.get()) == HS_OK);
  def.kind = HS_BLOCK_AFFINE;
  hs_block block = 77;
  check_unchanged(
      s, "hs_world_add_block",
      {{"material", "no elasticity",
        [&] { return hs_world_add_block(s.world.get(), shape.get(), &def, &block); }, HS_ERROR_STATE}});
  CHECK(block == 77);
}

TEST_CASE("functions of one affine block refuse bad numbers, what is missing, and blocks of other kinds") {
  Boxes s;
  hs_world* w = s.world.get();
  const hs_block a = s.affine;
  hs_deformation deformation;
  const double traction[3] = {1, 2, 0};
  check_unchanged(s, "hs_world_get_deformation",
                  {{"deformation", "NULL", [&] { return hs_world_get_deformation(w, a, nullptr); }}});
  const auto deform = [&](const Nine& gradient, const Nine& rate) {
    return [&s, gradient, rate] {
      return hs_world_set_deformation(s.world.get(), s.affine, gradient.data(), rate.data());
    };
  };
  check_unchanged(s, "hs_world_set_deformation",
                  {{"gradient", "NULL", [&] { return hs_world_set_deformation(w, a, nullptr, none.data()); }},
                   {"rate", "NULL", [&] { return hs_world_set_deformation(w, a, one.data(), nullptr); }},
                   {"gradient[1]", "nan", deform(with(one, 1, nan), none)},
                   {"gradient[4]", "inf", deform(with(one, 4, inf), none)},
                   {"rate[3]", "nan", deform(one, with(none, 3, nan))},
                   {"gradient[0]", "1e+300", deform(with(one, 0, 1e300), none)},
                   {"rate[3]", "1e+300", deform(one, with(none, 3, 1e300))},
                   {"inverse of gradient", "1e+80", deform(with(one, 0, 1e-80), none)},
                   {"norm of gradient times that of its inverse", "2^40", deform(with(one, 0, 1e-13), none)},
                   {"determinant of gradient", "0", deform(with(one, 0, 0), none)},
                   {"determinant of gradient", "-1", deform(with(one, 4, -1), none)}});
  const auto press = [&](const Nine& stress) {
    return [&s, stress] { return hs_world_set_stress(s.world.get(), s.affine, stress.data()); };
  };
  check_unchanged(s, "hs_world_set_stress",
                  {{"stress", "NULL", [&] { return hs_world_set_stress(w, a, nullptr); }},
                   {"stress[0]", "nan", press(with(none, 0, nan))},
                   {"stress[4]", "-inf", press(with(none, 4, -inf))},
                   {"stress[1]", "symmetric", press(with(none, 1, 3))},
                   {"stress[3]", "symmetric", press(with(with(none, 1, 3), 3, 4))}});
  check_unchanged(s, "hs_world_add_surface_load",
                  {{"traction", "NULL", [&] { return hs_world_add_surface_load(w, a, 0, nullptr); }},
                   {"traction[1]", "nan",
                    [&] {
                      const double bad[3] = {0, nan, 0};
                      return hs_world_add_surface_load(w, a, 0, bad);
                    }},
                   {"face", "-1", [&] { return hs_world_add_surface_load(w, a, -1, traction); }},
                   {"face", "4", [&] { return hs_world_add_surface_load(w, a, 4, traction); }}});

  for (const hs_block other : {s.floor, s.box_on_floor}) {
    const auto refuse = [&](const char* function, std::function<hs_status()> call) {
      check_unchanged(s, function, {{"block", "not affine", call, HS_ERROR_STATE}});
    };
    refuse("hs_world_set_deformation",
           [&] { return hs_world_set_deformation(w, other, one.data(), none.data()); });
    refuse("hs_world_set_stress", [&] { return hs_world_set_stress(w, other, none.data()); });
    refuse("hs_world_add_surface_load", [&] { return hs_world_add_surface_load(w, other, 0, traction); });
    refuse("hs_world_clear_surface_loads", [&] { return hs_world_clear_surface_loads(w, other); });
  }

  const hs_block removed = add_block(s.context.get(), w, box(-5, 5, -4, 6), HS_BLOCK_AFFINE);
  REQUIRE(hs_world_remove_block(w, removed) == HS_OK);
  for (const hs_block bad : {hs_block(0), removed, hs_block(~0ull)}) {
    char id[32];
    std::snprintf(id, sizeof id, "%llx", static_cast<unsigned long long>(bad));
    const auto stale = [&](const char* function, std::function<hs_status()> call) {
      check_unchanged(s, function, {{"block", id, call, HS_ERROR_STALE_ID}});
    };
    stale("hs_world_get_deformation", [&] { return hs_world_get_deformation(w, bad, &deformation); });
    stale("hs_world_set_deformation",
          [&] { return hs_world_set_deformation(w, bad, one.data(), none.data()); });
    stale("hs_world_set_stress", [&] { return hs_world_set_stress(w, bad, none.data()); });
    stale("hs_world_add_surface_load", [&] { return hs_world_add_surface_load(w, bad, 0, traction); });
    stale("hs_world_clear_surface_loads", [&] { return hs_world_clear_surface_loads(w, bad); });
  }

  CHECK(hs_world_get_deformation(nullptr, a, &deformation) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_get_deformations(nullptr, &deformation, 1, nullptr) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_deformation(nullptr, a, one.data(), none.data()) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_set_stress(nullptr, a, none.data()) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_add_surface_load(nullptr, a, 0, traction) == HS_ERROR_ARGUMENT);
  CHECK(hs_world_clear_surface_loads(nullptr, a) == HS_ERROR_ARGUMENT);
}

TEST_CASE("in 2D only what is in the plane is read of a tensor, in space all of it") {
  Boxes flat;
  const Nine beyond = with(with(with(one, 2, nan), 7, inf), 8, -1);
  CHECK(hs_world_set_deformation(flat.world.get(), flat.affine, beyond.data(), beyond.data()) == HS_OK);
  CHECK(hs_world_set_stress(flat.world.get(), flat.affine, beyond.data()) == HS_OK);
  Solid3D solid;
  hs_world* w = solid.world.get();
  const double traction[3] = {0, 0, 0};
  check_unchanged(solid, "hs_world_set_deformation",
                  {{"gradient[2]", "nan",
                    [&] { return hs_world_set_deformation(w, solid.affine, beyond.data(), none.data()); }},
                   {"determinant of gradient", "-1", [&] {
                      return hs_world_set_deformation(w, solid.affine, with(one, 8, -1).data(), none.data());
                    }}});
  check_unchanged(solid, "hs_world_set_stress",
                  {{"stress[7]", "symmetric",
                    [&] { return hs_world_set_stress(w, solid.affine, with(none, 7, 1).data()); }}});
  check_unchanged(solid, "hs_world_add_surface_load",
                  {{"face", "6", [&] { return hs_world_add_surface_load(w, solid.affine, 6, traction); }}});
}

TEST_CASE("hs_world_get_deformations refuses bad arrays, and says when there is too little room") {
  Boxes s;
  hs_world* w = s.world.get();
  hs_deformation all[5];
  check_unchanged(
      s, "hs_world_get_deformations",
      {{"deformations", "NULL", [&] { return hs_world_get_deformations(w, nullptr, 4, nullptr); }},
       {"capacity", "-1", [&] { return hs_world_get_deformations(w, all, -1, nullptr); }}});
  std::int64_t count = 0;
  CHECK(hs_world_get_deformations(w, nullptr, 0, &count) == HS_NOTE_TRUNCATED);
  CHECK(count == 4);
  std::memset(static_cast<void*>(all), 0xee, sizeof all);
  const hs_deformation untouched = all[3];
  CHECK(hs_world_get_deformations(w, all, 3, nullptr) == HS_NOTE_TRUNCATED);
  CHECK(std::memcmp(&all[3], &untouched, sizeof untouched) == 0);
  CHECK(hs_world_get_deformations(w, all, 5, &count) == HS_OK);
}

}  // namespace halfspace_test
