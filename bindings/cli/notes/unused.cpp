#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/library.h"
#include "notes/kinds.h"

namespace halfspace::cli {
namespace {

void note_materials(const Start& start, const std::set<int>& used, Faults& faults) {
  for (std::size_t i = 0; i < start.scene.materials.size(); ++i) {
    const Material& material = start.scene.materials[i];
    if (!used.contains(static_cast<int>(i)))
      faults.note(material.place, "material[" + std::to_string(i) + "].name",
                  "no block is of " + quoted(material.name));
  }
}

void note_laws(const Start& start, const std::set<int>& used, Faults& faults) {
  for (std::size_t i = 0; i < start.scene.laws.size(); ++i) {
    const PairLaw& law = start.scene.laws[i];
    for (const int material : std::set{law.a, law.b}) {
      if (used.contains(material)) continue;
      faults.note(law.place, "law[" + std::to_string(i) + "].between",
                  "no block is of " + quoted(start.scene.materials[static_cast<std::size_t>(material)].name) +
                      ", so that this law has no use");
      break;
    }
  }
}

/// The pairs of materials of all contacts after a first step, which counts flush faces that hold together.
std::set<std::pair<int, int>> materials_in_contact(const Start& start) {
  const World world = restored(start.context, start.model.snapshot());
  (void)hs_world_step(world.get(), 1);  // one that fails leaves the contacts of the start
  const auto material_of = [&](hs_block block) {
    hs_block_state state{};
    require(start.context, hs_world_get_block_state(world.get(), block, &state));
    return state.material;
  };
  std::set<std::pair<int, int>> pairs;
  for (const hs_contact& contact : all_records(start.context, world.get(), hs_world_get_contacts))
    pairs.insert(std::minmax(material_of(contact.block_a), material_of(contact.block_b)));
  return pairs;
}

/// Cohesion and tensile strength belong to contacts that exist at the start.
void note_strengths(const Start& start, Faults& faults) {
  if (!any_law(start.scene, holds_together)) return;
  const std::set<std::pair<int, int>> touching = materials_in_contact(start);
  const std::string text =
      "cohesion and tensile_strength act in contacts that exist at the start, and there is none";
  std::set<std::pair<int, int>> own;  // pairs of materials with a law of their own
  for (std::size_t i = 0; i < start.scene.laws.size(); ++i) {
    const PairLaw& law = start.scene.laws[i];
    own.insert(std::minmax(law.a, law.b));
    const hs_law_def& from = start.scene.default_law;
    const bool differs =
        law.law.cohesion != from.cohesion || law.law.tensile_strength != from.tensile_strength;
    if (differs && holds_together(law.law) && !touching.contains(std::minmax(law.a, law.b)))
      faults.note(law.place, "law[" + std::to_string(i) + "]", text + " between these materials");
  }
  const bool is_default_used =
      std::any_of(touching.begin(), touching.end(), [&](const auto& pair) { return !own.contains(pair); });
  if (holds_together(start.scene.default_law) && !is_default_used)
    faults.note(start.scene.places.default_law, "default_law", text + " with this law");
}

void note_all_at_rest(const Start& start, Faults& faults) {
  const std::vector<LayoutBlock>& blocks = start.layout.blocks;
  const auto rests = [](const LayoutBlock& block) { return block.kind == HS_BLOCK_FIXED; };
  if (!blocks.empty() && std::all_of(blocks.begin(), blocks.end(), rests))
    faults.note(blocks[0].place, blocks[0].key,
                "all blocks are fixed: nothing moves; usual: some that are rigid");
}

}  // namespace

void note_unused(const Start& start, Faults& faults) {
  const std::set<int> used = used_materials(start);
  note_materials(start, used, faults);
  note_laws(start, used, faults);
  note_strengths(start, faults);
  note_all_at_rest(start, faults);
}

}  // namespace halfspace::cli
