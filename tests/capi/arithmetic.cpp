// Hosts that have set the processor's floating-point arithmetic otherwise: traps, as Fortran programs have
// them on, or another rounding.

#include <cfenv>
#include <cstring>

#include "capi/meshes.h"
#include "catch.h"

#ifdef __GLIBC__

namespace halfspace_test {
namespace {

/// While it lives the first invalid operation, division by zero or overflow ends the test.
class Trapping {
 public:
  Trapping() {
    std::feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(traps);
  }
  ~Trapping() { fedisableexcept(traps); }
  Trapping(const Trapping&) = delete;
  Trapping& operator=(const Trapping&) = delete;

 private:
  static constexpr int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
};

struct Kind {
  int dimension;
  std::int32_t law;
  std::int32_t block;
};

hs_block_def block_of(const hs_shape* shape, const Kind& kind, const hs_pose& pose) {
  hs_block_def def;
  hs_block_def_init(&def, sizeof def, shape);
  def.kind = kind.block;
  def.pose = pose;
  return def;
}

/// Blocks stacked on a plate, each a little off the one below; one overlaps none of them and is thrown. For
/// the kind of meshes there are bodies in their place, which stick together.
World stack(hs_context* context, const Kind& kind) {
  hs_world_def def = world_def();
  def.dimension = kind.dimension;
  if (kind.law == HS_STIFFNESS_NONE) def.time_step = 1e-4;  // rigid blocks tell none
  World world = make_world(context, def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context);
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context);
  hs_law_def law = law_def(1e7, 0.5);
  law.stiffness_kind = kind.law;
  law.normal_damping = law.shear_damping = 0.1;
  if (kind.law == HS_STIFFNESS_PER_CONTACT) law.cohesion = law.tensile_strength = 1e3;
  require_ok(hs_world_set_default_law(world.get(), &law), context);
  const Shape unit =
      kind.dimension == 2 ? make_shape(context, box(0, 0, 1, 1)) : make_polyhedron(context, cube());
  for (int i = 0; i < 6; ++i) {
    hs_block_def block = block_of(unit.get(), kind, pose_at(i * .05, i * .999));
    if (i == 0) block.kind = HS_BLOCK_FIXED;
    if (i == 5) block.pose = pose_at({3, 1, 0}, {0, 0, 1}, 0.5);
    hs_block id = 0;
    if (kind.block == HS_BLOCK_MESH && i > 0) {
      const double half = kind.dimension == 2 ? 0 : 0.5;
      add_body(context, world.get(), bar(kind.dimension),
               body_def(pose_at({0, i * 1.0 - 0.5, -half}, {0, 0, 1}, 0)));
      continue;
    }
    require_ok(hs_world_add_block(world.get(), unit.get(), &block, &id), context);
  }
  if (kind.block == HS_BLOCK_MESH) {
    hs_bond_def bond = bond_def(1e9, 1e3);
    bond.tensile_fracture_energy = 1;
    require_ok(hs_world_bond_materials(world.get(), 0, 0, &bond, nullptr), context);
  }
  return world;
}

/// Reads what leaves no trace.
void read_bodies_and_bonds(hs_world* world) {
  hs_balance balance;
  if (hs_world_get_balance(world, &balance, sizeof balance) != HS_OK) throw std::runtime_error("no balance");
  bonds_of(world);
  bond_events_of(world);
  for (const std::uint64_t body : {1, 2, 3, 4, 5}) {
    const hs_body id = (hs_body(1) << 32) | body;
    std::vector<hs_cell_state> cells(std::size_t(state_of_body(world, id).cell_count));
    if (hs_world_get_cells(world, id, cells.data(), std::int64_t(cells.size()), nullptr) != HS_OK)
      throw std::runtime_error("no cells");
  }
}

std::vector<unsigned char> run_stack(const Kind& kind) {
  const Context context = make_context();
  const World world = stack(context.get(), kind);
  require_ok(hs_world_step(world.get(), 200), context.get());
  report_of(world.get());
  if (kind.block == HS_BLOCK_MESH) read_bodies_and_bonds(world.get());
  const World copy = restored(context.get(), saved(world.get()));
  require_ok(hs_world_step(copy.get(), 20), context.get());
  return saved(copy.get());
}

template <class Use>
void for_each_kind(Use use) {
  for (const int dimension : {2, 3})
    for (const std::int32_t law : all_laws)
      for (const std::int32_t block : {HS_BLOCK_RIGID, HS_BLOCK_AFFINE, HS_BLOCK_MESH})
        use(Kind{dimension, law, block});
}

/// Hulls, cuts and detection of what is found there, cold and by a cache.
void make_and_detect() {
  const Context context = make_context();
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Points3 points = round_points(random, 4 + i % 30);
    hs_shape* hull = nullptr;
    require_ok(i % 2 ? hs_polyhedron_create_hull(context.get(), view_of(points), &hull)
                     : hs_polygon_create_hull(context.get(), view_of(points), &hull),
               context.get());
    const Shape whole(hull);
    const Point3 normal = random_direction(random);
    const double at[3] = {0, 0, 0}, across[3] = {normal.x, normal.y, normal.z};
    hs_shape *behind = nullptr, *ahead = nullptr;
    require_ok(hs_shape_cut(whole.get(), at, across, &behind, &ahead), context.get());
    const Shape parts[2] = {Shape(behind), Shape(ahead)};
    hs_pair_cache cache{};
    for (double way = -2.5; way < 2.5; way += 0.0625) {
      const hs_pose pose = pose_at(way, 0, 0.6, 0.8);
      detect_pair(whole.get(), pose_at(0, 0), parts[0].get(), pose, &cache);
      detect_pair(whole.get(), pose_at(0, 0), parts[0].get(), pose);
    }
    // Both parts where the cut left them touch along a whole face.
    detect_pair(parts[0].get(), pose_at(0, 0), parts[1].get(), pose_at(0, 0));
  }
}

/// Shapes with parallel features at places where these line up, or the same shape in the same place.
void detect_aligned(const std::vector<const hs_shape*>& shapes, bool in_plane) {
  const double ways[] = {-1, -0.5, 0, 1e-9, 0.5, 1};
  for (const hs_shape* a : shapes)
    for (const hs_shape* b : shapes)
      for (const double x : ways)
        for (const double y : ways)
          for (const double z : ways)
            for (const double turn : {0.0, 0.5, 1.5707963267948966}) {
              if (in_plane && z != 0) continue;
              hs_pair_cache cache{};
              const hs_pose pose = pose_at({x, y, z}, {0, 0, 1}, turn);
              detect_pair(a, pose_at(0, 0), b, pose, &cache);
              detect_pair(a, pose_at(0, 0), b, pose, &cache);
              detect_pair(a, pose_at(0, 0), b, pose);
            }
}

/// A regular polygon so wide, or the prism on it.
Shape regular(hs_context* context, int sides, double height, double width = 1) {
  Points3 points;
  for (int i = 0; i < sides; ++i) {
    const double angle = 6.283185307179586 * i / sides, x = 0.5 * width * std::cos(angle),
                 y = 0.5 * width * std::sin(angle);
    points.push_back({x, y, -height / 2});
    if (height > 0) points.push_back({x, y, height / 2});
  }
  if (height > 0) return make_hull(context, points);
  hs_shape* polygon = nullptr;
  require_ok(hs_polygon_create_hull(context, view_of(points), &polygon), context);
  return Shape(polygon);
}

}  // namespace

TEST_CASE("floating-point traps of the host are never sprung by pairs that line up") {
  const Context context = make_context();
  for (const double height : {0.0, 1.0}) {
    std::vector<Shape> shapes;
    for (const int sides : {3, 4, 6, 8, 40}) shapes.push_back(regular(context.get(), sides, height));
    std::vector<const hs_shape*> all;
    for (const Shape& s : shapes) all.push_back(s.get());
    const Trapping traps;
    detect_aligned(all, height == 0);
  }
}

TEST_CASE("floating-point traps of the host are never sprung by pairs of any two sizes") {
  const Context context = make_context();
  Random random(11);
  const double sizes[] = {1, 1e-3, 1e-9, 1e-15, 1e-17, 1e-31, 1e-48};
  for (const double height : {0.0, 1.0}) {
    for (const double size : sizes) {
      const Shape large = regular(context.get(), 6, height),
                  small = regular(context.get(), 4, size * height, size);
      const Trapping traps;
      for (int i = 0; i < 400; ++i) {
        const double z = height > 0 ? uniform_between(random, -0.6, 0.6) : 0, tiny = i % 4 == 0 ? 1e-310 : 1;
        const hs_pose pose =
            pose_at({uniform_between(random, -0.6, 0.6) * tiny, uniform_between(random, -0.6, 0.6), z * tiny},
                    {0, 0, 1}, i % 3 * 0.4);
        hs_pair_cache cache{};
        for (int again = 0; again < 2; ++again) {
          detect_pair(large.get(), pose_at(0, 0), small.get(), pose, &cache);
          detect_pair(small.get(), pose, large.get(), pose_at(0, 0));
        }
      }
    }
  }
}

TEST_CASE("floating-point traps of the host are never sprung by a step, whatever the law and the blocks") {
  for_each_kind([](const Kind& kind) {
    INFO(kind.dimension << "D, law " << kind.law << ", blocks of kind " << kind.block);
    const Trapping traps;
    run_stack(kind);
  });
}

TEST_CASE("floating-point traps of the host are never sprung by shapes and pairs") {
  const Trapping traps;
  make_and_detect();
}

TEST_CASE("a host that rounds upwards sees the same bits, and still rounds upwards") {
  for_each_kind([](const Kind& kind) {
    INFO(kind.dimension << "D, law " << kind.law << ", blocks of kind " << kind.block);
    const std::vector<unsigned char> expected = run_stack(kind);
    const Context context = make_context();
    const World world = stack(context.get(), kind);
    std::fesetround(FE_UPWARD);
    const hs_status status = hs_world_step(world.get(), 200);
    const int rounding = std::fegetround();
    std::fesetround(FE_TONEAREST);
    CHECK(status == HS_OK);
    CHECK(rounding == FE_UPWARD);
    const World copy = restored(context.get(), saved(world.get()));
    require_ok(hs_world_step(copy.get(), 20), context.get());
    CHECK((saved(copy.get()) == expected));
  });
}

TEST_CASE("the host's exception flags are as it left them") {
  const Context context = make_context();
  const World world = stack(context.get(), {3, HS_STIFFNESS_PER_AREA, HS_BLOCK_RIGID});
  std::feclearexcept(FE_ALL_EXCEPT);
  std::feraiseexcept(FE_UNDERFLOW);
  const hs_status status = hs_world_step(world.get(), 200);
  const int flags = std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW);
  std::feclearexcept(FE_ALL_EXCEPT);
  CHECK(status == HS_OK);
  CHECK(flags == FE_UNDERFLOW);
}

}  // namespace halfspace_test

#endif
