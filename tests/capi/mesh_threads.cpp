// A body of finite elements that several threads step: the same bits for any number of them.

#include <array>
#include <random>
#include <vector>

#include "capi/mesh_words.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

using Bytes = std::vector<unsigned char>;

/// A damped body of some thousand cells that shakes, of two kinds of cells where they fit; then some cells
/// go, and the world goes on from a snapshot.
Bytes after_shaking(std::int32_t threads, int dimension, std::int32_t kind, std::int32_t beside) {
  const hs_context_def context_def = with_threads(threads);
  const Context context = make_context(&context_def);
  hs_world_def def = world_def();
  def.dimension = dimension;
  const World world = make_world(context.get(), def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
  const bool in_space = dimension == 3;
  const int along = in_space ? 12 : 40;
  const MeshWords words = brick(dimension, {1, 1, 1}, {along, along, in_space ? 6 : 1},
                                [&](int cell) { return cell % along < along / 2 ? kind : beside; });
  hs_body_def body_of;
  require_ok(hs_body_def_init(&body_of, sizeof body_of), context.get());
  hs_body body = 0;
  require_ok(hs_world_add_mesh(world.get(), make_mesh(context.get(), words).get(), &body_of, nullptr, &body),
             context.get());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> speed(-1, 1);
  Nodes velocities;
  for (std::size_t i = 0; i < words.nodes.size(); ++i)
    velocities.emplace_back(speed(random), speed(random), speed(random));
  require_ok(hs_world_set_node_velocities(world.get(), body, view_of(velocities)), context.get());
  require_ok(hs_world_step(world.get(), 10), context.get());
  const std::int32_t gone[] = {0, 7, 300};
  Nodes released(words.nodes.size());
  const hs_mutable_view out = {&released[0].x(), &released[0].y(), in_space ? &released[0].z() : nullptr,
                               sizeof(Node), std::int64_t(released.size())};
  require_ok(hs_world_remove_cells(world.get(), body, gone, 3, out), context.get());
  require_ok(hs_world_step(world.get(), 10), context.get());
  const World copy = restored(context.get(), saved(world.get()));
  require_ok(hs_world_step(copy.get(), 10), context.get());
  return saved(copy.get());
}

}  // namespace

TEST_CASE("a body of many cells has the same bits for any number of threads") {
  const std::array<std::int32_t, 3> bodies[] = {{2, HS_CELL_TRIANGLE, HS_CELL_QUAD},
                                                {3, HS_CELL_HEXAHEDRON, HS_CELL_PRISM},
                                                {3, HS_CELL_TETRAHEDRON, HS_CELL_TETRAHEDRON}};
  for (const auto& [dimension, kind, beside] : bodies) {
    INFO(dimension << "D, cells of kinds " << kind << " and " << beside);
    const Bytes alone = after_shaking(1, dimension, kind, beside);
    for (const std::int32_t threads : {2, 3, 8}) {
      const bool same = after_shaking(threads, dimension, kind, beside) == alone;
      CHECK(same);
    }
  }
}

}  // namespace halfspace_test
