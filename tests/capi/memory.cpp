// The host's allocator: all memory goes through it, all comes back, a steady step asks for none, and failure
// is survived. The C++ allocator must not be used behind the host's back.

#include "capi/ledger.h"
#include "capi/meshes.h"
#include "catch.h"

namespace halfspace_test {
namespace {

/// Retries a call once after it ran out of memory, which must have left everything as it was.
template <class Call>
void survive(Call call, long& failures) {
  hs_status status = call();
  if (status == HS_ERROR_OUT_OF_MEMORY) {
    ++failures;
    status = call();
  }
  if (status < 0) throw std::runtime_error(hs_status_string(status));
}

/// Everything in space that allocates, once.
void tour_of_polyhedra(hs_context* c, long& failures) {
  Random random(1);
  const Points3 points = round_points(random, 200);  // more edges than fit on a stack, and a Gauss map
  hs_shape* made[6] = {};
  survive([&] { return hs_polyhedron_create_hull(c, view_of(points), &made[0]); }, failures);
  const Shape round(made[0]);
  const Solid solid = cube();
  survive([&] { return create_polyhedron(c, solid, &made[1]); }, failures);
  const Shape box(made[1]);
  const Halfspaces planes = halfspaces_of(box.get());
  survive(
      [&] {
        return hs_polyhedron_create_from_halfspaces(c, view_of(planes.normals), planes.offsets.data(),
                                                    &made[2]);
      },
      failures);
  const Shape common(made[2]);
  survive(
      [&] {
        return hs_polyhedron_create_fitted(c, view_of(points), nullptr, 0, nullptr, 1e-3, &made[5], nullptr);
      },
      failures);
  const Shape fitted(made[5]);
  hs_fault fault;
  survive(
      [&] {
        return hs_polyhedron_check(c, view_of(solid.vertices), solid.faces.sizes.data(), 6,
                                   solid.faces.vertices.data(), &fault);
      },
      failures);
  const double origin[3] = {0.1, 0, 0}, normal[3] = {1, 2, 3};
  survive([&] { return hs_shape_cut(round.get(), origin, normal, &made[3], &made[4]); }, failures);
  const Shape parts[2] = {Shape(made[3]), Shape(made[4])};

  const hs_pose poses[2] = {pose_at({0, 0, 0}), pose_at({0.5, 0.2, 0}, {1, 2, 3}, 0.7)};
  const hs_shape* shapes[2] = {box.get(), round.get()};
  const std::int32_t pairs[2] = {0, 1};
  hs_contact contact;
  survive(
      [&] { return hs_pair_detect(shapes[0], &poses[0], shapes[1], &poses[1], nullptr, nullptr, &contact); },
      failures);
  if (contact.type == HS_CONTACT_NONE) throw std::runtime_error("apart: nothing was asked for");
  survive([&] { return hs_pairs_detect(c, shapes, poses, 2, pairs, 1, nullptr, nullptr, &contact, nullptr); },
          failures);
}

/// Everything that allocates, once; returns the world's state at the end.
std::vector<unsigned char> tour(Ledger& ledger, long& failures) {
  const hs_context_def def = ledger.definition();
  hs_context* c = nullptr;
  survive([&] { return hs_context_create(&def, &c); }, failures);
  const Context context(c);

  Points points;
  for (int i = 0; i < 50; ++i)
    points.push_back({std::cos(0.1256 * i), std::sin(0.1256 * i)});  // more than fit on a stack
  hs_shape* made[4] = {};
  survive([&] { return hs_polygon_create(c, view_of(points), &made[0]); }, failures);
  const Shape round(made[0]);
  survive([&] { return hs_polygon_create_hull(c, view_of(points), &made[1]); }, failures);
  const Shape hull(made[1]);
  const double origin[3] = {0.1, 0, 0}, normal[3] = {1, 2, 0};
  survive([&] { return hs_shape_cut(round.get(), origin, normal, &made[2], &made[3]); }, failures);
  const Shape parts[2] = {Shape(made[2]), Shape(made[3])};
  Points cleaned(points.size());
  std::int64_t count = 0;
  survive([&] { return hs_polygon_clean(c, view_of(points), 0, mutable_view_of(cleaned), &count, nullptr); },
          failures);
  hs_fault fault;
  survive([&] { return hs_polygon_check(c, view_of(points), &fault); }, failures);

  const hs_pose poses[2] = {pose_at(0, 0), pose_at(0.5, 0.2, 0.6, 0.8)};
  const hs_shape* shapes[2] = {round.get(), hull.get()};
  const std::int32_t pairs[2] = {0, 1};
  hs_contact contact;
  survive(
      [&] { return hs_pair_detect(shapes[0], &poses[0], shapes[1], &poses[1], nullptr, nullptr, &contact); },
      failures);
  survive([&] { return hs_pairs_detect(c, shapes, poses, 2, pairs, 1, nullptr, nullptr, &contact, nullptr); },
          failures);

  tour_of_polyhedra(c, failures);

  const hs_world_def settings = world_def();
  hs_world* w = nullptr;
  survive([&] { return hs_world_create(c, &settings, &w); }, failures);
  const World world(w);
  std::int32_t material = -1;
  survive([&] { return hs_world_add_material(w, 1000, &material); }, failures);
  survive([&] { return hs_world_add_material(w, 2000, &material); }, failures);
  const hs_law_def law = law_def(1e7, 0.5);
  survive([&] { return hs_world_set_default_law(w, &law); }, failures);
  survive([&] { return hs_world_set_law(w, 0, 1, &law); }, failures);
  hs_block_def block_def;
  require_ok(hs_block_def_init(&block_def, sizeof block_def, round.get()), c);
  hs_block block = 0;
  for (int i = 0; i < 5; ++i) {
    block_def.kind = i == 0 ? HS_BLOCK_FIXED : HS_BLOCK_RIGID;
    block_def.material = i % 2;
    block_def.pose.position[1] = 2.0 * i * 0.999;
    survive([&] { return hs_world_add_block(w, round.get(), &block_def, &block); }, failures);
  }
  survive([&] { return hs_world_detect(w, nullptr); }, failures);
  for (int i = 0; i < 300; ++i) survive([&] { return hs_world_step(w, 1); }, failures);
  survive([&] { return hs_world_remove_block(w, block); }, failures);
  survive([&] { return hs_world_add_block(w, hull.get(), &block_def, &block); }, failures);
  for (int i = 0; i < 20; ++i) survive([&] { return hs_world_step(w, 1); }, failures);

  std::vector<unsigned char> bytes;
  survive(
      [&] {
        std::size_t size = 0;
        (void)hs_world_save(w, nullptr, 0, &size);
        bytes.assign(size, 0);
        return hs_world_save(w, bytes.data(), size, &size);
      },
      failures);
  hs_world* copy = nullptr;
  survive([&] { return hs_world_restore(c, bytes.data(), bytes.size(), &copy); }, failures);
  const World restored(copy);
  survive([&] { return hs_world_step(copy, 10); }, failures);
  return saved(copy);
}

}  // namespace

TEST_CASE("all memory comes from the host's allocator and goes back to it") {
  Ledger ledger;
  long failures = 0;
  tour(ledger, failures);
  CHECK(failures == 0);
  CHECK(ledger.allocations > 10);
  CHECK(ledger.mismatches == 0);
  CHECK(ledger.bytes_in_use() == 0);
}

TEST_CASE("any one allocation may fail: a status, no leak, nothing changed, and the next try succeeds") {
  Ledger undisturbed;
  long none = 0;
  const std::vector<unsigned char> expected = tour(undisturbed, none);
  for (long n = 0; n < undisturbed.allocations; ++n) {
    Ledger ledger;
    ledger.fail_at = n;
    long failures = 0;
    INFO("allocation " << n << " of " << undisturbed.allocations << " fails");
    std::vector<unsigned char> got;
    CHECK_NOTHROW(got = tour(ledger, failures));
    CHECK(failures == 1);
    const bool ends_the_same = got == expected;
    CHECK(ends_the_same);
    CHECK(ledger.mismatches == 0);
    CHECK(ledger.bytes_in_use() == 0);
  }
  std::printf("allocations failed one by one: %ld\n", undisturbed.allocations);
}

/// Runs a steady world for some seconds: neighbour lists are built anew, but no memory is asked for. Returns
/// the number of its contacts.
std::int64_t run_without_memory(hs_context* context, hs_world* world, double seconds, const Ledger& ledger) {
  const hs_world_report before = report_of(world);
  const long allocations = ledger.allocations, news = calls_of_new;
  run(context, world, seconds);
  const long asked = ledger.allocations - allocations, asked_of_new = calls_of_new - news;
  const hs_world_report after = report_of(world);
  std::printf(
      "%lld steps, %lld rebuilds, %lld contacts: %ld allocations by the host's allocator, %ld by operator "
      "new\n",
      (long long)(after.steps - before.steps), (long long)(after.list_builds - before.list_builds),
      (long long)after.contact_count, asked, asked_of_new);
  CHECK(after.list_builds > before.list_builds);
  CHECK(asked == 0);
  CHECK(asked_of_new == 0);
  return after.contact_count;
}

TEST_CASE("a steady step asks for no memory, rebuilds of the neighbour list included") {
  Ledger ledger;
  const hs_context_def def = ledger.definition();
  const Context context = make_context(&def);
  const Pile pile(context.get(), 60);
  // A prescribed block that turns in the heap for ever wears the neighbour list's skin out again and again,
  // high enough to crush no block on the floor.
  const hs_block stirrer =
      add_block(context.get(), pile.world.get(), box(-0.7, 1.45, 0.7, 1.75), HS_BLOCK_PRESCRIBED);
  hs_world* w = pile.world.get();
  const double standing[3] = {0, 0, 0}, turning[3] = {0, 0, 1};
  require_ok(hs_world_set_velocity(w, stirrer, standing, turning), context.get());
  run(context.get(), w, 12);  // at rest but for what is stirred, and every array as long as it gets
  CHECK(run_without_memory(context.get(), w, 2, ledger) > 30);  // stirred ever anew
}

TEST_CASE("a steady step of affine blocks that meet by potentials asks for no memory") {
  Ledger ledger;
  const hs_context_def def = ledger.definition();
  const Context context = make_context(&def);
  const World world = make_world(context.get(), world_def());
  hs_world* w = world.get();
  std::int32_t material = -1;
  require_ok(hs_world_add_material(w, 2000, &material), context.get());
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
  require_ok(hs_world_set_elasticity(w, material, &elasticity), context.get());
  hs_law_def law = law_def(1e8, 0);
  law.stiffness_kind = HS_STIFFNESS_POTENTIAL;
  law.normal_damping = 0.2;
  require_ok(hs_world_set_default_law(w, &law), context.get());
  // Two blocks glide along on one another, beside a spinning one that meets nothing.
  add_block(context.get(), w, box(-5, -1, 50, 0), HS_BLOCK_FIXED);
  const double gliding[3] = {3, 0, 0}, turning[3] = {0, 0, 5}, standing[3] = {0, 0, 0};
  for (const double y : {0.0, 1.0}) {
    const hs_block block = add_block(context.get(), w, box(0, y, 2, y + 1), HS_BLOCK_AFFINE);
    require_ok(hs_world_set_velocity(w, block, gliding, standing), context.get());
  }
  const hs_block spinner = add_block(context.get(), w, box(-3, 9, -2, 10), HS_BLOCK_AFFINE);
  require_ok(hs_world_set_velocity(w, spinner, standing, turning), context.get());
  run(context.get(), w, 0.3);
  CHECK(run_without_memory(context.get(), w, 0.7, ledger) == 2);
}

TEST_CASE("a steady step of bodies and bonds asks for no memory") {
  Ledger ledger;
  const hs_context_def def = ledger.definition();
  const Context context = make_context(&def);
  const World world = make_world(context.get(), world_def());
  hs_world* w = world.get();
  const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
  for (std::int32_t material : {0, 1}) {
    require_ok(hs_world_add_material(w, 2000, &material), context.get());
    require_ok(hs_world_set_elasticity(w, material, &elasticity), context.get());
  }
  hs_law_def law = law_def(1e9, 0);
  law.stiffness_kind = HS_STIFFNESS_PER_AREA;
  require_ok(hs_world_set_default_law(w, &law), context.get());
  // Two bars that hold together glide along on a floor, and a bond fails at once.
  add_block(context.get(), w, box(-5, -1, 50, 0), HS_BLOCK_FIXED, 1);
  hs_body_def gliding = body_def();
  gliding.velocity[0] = 3;
  for (const double y : {0.0, 1.0}) {
    gliding.pose.position[1] = y;
    add_body(context.get(), w, bar(2), gliding);
  }
  hs_bond_def bond = bond_def(1e10, 1e9);
  std::int64_t bonds = 0;
  require_ok(hs_world_bond_materials(w, 0, 0, &bond, &bonds), context.get());
  CHECK(bonds > 0);
  const hs_block wall = add_block(context.get(), w, box(30, 4, 31, 5), HS_BLOCK_FIXED, 1);
  const hs_block brittle = add_block(context.get(), w, box(31, 4, 32, 5), HS_BLOCK_RIGID, 1);
  bond = bond_def(1e10, 0);
  require_ok(hs_world_bond_blocks(w, wall, brittle, &bond), context.get());
  run(context.get(), w, 0.3);
  CHECK(!bond_events_of(w).empty());
  CHECK(run_without_memory(context.get(), w, 0.7, ledger) > 0);
}

TEST_CASE("a steady step without springs asks for no memory") {
  for (const int dimension : {2, 3}) {
    Ledger ledger;
    const hs_context_def def = ledger.definition();
    const Context context = make_context(&def);
    hs_world_def of_world = world_def();
    of_world.dimension = dimension;
    of_world.gravity[1] = -9.81;
    of_world.gravity[2] = 0;
    const World world = make_world(context.get(), of_world);
    hs_world* w = world.get();
    std::int32_t material = 0;
    const hs_elasticity_def elasticity = elasticity_def(1e8, 1e-4);
    require_ok(hs_world_add_material(w, 2000, &material), context.get());
    require_ok(hs_world_set_elasticity(w, material, &elasticity), context.get());
    hs_law_def law = law_def(1e9, 0.1);
    law.stiffness_kind = HS_STIFFNESS_NONE;
    require_ok(hs_world_set_default_law(w, &law), context.get());
    const Shape floor = dimension == 2 ? make_shape(context.get(), box(-50, -100, 50, 0))
                                       : make_polyhedron(context.get(), cube(100));
    hs_block_def fixed;
    require_ok(hs_block_def_init(&fixed, sizeof fixed, floor.get()), context.get());
    fixed.kind = HS_BLOCK_FIXED;
    fixed.pose.position[1] = -50;
    hs_block block = 0;
    require_ok(hs_world_add_block(w, floor.get(), &fixed, &block), context.get());
    hs_body_def gliding = body_def();
    gliding.velocity[0] = 3;
    for (const double y : {0.0, 1.0}) {
      gliding.pose.position[1] = y;
      add_body(context.get(), w, bar(dimension), gliding);
    }
    run(context.get(), w, 0.3);
    CHECK_FALSE(contacts_of(w).empty());
    CHECK(run_without_memory(context.get(), w, 0.7, ledger) >= 0);
  }
}

}  // namespace halfspace_test
