#include "shares/shared_blocks.h"

#include <algorithm>

namespace halfspace::cli {

SharedBlocks::SharedBlocks(const Context& context, const hs_world* world) {
  keys = all_records(context, world, hs_world_get_keys);
  roles = all_records(context, world, hs_world_get_roles);
}

std::vector<std::int64_t> SharedBlocks::keys_of(std::int32_t role) const {
  std::vector<std::int64_t> found;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (roles[i] == role) found.push_back(keys[i]);
  return found;
}

hs_share_info share_info_of(const Context& context, hs_world* world) {
  hs_share_info info{};
  require(context, hs_world_get_share_info(world, &info, sizeof info));
  return info;
}

Records::Records(const Context& context, hs_world* world, std::vector<std::int64_t> keys, bool with_shapes)
    : keys_(std::move(keys)), ends_(keys_.size()) {
  const auto count = std::int64_t(keys_.size());
  std::size_t size = 0;
  require(context, hs_world_pack(world, keys_.data(), count, with_shapes, nullptr, 0, nullptr, &size));
  bytes_.resize(size);
  require(context,
          hs_world_pack(world, keys_.data(), count, with_shapes, bytes_.data(), size, ends_.data(), &size));
}

void Records::add_to(std::vector<hs_packed>& blocks, std::int32_t role) const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < keys_.size(); begin = ends_[i++])
    blocks.push_back({keys_[i], bytes_.data() + begin, ends_[i] - begin, role, 0});
}

void add_present(std::vector<hs_packed>& blocks, const std::vector<std::int64_t>& keys, std::int32_t role) {
  for (const std::int64_t key : keys) blocks.push_back({key, nullptr, 0, role, 0});
}

World assembled(const Context& context, hs_world* from, std::vector<hs_packed> blocks) {
  std::sort(blocks.begin(), blocks.end(),
            [](const hs_packed& a, const hs_packed& b) { return a.key < b.key; });
  hs_world* made = nullptr;
  require(context, hs_world_assemble(context.get(), from, blocks.data(), std::int64_t(blocks.size()), &made));
  return World(made);
}

}  // namespace halfspace::cli
