#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

/// True if the blocks of two of these materials follow a law with the property. A block may meet another of
/// its own material.
template <class Property>
bool any_law_between(const Scene& scene, const std::set<int>& materials, Property property) {
  return std::any_of(materials.begin(), materials.end(), [&](int a) {
    return std::any_of(materials.begin(), materials.end(),
                       [&](int b) { return a <= b && property(law_between(scene, a, b)); });
  });
}

/// The reason why there are no impulses between rigid blocks. Empty if there may be some.
std::string reason_without_impulses(const Start& start) {
  const auto bonds_without_spring = [](const hs_law_def& law) {
    return has_no_spring(law) && holds_together(law);
  };
  if (!any_law_between(start.scene, used_materials(start), has_no_spring))
    return "the laws of all blocks have springs; usual: a law with stiffness = \"none\"";
  const std::string points = ", so that all contacts without springs are point constraints; usual: ";
  const auto& blocks = start.layout.blocks;
  const auto deformable = std::find_if(blocks.begin(), blocks.end(),
                                       [](const LayoutBlock& block) { return deforms(block.kind); });
  if (deformable != blocks.end()) return quoted(deformable->name) + " deforms" + points + "rigid blocks only";
  std::set<int> materials;  // the world has all of them, also those without blocks
  for (std::size_t i = 0; i < start.scene.materials.size(); ++i) materials.insert(static_cast<int>(i));
  if (any_law_between(start.scene, materials, bonds_without_spring))
    return "a law without springs has cohesion or tensile_strength" + points +
           "these in laws with springs only";
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
