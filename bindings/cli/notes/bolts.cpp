#include <array>
#include <optional>
#include <string>

#include "common/text.h"
#include "notes/kinds.h"

namespace halfspace::cli {

/// A run would stop at the stage that installs them. Bolts of the start have been installed already.
void note_bolts(const Start& start, Faults& faults) {
  for (const Bolt& bolt : start.scene.bolts) {
    if (!bolt.is_installed_later || !bolt.blocks[0].empty()) continue;
    std::array<std::optional<std::size_t>, 2> carriers;
    for (std::size_t end = 0; end < 2; ++end) {
      carriers[end] = start.model.block_at(bolt.ends[end]);
      if (!carriers[end])
        faults.note(bolt.places[end], bolt.keys[end],
                    described(bolt.ends[end], start.layout.dimension) +
                        " is outside of all blocks at the start; usual: a place in a block, or blocks = "
                        "[\"a\", \"b\"], one of which may be \"ground\"");
    }
    if (carriers[0] && carriers[0] == carriers[1])
      faults.note(bolt.places[1], bolt.keys[1],
                  "both ends are in \"" + start.layout.blocks[*carriers[0]].name +
                      "\" at the start; usual: ends in two blocks");
  }
}

}  // namespace halfspace::cli
