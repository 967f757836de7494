#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// True if a law between two of these materials has the property. A block may meet another of its own
/// material.
template <class Property>
bool any_law_between(const Scene& scene, const std::set<int>& some, const std::set<int>& others,
                     Property property) {
  return std::any_of(some.begin(), some.end(), [&](int a) {
    return std::any_of(others.begin(), others.end(),
                       [&](int b) { return property(law_between(scene, a, b)); });
  });
}

/// The reason why no two blocks have impulses between rigid blocks. Empty if some may have.
std::string reason_without_impulses(const Start& start) {
  const std::set<int> used = used_materials(start);
  if (!any_law_between(start.scene, used, used, has_no_spring))
    return "the laws of all blocks have springs; usual: a law with stiffness = \"none\"";
  std::set<int> with_manifolds, moving;  // materials of blocks that neither deform nor are held
  for (const LayoutBlock& block : start.layout.blocks) {
    if (deforms(block.kind) || block.motion.held_axes != 0) continue;
    with_manifolds.insert(block.material);
    if (block.kind == HS_BLOCK_RIGID) moving.insert(block.material);
  }
  if (!any_law_between(start.scene, moving, with_manifolds, has_no_spring))
    return "contacts without springs of blocks that deform or are held are points; usual: a law without "
           "springs between rigid blocks";
  const auto has_impulses = [](const hs_law_def& law) { return has_no_spring(law) && !holds_together(law); };
  if (!any_law_between(start.scene, moving, with_manifolds, has_impulses))
    return "contacts by a law without springs that has cohesion or tensile_strength are points; usual: these "
           "in laws with springs only";
  return {};
}

}  // namespace

void note_impulses(const Start& start, Faults& faults) {
  const std::string reason = reason_without_impulses(start);
  if (reason.empty()) return;
  const auto note = [&](const std::optional<Place>& place, const std::string& key) {
    if (place) faults.note(*place, key, "no effect: " + reason);
  };
  const Scene::Places& places = start.scene.places;
  note(places.impulse_tolerance, "world.impulse_tolerance");
  note(places.max_impulse_iterations, "world.max_impulse_iterations");
  note(places.locate_impacts, "world.locate_impacts");
  note(places.restitution, "default_law.restitution");
  for (std::size_t i = 0; i < start.scene.laws.size(); ++i)
    note(start.scene.laws[i].restitution_place, "law[" + std::to_string(i) + "].restitution");
}

}  // namespace halfspace::cli
