#include "model/bolt_ends.h"

#include <algorithm>

#include "common/text.h"
#include "model/near_blocks.h"

namespace halfspace::cli {
namespace {

constexpr const char* named_ends = R"(or with blocks = ["a", "b"], one of which may be "ground")";

class BoltEnds {
 public:
  BoltEnds(const Context& context, const Scene& scene, Layout& layout, Faults& faults)
      : context_(context), scene_(scene), layout_(layout), faults_(faults), is_gone_(layout.blocks.size()) {}

  void find() {
    layout_.bolt_ends.resize(scene_.bolts.size());
    for (std::size_t stage = 0; stage < scene_.stages.size(); ++stage) {
      for (const std::size_t block : layout_.excavated[stage]) is_gone_[block] = true;
      for (const std::size_t bolt : scene_.stages[stage].installed) find_ends(bolt);
    }
  }

 private:
  void find_ends(std::size_t index) {
    const Bolt& bolt = scene_.bolts[index];
    std::array<std::optional<std::size_t>, 2>& ends = layout_.bolt_ends[index];
    for (std::size_t end = 0; end < 2; ++end) {
      if (bolt.blocks[end].empty()) {
        ends[end] = block_at(bolt, end);
      } else {
        require_present(bolt, end);
      }
    }
    if (ends[0] && ends[1] && whole(*ends[0]) == whole(*ends[1]))
      faults_.add(bolt.places[1], bolt.keys[1],
                  "both ends are in \"" + layout_.blocks[*ends[0]].name +
                      "\"; allowed: ends in two blocks, " + named_ends);
  }

  std::optional<std::size_t> block_at(const Bolt& bolt, std::size_t end) {
    const auto nearest = nearest_block_where(context_, layout_, bolt.ends[end],
                                             [&](std::size_t block) { return !is_gone_[block]; });
    if (nearest && nearest->distance == 0) return nearest->block;
    std::string text = described(bolt.ends[end], layout_.dimension) + " is outside of all blocks";
    const auto before = nearest_block(context_, layout_, bolt.ends[end]);
    if (before && before->distance == 0)
      text += " once \"" + layout_.blocks[before->block].name + "\" is excavated";
    if (nearest)
      text += "; the nearest is \"" + layout_.blocks[nearest->block].name + "\", " +
              rounded(nearest->distance, 3) + " m away";
    faults_.add(bolt.places[end], bolt.keys[end], text + "; allowed: a place in a block, " + named_ends);
    return std::nullopt;
  }

  void require_present(const Bolt& bolt, std::size_t end) {
    for (std::size_t block = 0; block < is_gone_.size(); ++block) {
      if (!is_gone_[block] || layout_.blocks[block].name != bolt.blocks[end]) continue;
      faults_.add(
          bolt.places[end], bolt.keys[end],
          '"' + bolt.blocks[end] + "\" is excavated by then; allowed: a block that remains, or \"ground\"");
    }
  }

  /// The first part of a concave block.
  std::size_t whole(std::size_t block) const {
    const std::optional<std::size_t> compound = layout_.blocks[block].compound;
    return compound ? layout_.compounds[*compound].first_block : block;
  }

  const Context& context_;
  const Scene& scene_;
  Layout& layout_;
  Faults& faults_;
  std::vector<bool> is_gone_;  ///< of each block: excavated up to the present stage
};

}  // namespace

void find_bolt_ends(const Context& context, const Scene& scene, Layout& layout, Faults& faults) {
  BoltEnds(context, scene, layout, faults).find();
}

}  // namespace halfspace::cli
