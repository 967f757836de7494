#include "shares/join.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "common/files.h"
#include "shares/shared_blocks.h"

namespace halfspace::cli {
namespace fs = std::filesystem;
namespace {

std::int64_t steps_of(const Context& context, hs_world* world) {
  hs_world_report report{};
  require(context, hs_world_get_report(world, &report, sizeof report));
  return report.steps;
}

/// The shares of one world, one after the other.
class Joint {
 public:
  Joint(const Context& context, World first)
      : context_(context), first_(std::move(first)), steps_(steps_of(context, first_.get())) {
    const SharedBlocks blocks(context_, first_.get());
    add_present(blocks_, blocks.keys_of(HS_ROLE_OWN), HS_ROLE_OWN);
    add_present(blocks_, blocks.keys_of(HS_ROLE_EVERYWHERE), HS_ROLE_EVERYWHERE);
    add_sums(first_.get());
  }

  void add(hs_world* share, const std::string& name) {
    const std::int64_t steps = steps_of(context_, share);
    if (steps != steps_)
      throw std::runtime_error(name + " has made " + std::to_string(steps) + " steps, " + share_name(0) +
                               ' ' + std::to_string(steps_));
    const SharedBlocks blocks(context_, share);
    records_.emplace_back(context_, share, blocks.keys_of(HS_ROLE_OWN), true);
    add_sums(share);
  }

  World whole() {
    for (const Records& records : records_) records.add_to(blocks_, HS_ROLE_OWN);
    require_each_once();
    World whole = assembled(context_, first_.get(), std::move(blocks_));
    const hs_share_info info = share_info_of(context_, whole.get());
    if (!info.is_whole)
      throw std::runtime_error("the shares hold " + std::to_string(info.own_count + info.everywhere_count) +
                               " of " + std::to_string(info.whole_count) + " blocks");
    require(context_, hs_world_set_sums(whole.get(), sums_.data()));
    return whole;
  }

 private:
  /// A directory may still have shares of an earlier run.
  void require_each_once() {
    std::sort(blocks_.begin(), blocks_.end(),
              [](const hs_packed& a, const hs_packed& b) { return a.key < b.key; });
    const auto twice =
        std::adjacent_find(blocks_.begin(), blocks_.end(),
                           [](const hs_packed& a, const hs_packed& b) { return a.key == b.key; });
    if (twice != blocks_.end())
      throw std::runtime_error("block " + std::to_string(twice->key) +
                               " is in two shares; remove those of another run");
  }
  void add_sums(const hs_world* share) {
    std::array<double, HS_SUM_COUNT> own;
    require(context_, hs_world_get_sums(share, own.data()));
    for (std::size_t i = 0; i < own.size(); ++i) sums_[i] += own[i];
  }

  const Context& context_;
  World first_;
  std::int64_t steps_;
  std::vector<hs_packed> blocks_;
  std::vector<Records> records_;
  std::array<double, HS_SUM_COUNT> sums_{};
};

}  // namespace

World joined(const Context& context, const std::string& directory) {
  const auto path = [&](std::size_t number) { return (fs::path(directory) / share_name(number)).string(); };
  Joint joint(context, restored(context, content_of(path(0))));
  for (std::size_t number = 1; fs::exists(path(number)); ++number) {
    const World share = restored(context, content_of(path(number)));
    joint.add(share.get(), share_name(number));
  }
  return joint.whole();
}

}  // namespace halfspace::cli
