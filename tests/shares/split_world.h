#pragma once

// A world cut into shares within one process: the calls and the bytes of a host that spreads a world over
// processes, without the processes. Slabs across x hold as many free blocks each, and move with them.

#include <algorithm>
#include <ctime>
#include <limits>
#include <vector>

#include "capi/world_fixture.h"

namespace halfspace_test {

inline hs_share_info info_of(hs_world* world) {
  hs_share_info info{};
  if (hs_world_get_share_info(world, &info, sizeof info) != HS_OK) throw std::runtime_error("no share info");
  return info;
}

inline std::vector<std::int64_t> keys_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_keys(world, nullptr, 0, &count);
  std::vector<std::int64_t> keys(static_cast<std::size_t>(count));
  if (hs_world_get_keys(world, keys.data(), count, nullptr) != HS_OK) throw std::runtime_error("no keys");
  return keys;
}

inline std::vector<std::int32_t> roles_of(const hs_world* world) {
  std::int64_t count = 0;
  (void)hs_world_get_roles(world, nullptr, 0, &count);
  std::vector<std::int32_t> roles(static_cast<std::size_t>(count));
  if (hs_world_get_roles(world, roles.data(), count, nullptr) != HS_OK) throw std::runtime_error("no roles");
  return roles;
}

/// The records of blocks, one after the other.
struct Records {
  std::vector<unsigned char> bytes;
  std::vector<std::size_t> ends;

  std::size_t begin_of(std::size_t i) const { return i == 0 ? 0 : ends[i - 1]; }
};

inline Records packed(hs_context* context, hs_world* world, const std::vector<std::int64_t>& keys,
                      bool with_shapes) {
  Records records;
  records.ends.resize(keys.size());
  const std::int64_t count = std::int64_t(keys.size());
  std::size_t size = 0;
  const hs_status measured =
      hs_world_pack(world, keys.data(), count, with_shapes, nullptr, 0, nullptr, &size);
  if (measured != HS_NOTE_TRUNCATED) require_ok(measured, context);
  records.bytes.resize(size);
  require_ok(hs_world_pack(world, keys.data(), count, with_shapes, records.bytes.data(), size,
                           records.ends.data(), &size),
             context);
  return records;
}

/// The keys of the blocks with a role.
inline std::vector<std::int64_t> keys_with(const hs_world* world, std::int32_t role) {
  std::vector<std::int64_t> keys = keys_of(world), found;
  const std::vector<std::int32_t> roles = roles_of(world);
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (roles[i] == role) found.push_back(keys[i]);
  return found;
}

class SplitWorld {
 public:
  /// `whole`: a world saved. `overlap`: the halo over that which the shares ask for.
  SplitWorld(const std::vector<unsigned char>& whole, std::size_t count, std::int32_t threads = 1,
             double overlap = 1)
      : overlap_(overlap), shares_(count) {
    hs_context_def def;
    require_ok(hs_context_def_init(&def, sizeof def), nullptr);
    def.threads = threads;
    for (Share& share : shares_) {
      share.context = make_context(&def);
      share.world = restored(share.context.get(), whole);
    }
    assemble();
    begin();
  }

  /// Begins, also after changes alike in all shares.
  void begin() {
    for (Share& share : shares_) share.ok(hs_world_begin(share.world.get()));
    carry_loads();
    for (Share& share : shares_) share.ok(hs_world_end_begin(share.world.get()));
  }

  void step() {
    hs_share_plan plan = planned();
    if (plan.needs_list || plan.needs_assembly) {
      if (!plan.needs_list) ++entrances_;
      const auto start = std::clock();
      assemble();
      assembling_ += double(std::clock() - start) / CLOCKS_PER_SEC;
      ++assemblies_;
      const hs_share_plan again = planned();
      if (plan.needs_list || again.needs_list) {
        plan.refusal = HS_OK;
        for (Share& share : shares_) {
          hs_share_plan own{};
          share.ok(hs_world_renew_list(share.world.get(), &own));
          plan.refusal = std::min(plan.refusal, own.refusal);
        }
      } else {
        plan = again;
      }
    }
    if (plan.refusal != HS_OK) throw std::runtime_error(hs_status_string(hs_status(plan.refusal)));
    for (Share& share : shares_) share.ok(hs_world_move(share.world.get()));
    carry_loads();
    for (Share& share : shares_) share.ok(hs_world_end_step(share.world.get()));
  }

  /// The whole world again, in the context of the first share.
  World joined() {
    std::vector<Sent> all;
    for (std::size_t i = 1; i < shares_.size(); ++i)
      send(i, keys_with(world(i), HS_ROLE_OWN), HS_ROLE_OWN, all);
    World whole = assembled(0, keys_with(world(0), HS_ROLE_OWN), all);
    shares_.front().ok(hs_world_set_sums(whole.get(), sums().data()));
    return whole;
  }
  /// Goes on from a snapshot of each share.
  void restart() {
    for (Share& share : shares_) share.world = restored(share.context.get(), saved(share.world.get()));
  }
  /// Energies and losses of all shares together.
  std::vector<double> sums() const {
    std::vector<double> sums(HS_SUM_COUNT), own(HS_SUM_COUNT);
    for (const Share& share : shares_) {
      share.ok(hs_world_get_sums(share.world.get(), own.data()));
      for (std::size_t i = 0; i < own.size(); ++i) sums[i] += own[i];
    }
    return sums;
  }
  hs_context* context() const { return shares_.front().context.get(); }

  std::int64_t assemblies() const { return assemblies_; }
  /// Processor seconds of all assemblies.
  double assembling() const { return assembling_; }
  /// Assemblies only because an entry face had to be told.
  std::int64_t entrances() const { return entrances_; }
  std::int64_t migrations() const { return migrations_; }
  std::size_t copies() const {
    std::size_t copies = 0;
    for (const Share& share : shares_) copies += std::size_t(info_of(share.world.get()).neighbor_count);
    return copies;
  }
  std::int64_t lost_pairs() const {
    std::int64_t lost = 0;
    for (const Share& share : shares_) lost += info_of(share.world.get()).lost_pairs;
    return lost;
  }
  std::size_t count() const { return shares_.size(); }
  hs_world* world(std::size_t i) const { return shares_[i].world.get(); }

 private:
  struct Share {
    Context context;
    World world;

    void ok(hs_status status) const { require_ok(status, context.get()); }
  };
  /// A block on its way to another share.
  struct Sent {
    std::int64_t key;
    std::int32_t role;
    std::vector<unsigned char> bytes;
  };
  /// Copies in one share that another owns.
  struct Route {
    std::size_t owner;
    std::size_t holder;
    std::vector<std::int64_t> keys;
  };
  struct Place {
    double x;
    std::int64_t key;
    std::size_t owner;  // until now
  };

  void send(std::size_t from, const std::vector<std::int64_t>& keys, std::int32_t role,
            std::vector<Sent>& sent) {
    const Records records = packed(shares_[from].context.get(), world(from), keys, true);
    for (std::size_t i = 0; i < keys.size(); ++i)
      sent.push_back({keys[i],
                      role,
                      {records.bytes.begin() + std::ptrdiff_t(records.begin_of(i)),
                       records.bytes.begin() + std::ptrdiff_t(records.ends[i])}});
  }

  /// A share of what it keeps, what it is sent, and what is everywhere.
  World assembled(std::size_t share, const std::vector<std::int64_t>& kept, const std::vector<Sent>& sent) {
    std::vector<hs_packed> blocks;
    for (const std::int64_t key : kept) blocks.push_back({key, nullptr, 0, HS_ROLE_OWN, 0});
    for (const std::int64_t key : keys_with(world(share), HS_ROLE_EVERYWHERE))
      blocks.push_back({key, nullptr, 0, HS_ROLE_EVERYWHERE, 0});
    for (const Sent& block : sent)
      blocks.push_back({block.key, block.bytes.data(), block.bytes.size(), block.role, 0});
    std::sort(blocks.begin(), blocks.end(),
              [](const hs_packed& a, const hs_packed& b) { return a.key < b.key; });
    hs_world* made = nullptr;
    shares_[share].ok(hs_world_assemble(shares_[share].context.get(), world(share), blocks.data(),
                                        std::int64_t(blocks.size()), &made));
    return World(made);
  }

  hs_share_plan planned() {
    hs_share_plan all{};
    for (Share& share : shares_) {
      hs_share_plan own{};
      share.ok(hs_world_plan_motion(share.world.get(), &own));
      all.needs_list = std::max(all.needs_list, own.needs_list);
      all.needs_assembly = std::max(all.needs_assembly, own.needs_assembly);
      all.refusal = std::min(all.refusal, own.refusal);
    }
    return all;
  }

  /// All own blocks, by x.
  std::vector<Place> places() const {
    std::vector<Place> places;
    for (std::size_t s = 0; s < shares_.size(); ++s) {
      if (is_cut_ || s == 0) {
        const std::vector<std::int64_t> keys = keys_of(world(s));
        const std::vector<std::int32_t> roles = roles_of(world(s));
        const std::vector<hs_pose> poses = poses_of(world(s));
        for (std::size_t i = 0; i < keys.size(); ++i)
          if (roles[i] == HS_ROLE_OWN) places.push_back({poses[i].position[0], keys[i], s});
      }
    }
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.x < b.x || (a.x == b.x && a.key < b.key); });
    return places;
  }

  void assemble() {
    double halo = 0;
    for (const Share& share : shares_) halo = std::max(halo, overlap_ * info_of(share.world.get()).halo);
    const std::vector<Place> all = places();
    const std::size_t count = shares_.size();
    std::vector<World> next;
    routes_.clear();
    for (std::size_t to = 0; to < count; ++to) {
      const std::size_t first = cut_before(to, all.size()), last = cut_before(to + 1, all.size());
      const double low = first < last ? all[first].x - halo : std::numeric_limits<double>::infinity();
      const double high = first < last ? all[last - 1].x + halo : -low;
      std::vector<std::int64_t> kept;
      std::vector<std::vector<std::int64_t>> migrating(count), copied(count);
      for (std::size_t i = 0; i < all.size(); ++i) {
        const Place& place = all[i];
        const bool is_own = i >= first && i < last;
        if (!is_own && !(place.x >= low && place.x <= high)) continue;
        if (!is_own) {
          add_route(owner_of(i, all.size()), to, place.key);
          copied[place.owner].push_back(place.key);
        } else if (place.owner == to || !is_cut_) {
          kept.push_back(place.key);
        } else {
          migrating[place.owner].push_back(place.key);
          ++migrations_;
        }
      }
      std::vector<Sent> sent;
      for (std::size_t from = 0; from < count; ++from) {
        if (!migrating[from].empty()) send(from, migrating[from], HS_ROLE_OWN, sent);
        if (!copied[from].empty()) send(from, copied[from], HS_ROLE_NEIGHBOR, sent);
      }
      next.push_back(assembled(to, kept, sent));
    }
    for (std::size_t s = 0; s < count; ++s) shares_[s].world = std::move(next[s]);
    is_cut_ = true;
  }

  /// Cuts go to and fro a little, as those of a balance of load do.
  std::size_t cut_before(std::size_t share, std::size_t blocks) const {
    const std::size_t count = shares_.size();
    if (share == 0 || share == count) return share == 0 ? 0 : blocks;
    return blocks * share / count + std::size_t(assemblies_) % std::max<std::size_t>(1, blocks / count / 2);
  }
  std::size_t owner_of(std::size_t i, std::size_t blocks) const {
    std::size_t owner = 0;
    while (i >= cut_before(owner + 1, blocks)) ++owner;
    return owner;
  }

  void add_route(std::size_t owner, std::size_t holder, std::int64_t key) {
    for (Route& route : routes_) {
      if (route.owner == owner && route.holder == holder) return route.keys.push_back(key);
    }
    routes_.push_back({owner, holder, {key}});
  }

  void carry_loads() {
    for (const Route& route : routes_) {
      const std::int64_t count = std::int64_t(route.keys.size());
      loads_.resize(route.keys.size() * std::size_t(info_length_of(route.owner)));
      shares_[route.owner].ok(
          hs_world_get_loads(world(route.owner), route.keys.data(), count, loads_.data()));
      shares_[route.holder].ok(
          hs_world_set_loads(world(route.holder), route.keys.data(), count, loads_.data()));
    }
  }
  std::int32_t info_length_of(std::size_t share) {
    if (load_length_ == 0) load_length_ = info_of(world(share)).load_length;
    return load_length_;
  }

  double overlap_;
  std::vector<Share> shares_;
  std::vector<Route> routes_;
  std::vector<double> loads_;
  std::int32_t load_length_ = 0;
  bool is_cut_ = false;  // before, each share is the whole world
  std::int64_t assemblies_ = 0;
  std::int64_t migrations_ = 0;
  std::int64_t entrances_ = 0;
  double assembling_ = 0;
};

}  // namespace halfspace_test
