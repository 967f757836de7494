#pragma once

// Tables of calls that a world must refuse, and that nothing of it has changed afterwards.

#include "capi/refusals.h"
#include "capi/world_fixture.h"

namespace halfspace_test {

/// Runs the table and checks that the world of a scene is bit for bit what it was.
template <class Scene>
void check_unchanged(Scene& scene, const std::string& function, const std::vector<Refusal>& refusals) {
  const std::vector<unsigned char> before = saved(scene.world.get());
  check_refusals(scene.context.get(), function, refusals);
  INFO(function);
  const bool is_unchanged = saved(scene.world.get()) == before;
  CHECK(is_unchanged);
}

/// A definition with one bad member.
template <class Def>
struct Spoiled {
  std::string member;
  std::string value;
  std::function<void(Def&)> spoil;
  hs_status status = HS_ERROR_ARGUMENT;
};

}  // namespace halfspace_test
