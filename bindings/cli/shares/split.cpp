#include "shares/split.h"

#include <stdexcept>

#include "common/box.h"
#include "shares/division.h"
#include "shares/shared_blocks.h"

namespace halfspace::cli {
namespace {

/// The free blocks of a world, and where they are.
struct FreeBlocks {
  FreeBlocks(const Context& context, const hs_world* world, const SharedBlocks& blocks) {
    std::vector<hs_pose> poses(blocks.keys.size());
    require(context, hs_world_get_poses(world, poses.data(), std::int64_t(poses.size()), nullptr));
    for (std::size_t i = 0; i < poses.size(); ++i)
      if (blocks.roles[i] == HS_ROLE_OWN) places.push_back(point_of(poses[i].position));
    keys = blocks.keys_of(HS_ROLE_OWN);
  }

  std::vector<std::int64_t> keys;
  std::vector<Point> places;
};

}  // namespace

void SplitCounts::add(const hs_share_info& share) {
  min_own = std::min(min_own, share.own_count);
  max_own = std::max(max_own, share.own_count);
  min_copies = std::min(min_copies, share.neighbor_count);
  max_copies = std::max(max_copies, share.neighbor_count);
}

SplitCounts split(const Context& context, hs_world* world, std::int64_t count, OutputDirectory& directory) {
  const hs_share_info info = share_info_of(context, world);
  if (!info.is_whole) throw std::runtime_error("the world is a share of a larger one; join its shares first");
  if (count > info.own_count)
    throw std::runtime_error("cannot cut " + std::to_string(info.own_count) + " free blocks into " +
                             std::to_string(count) + " shares");
  const SharedBlocks blocks(context, world);
  const FreeBlocks free(context, world, blocks);
  SplitCounts counts;
  std::size_t number = 0;
  for (const std::vector<std::size_t>& part : bisect(free.places, std::size_t(count))) {
    Box box;
    for (const std::size_t i : part) box.add(free.places[i]);
    std::vector<std::int64_t> own, copied;
    auto next = part.begin();
    for (std::size_t i = 0; i < free.keys.size(); ++i) {
      if (next != part.end() && *next == i) {
        own.push_back(free.keys[i]);
        ++next;
      } else if (box.distance(free.places[i]) < info.halo) {
        copied.push_back(free.keys[i]);
      }
    }
    const Records copies(context, world, copied, false);
    std::vector<hs_packed> packed;
    add_present(packed, own, HS_ROLE_OWN);
    add_present(packed, blocks.keys_of(HS_ROLE_EVERYWHERE), HS_ROLE_EVERYWHERE);
    copies.add_to(packed, HS_ROLE_NEIGHBOR);
    const World share = assembled(context, world, packed);
    counts.add(share_info_of(context, share.get()));
    directory.write(share_name(number++), snapshot_of(context, share.get()));
  }
  return counts;
}

}  // namespace halfspace::cli
