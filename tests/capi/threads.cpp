// The thread rule: threads with contexts of their own share nothing, and a context may go from thread to
// thread. Here the results are compared; the thread sanitizer sees the rest.

#include <cstring>
#include <functional>
#include <thread>

#include "capi/polyhedra.h"
#include "capi/world_fixture.h"
#include "catch.h"

namespace halfspace_test {
namespace {

using Bytes = std::vector<unsigned char>;

template <class T>
void append(Bytes& bytes, const T& value) {
  const auto* first = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

/// Runs a task in each of several threads at once and waits for all.
void in_threads(int count, const std::function<void(int)>& task) {
  std::vector<std::thread> threads;
  for (int i = 0; i < count; ++i) threads.emplace_back(task, i);
  for (std::thread& thread : threads) thread.join();
}

/// Hulls (qhull's work), cuts, half-spaces, pairs with a cache, and a refusal with its text.
Bytes shapes_and_pairs(unsigned seed) {
  const Context context = make_context();
  Random random(seed);
  Bytes bytes;
  for (int i = 0; i < 5; ++i) {
    const Shape a = make_hull(context.get(), round_points(random, 40));
    const Shape b = make_polyhedron(context.get(), cube(1.5));
    const double at[3] = {0.1, 0, 0}, normal[3] = {1, 2, 3};
    hs_shape *behind = nullptr, *ahead = nullptr;
    require_ok(hs_shape_cut(a.get(), at, normal, &behind, &ahead), context.get());
    const Shape parts[2] = {Shape(behind), Shape(ahead)};
    hs_pair_cache cache{};
    for (int k = 0; k < 10; ++k) {
      const hs_pose pose = pose_at({0.1 * k, 0.3, 1}, {1, 2, 3}, 0.1 * k);
      append(bytes, detect_pair(parts[0].get(), pose_at(Point3{}), b.get(), pose, &cache));
      append(bytes, cache);
    }
  }
  hs_shape* none = nullptr;
  if (hs_polygon_create(context.get(), view_of(Points{{0, 0}, {1, 0}, {0.1 * seed, 0}}), &none) !=
      HS_ERROR_GEOMETRY)
    throw std::runtime_error("a flat polygon was accepted");
  for (const char* c = hs_context_last_error(context.get()); *c; ++c) append(bytes, *c);
  return bytes;
}

/// A heap that falls, goes through a snapshot, and falls on.
Bytes heap(unsigned) {
  const Context context = make_context();
  Pile pile(context.get(), 20);
  require_ok(hs_world_step(pile.world.get(), 100), context.get());
  const Bytes bytes = saved(pile.world.get());
  hs_world* restored = nullptr;
  require_ok(hs_world_restore(context.get(), bytes.data(), bytes.size(), &restored), context.get());
  pile.world.reset(restored);
  require_ok(hs_world_step(pile.world.get(), 100), context.get());
  return saved(pile.world.get());
}

/// Cubes that fall on each other.
Bytes tower(unsigned seed) {
  const Context context = make_context();
  const World world = make_world(context.get(), world_def(3));
  std::int32_t material = -1;
  require_ok(hs_world_add_material(world.get(), 2000, &material), context.get());
  const hs_law_def law = law_def(1e7, 0.5);
  require_ok(hs_world_set_default_law(world.get(), &law), context.get());
  const Shape shape = make_polyhedron(context.get(), cube());
  hs_block_def block_def;
  require_ok(hs_block_def_init(&block_def, sizeof block_def, shape.get()), context.get());
  for (int i = 0; i < 4; ++i) {
    block_def.kind = i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID;
    block_def.pose = pose_at({0.02 * i * seed, 0, 1.05 * i}, {0, 0, 1}, 0.3 * i);
    hs_block block = 0;
    require_ok(hs_world_add_block(world.get(), shape.get(), &block_def, &block), context.get());
  }
  require_ok(hs_world_step(world.get(), 200), context.get());
  return saved(world.get());
}

}  // namespace

TEST_CASE("threads with contexts of their own do not disturb each other") {
  const std::vector<Bytes (*)(unsigned)> tasks = {shapes_and_pairs, heap, tower};
  constexpr int threads = 6;
  std::vector<Bytes> alone(threads), together(threads);
  const auto run = [&](std::vector<Bytes>& results, int i) {
    results[std::size_t(i)] = tasks[std::size_t(i) % tasks.size()](unsigned(i));
  };
  for (int i = 0; i < threads; ++i) run(alone, i);
  in_threads(threads, [&](int i) { run(together, i); });
  for (std::size_t i = 0; i < threads; ++i) {
    const bool same = alone[i] == together[i];
    CHECK(same);
  }
}

TEST_CASE("a context and its world go from one thread to another") {
  const Context context = make_context();
  const Pile pile(context.get(), 20);
  hs_status status[2] = {HS_ERROR_INTERNAL, HS_ERROR_INTERNAL};
  for (hs_status& of_thread : status)
    in_threads(1, [&](int) { of_thread = hs_world_step(pile.world.get(), 50); });
  CHECK(status[0] == HS_OK);
  CHECK(status[1] == HS_OK);

  const Context other = make_context();
  const Pile whole(other.get(), 20);
  require_ok(hs_world_step(whole.world.get(), 100), other.get());
  const bool same = saved(pile.world.get()) == saved(whole.world.get());
  CHECK(same);
}

TEST_CASE("what needs no context may be called by all threads at once") {
  std::vector<hs_status> status(4, HS_ERROR_INTERNAL);
  in_threads(4, [&](int i) {
    hs_world_def world;
    hs_context_def context;
    hs_pair_options options;
    hs_law_def law;
    const bool has_texts = std::strlen(hs_version()) > 0 && std::strlen(hs_status_string(HS_OK)) > 0;
    status[std::size_t(i)] = has_texts && hs_world_def_init(&world, sizeof world, 2) == HS_OK &&
                                     hs_context_def_init(&context, sizeof context) == HS_OK &&
                                     hs_pair_options_init(&options, sizeof options) == HS_OK
                                 ? hs_law_def_init(&law, sizeof law)
                                 : HS_ERROR_INTERNAL;
  });
  for (const hs_status each : status) CHECK(each == HS_OK);
}

}  // namespace halfspace_test
