#include <algorithm>
#include <vector>

#include "common/text.h"
#include "notes/kinds.h"

namespace halfspace::cli {

void note_overlaps(const Start& start, Faults& faults) {
  struct Found {
    std::size_t a, b;
    double depth, thinner;
  };
  std::vector<Found> found;
  if (start.scene.in_situ) return;  // overlaps bear the stress
  for (const hs_contact& contact : start.model.contacts()) {
    const Body& a = start.bodies[contact.block_a];
    const Body& b = start.bodies[contact.block_b];
    const double thinner = std::min(a.thickness, b.thickness);
    if (is_beyond_rounding(-contact.gap, thinner, a, b))
      found.push_back({contact.block_a, contact.block_b, -contact.gap, thinner});
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& first, const Found& second) {
    return first.depth / first.thinner > second.depth / second.thinner;
  });
  const auto& blocks = start.layout.blocks;
  for (std::size_t i = 0; i < std::min(found.size(), max_notes); ++i) {
    const Found& pair = found[i];
    std::string text = quoted(blocks[pair.b].name) + " overlaps " + quoted(blocks[pair.a].name) +
                       " at the start by " + rounded(pair.depth, 3) + " m, " +
                       ratio_text(pair.depth / pair.thinner) +
                       " the thinner one's thickness; usual: no overlap";
    if (i + 1 == max_notes && found.size() > max_notes)
      text += "; " + std::to_string(found.size() - max_notes) + " more pairs overlap less";
    faults.note(blocks[pair.b].place, blocks[pair.b].key, text);
  }
}

}  // namespace halfspace::cli
