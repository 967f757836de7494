// A world that several threads step: the same bits for any number of them, and with the host's own.

#include <future>

#include "capi/snapshot_worlds.h"
#include "catch.h"

namespace halfspace_test {
namespace {

using Bytes = std::vector<unsigned char>;

struct Kind {
  int dimension;
  std::int32_t stiffness;
  std::int32_t block;
};

/// Blocks between walls, enough for several chunks of pairs, that fall onto each other; some are fast.
Bytes after_steps(const hs_context_def& context_def, const Kind& kind, std::int64_t steps) {
  const Context context = make_context(&context_def);
  Random random(11);
  hs_world_def def = world_def();
  def.dimension = kind.dimension;
  const World world = make_world(context.get(), def);
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
  require_ok(hs_world_set_elasticity(world.get(), material, &elasticity), context.get());
  hs_law_def law = law_def(1e6, 0.5);
  law.stiffness_kind = kind.stiffness;
  law.normal_damping = law.shear_damping = 0.1;
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  const bool in_space = kind.dimension == 3;
  const int across = in_space ? 6 : 33;
  for (int i = 0; i < across * across * (in_space ? 30 : 1); ++i) {
    const int column = i % across, row = i / across % across, layer = i / (across * across);
    const Shape shape = shape_of(context.get(), kind.dimension, 9, random);
    hs_block_def block;
    require_ok(hs_block_def_init(&block, sizeof block, shape.get()), context.get());
    block.kind = row == 0                                    ? HS_BLOCK_FIXED
                 : i % 3 == 0 && kind.block != HS_BLOCK_MESH ? kind.block
                                                             : HS_BLOCK_RIGID;
    block.material = material;
    block.pose = pose_at({0.8 * column, 0.8 * row, 0.8 * layer}, {0, 0, 1}, 0.3 * i);
    if (kind.block == HS_BLOCK_MESH && row > 0 && i % 9 == 0) {
      add_body(context.get(), world.get(), bar(kind.dimension, 0.35), body_def(block.pose));
      continue;
    }
    if (i == 2 * across) block.velocity[0] = 300;
    hs_block id = 0;
    require_ok(hs_world_add_block(world.get(), shape.get(), &block, &id), context.get());
  }
  require_ok(hs_world_step(world.get(), steps), context.get());
  return saved(world.get());
}

/// All tasks by the C++ library, from the last to the first.
void run_by_host(hs_task* task, std::int32_t count, void* calls) {
  ++*static_cast<int*>(calls);
  std::vector<std::future<void>> futures;
  for (std::int32_t i = count; i-- > 0;)
    futures.push_back(std::async(std::launch::async, hs_task_run, task, i));
  for (std::future<void>& future : futures) future.get();
}

const Kind kinds[] = {
    {2, HS_STIFFNESS_PER_CONTACT, HS_BLOCK_RIGID}, {2, HS_STIFFNESS_PER_AREA, HS_BLOCK_AFFINE},
    {2, HS_STIFFNESS_POTENTIAL, HS_BLOCK_AFFINE},  {3, HS_STIFFNESS_PER_CONTACT, HS_BLOCK_AFFINE},
    {2, HS_STIFFNESS_NONE, HS_BLOCK_AFFINE},       {3, HS_STIFFNESS_NONE, HS_BLOCK_MESH},
    {3, HS_STIFFNESS_PER_AREA, HS_BLOCK_RIGID},    {3, HS_STIFFNESS_POTENTIAL, HS_BLOCK_RIGID},
    {2, HS_STIFFNESS_PER_AREA, HS_BLOCK_MESH},     {3, HS_STIFFNESS_PER_AREA, HS_BLOCK_MESH},
};

}  // namespace

TEST_CASE("a world has the same bits for any number of threads, and with those of the host") {
  for (const Kind& kind : kinds) {
    INFO(kind.dimension << "D, stiffness " << kind.stiffness << ", block kind " << kind.block);
    const Bytes alone = after_steps(with_threads(1), kind, 10);
    for (const std::int32_t threads : {2, 3, 8}) {
      const bool same = after_steps(with_threads(threads), kind, 10) == alone;
      CHECK(same);
    }
    int calls = 0;
    hs_context_def host = with_threads(3);
    host.run_tasks = run_by_host;
    host.scheduler = &calls;
    const bool same = after_steps(host, kind, 10) == alone;
    CHECK(same);
    CHECK(calls > 10);
  }
}

TEST_CASE("a context takes from 1 to 256 threads") {
  for (const std::int32_t threads : {0, -1, 257}) {
    const hs_context_def def = with_threads(threads);
    hs_context* context = nullptr;
    CHECK(hs_context_create(&def, &context) == HS_ERROR_ARGUMENT);
    CHECK(context == nullptr);
  }
  const Context most = make_context([] {
    static const hs_context_def def = with_threads(256);
    return &def;
  }());
  CHECK(most.get() != nullptr);
}

}  // namespace halfspace_test
