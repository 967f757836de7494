// Many steps of a world with bodies and bonds, with each of their allocations failing in turn.

#include <algorithm>

#include "capi/seen.h"
#include "catch.h"

namespace halfspace_test {
namespace {

constexpr int max_steps = 12, steps_after = 3;

/// A call that makes so many steps.
struct Run {
  std::string name;
  hs_status (*call)(Scene&, int steps);
  void (*arrange)(Scene&);
};

hs_block add_box(Scene& s, double x) {
  hs_block_def def;
  require_ok(hs_block_def_init(&def, sizeof def, s.box.get()), s.context.get());
  def.pose.position[0] = x;
  hs_block block = 0;
  require_ok(hs_world_add_block(s.world.get(), s.box.get(), &def, &block), s.context.get());
  return block;
}

/// Two bonded boxes are torn off the lower one, and a body flies against the upper one: pairs come and go,
/// and a bond comes apart.
void tear_and_hit(Scene& s) {
  make_material_elastic(s);
  add_box_beside(s);
  const hs_block behind = add_box(s, -2);
  const hs_bond_def weak = bond_def(1e8, 1e3), strong = bond_def(1e8, 1e9);
  require_ok(hs_world_bond_blocks(s.world.get(), s.lower, s.beside, &weak), s.context.get());
  require_ok(hs_world_bond_blocks(s.world.get(), s.beside, behind, &strong), s.context.get());
  const double away[3] = {-20, 1, 0}, still[3] = {};
  for (const hs_block block : {s.beside, behind})
    require_ok(hs_world_set_velocity(s.world.get(), block, away, still), s.context.get());
  hs_body_def def = body_def(pose_at(1.2, 0));
  def.velocity[0] = -20;
  s.body = add_body(s.context.get(), s.world.get(), bar(s.dimension), def);
}

/// The same on the way, ready for the next step.
void tear_and_hit_damped(Scene& s) {
  tear_and_hit(s);
  require_ok(hs_world_set_damping(s.world.get(), 0.2, 3), s.context.get());
  require_ok(hs_world_step(s.world.get(), 2), s.context.get());
}

hs_status step(Scene& s, int steps) { return hs_world_step(s.world.get(), steps); }

hs_status relax(Scene& s, int steps) {
  const hs_relaxation_def def = relaxation_def(steps, 1e-30);
  const hs_status status = hs_world_relax(s.world.get(), &def, nullptr, 0);
  return status == HS_NOTE_NOT_AT_REST ? HS_OK : status;
}

std::unique_ptr<Scene> scene_for(const Run& run, int dimension) {
  auto scene = std::make_unique<Scene>(dimension);
  run.arrange(*scene);
  return scene;
}

/// Looked up in a copy: a report is not to be what brings the world up to date.
std::int64_t steps_of(const Scene& s) {
  const World copy = restored(s.context.get(), saved(s.world.get()));
  return report_of(copy.get()).steps;
}

/// The view after some steps, and the whole state that some more have led to.
struct Course {
  std::vector<unsigned char> seen, end;
};

std::vector<unsigned char> end_of(const Scene& scene, hs_world* world) {
  require_ok(hs_world_step(world, steps_after), scene.context.get());
  return saved(world);
}

Course course_of(const Run& run, int dimension, int steps) {
  const std::unique_ptr<Scene> scene = scene_for(run, dimension);
  if (steps > 0) require_ok(run.call(*scene, steps), scene->context.get());
  Course course;
  course.seen = seen(*scene);
  course.end = end_of(*scene, scene->world.get());
  return course;
}

/// Fails allocation n: how many steps were made then, or all of them when there is no such allocation.
std::int64_t survives_failure(const Run& run, int dimension, long n, const std::vector<Course>& courses) {
  const std::unique_ptr<Scene> scene = scene_for(run, dimension);
  const std::int64_t first = steps_of(*scene);
  scene->ledger.fail_at = scene->ledger.allocations + n;
  const hs_status status = run.call(*scene, max_steps);
  const bool failed = scene->ledger.allocations > scene->ledger.fail_at;
  scene->ledger.fail_at = -1;
  CHECK(status == (failed ? HS_ERROR_OUT_OF_MEMORY : HS_OK));
  const std::int64_t made = steps_of(*scene) - first;
  REQUIRE((made >= 0 && made <= max_steps));
  INFO("after step " << made);
  const Course& undisturbed = courses[std::size_t(made)];
  const bool is_at_whole_step = seen(*scene) == undisturbed.seen;
  CHECK(is_at_whole_step);
  const World copy = restored(scene->context.get(), saved(scene->world.get()));
  const bool copy_goes_on = end_of(*scene, copy.get()) == undisturbed.end;
  CHECK(copy_goes_on);
  const bool goes_on = end_of(*scene, scene->world.get()) == undisturbed.end;
  CHECK(goes_on);
  return failed ? made : max_steps;
}

/// Fails each allocation in turn. Returns how many steps have been made at most before one failed.
std::int64_t survive_every_failure(const Run& run, int dimension) {
  std::vector<Course> courses;
  for (int steps = 0; steps <= max_steps; ++steps) courses.push_back(course_of(run, dimension, steps));
  std::int64_t most_made = 0;
  for (long n = 0;; ++n) {
    INFO(run.name << " in " << dimension << "D, allocation " << n << " fails");
    const std::int64_t made = survives_failure(run, dimension, n, courses);
    if (made == max_steps) return most_made;
    most_made = std::max(most_made, made);
  }
}

}  // namespace

TEST_CASE("any allocation on the way may fail, of steps and of a relaxation with bodies and bonds") {
  std::int64_t most_made = 0;
  for (const int dimension : {2, 3}) {
    for (const Run& run : {Run{"steps of a changed world", step, tear_and_hit},
                           {"steps", step, tear_and_hit_damped},
                           {"a relaxation of a changed world", relax, tear_and_hit},
                           {"a relaxation", relax, tear_and_hit_damped}})
      most_made = std::max(most_made, survive_every_failure(run, dimension));
  }
  CHECK(most_made > 0);
}

}  // namespace halfspace_test
