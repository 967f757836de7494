#pragma once

#include <cstdint>

#include "geometry/vector.h"
#include "world/contacts/neighbor_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Steps between two searches for islands that may sleep.
constexpr std::int64_t steps_between_looks = 64;

/// Minimum duration of a sleep, in steps.
constexpr double min_sleep_in_steps = 256;

/// Bounds of the speed and the acceleration of a block's points.
struct SpeedBound {
  double speed = 0;
  double acceleration = 0;

  /// Maximum displacement in `duration`, if the forces on the block do not change.
  double way(double duration) const { return duration * (speed + 0.5 * acceleration * duration); }
  /// Minimum time for a displacement of `way`.
  double time_for(double way) const;
};

/// Sleep of blocks at rest: steps skip sleeping blocks and the contacts between them. An island, the blocks
/// that contacts and bonds connect, falls asleep and wakes as a whole; a compound and its parts are in one.
/// It wakes when touched, after an edit, and when its time is over. The displacement error of a block, summed
/// over all of its sleeps, never exceeds the tolerance.
template <int D>
class Sleep {
 public:
  explicit Sleep(Memory* memory)
      : rest_(memory),
        error_used_(memory),
        since_(memory),
        until_(memory),
        speed_bound_(memory),
        island_(memory),
        longest_(memory) {}

  /// Reserves all memory.
  void reserve(std::size_t slots);
  /// Allocates nothing after reserve().
  void resize(std::size_t slots);

  bool any() const { return sleeping_ > 0; }
  /// How often blocks have fallen asleep or woken; not saved.
  std::uint32_t changes() const { return changes_; }
  std::int64_t count() const { return sleeping_; }
  bool is_asleep(std::size_t slot) const { return any() && rest_[slot] == Rest::asleep; }
  /// True when steps skip a pair, because each of its blocks sleeps or does not move.
  template <class Pair>
  bool leaves_out(const Pair& pair) const {
    return any() && rest_[std::size_t(pair.a)] != Rest::none && rest_[std::size_t(pair.b)] != Rest::none;
  }
  /// True when one block of a pair would wake the other.
  template <class Pair>
  bool may_wake(const Pair& pair) const {
    if (!any()) return false;
    const Rest a = rest_[std::size_t(pair.a)], b = rest_[std::size_t(pair.b)];
    return (a == Rest::none && b == Rest::asleep) || (a == Rest::asleep && b == Rest::none);
  }
  /// Maximum displacement error by sleep so far, over all blocks, m.
  double max_error(double time) const;

  /// Puts islands to sleep that may sleep long enough. `for_each_touch(visit)` calls `visit(a, b)` for all
  /// blocks in touch, and `speed_bound_of(slot)` returns the bound of a free block.
  template <class ForEachTouch, class BoundOf>
  void look(const Model<D>& model, ForEachTouch for_each_touch, double time, double min_sleep,
            BoundOf speed_bound_of) {
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (rest_[i] == Rest::asleep) continue;
      begin_look(model.blocks, i);
      if (model.blocks.moves_freely(i)) speed_bound_[i] = speed_bound_of(i);
      longest_[i] = longest_sleep(model, i, min_sleep);
    }
    for_each_touch([&](std::int32_t a, std::int32_t b) { join(a, b); });
    join_by_bonds(model.blocks);
    for (const Part<D>& part : model.blocks.compounds().parts()) join(part.compound, part.block);
    put_to_sleep(time, min_sleep);
  }
  /// Wakes islands whose sleep ends within `duration`.
  void wake_in_time(double time, double duration);
  /// Wakes islands that a moving block touches. Returns true if there are any.
  template <class ForEachTouch>
  bool wake_touched(ForEachTouch for_each_touch, double time) {
    if (!any()) return false;
    bool is_touched = false;
    for_each_touch([&](std::int32_t a, std::int32_t b) {
      is_touched |= mark_touched(a, b);
      is_touched |= mark_touched(b, a);
    });
    return is_touched && wake_marked(time);
  }
  /// Wakes the island of a block, if it sleeps.
  void wake_island_of(std::size_t slot, double time);
  void wake_all(double time);
  /// Clears the slot of a removed block. Precondition: all blocks are awake.
  void forget(std::size_t slot);

  /// Validates the state read from a snapshot. `knows_all`: the arrays must have all slots.
  bool is_consistent(std::size_t slots, bool knows_all) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(rest_, error_used_, since_, until_, speed_bound_, island_, next_wake_, sleeping_);
    if constexpr (Archive::reads) longest_.resize(rest_.size());
  }

 private:
  enum class Rest : std::uint8_t { none = 0, fixed = 1, asleep = 2 };

  void begin_look(const Blocks<D>& blocks, std::size_t slot);
  double longest_sleep(const Model<D>& model, std::size_t slot, double min_sleep) const;
  std::int32_t head_of(std::int32_t slot);
  void join(std::int32_t a, std::int32_t b);
  void join_by_bonds(const Blocks<D>& blocks);
  bool mark_touched(std::int32_t mover, std::int32_t sleeper);
  bool wake_marked(double time);
  void put_to_sleep(double time, double min_sleep);
  template <class Wakes>
  bool wake_islands(Wakes wakes, double time);

  Array<Rest> rest_;               // per slot; `fixed` as of the last look()
  Array<double> error_used_;       // of the tolerance, by sleeps that have ended, m
  Array<double> since_;            // when it fell asleep
  Array<double> until_;            // when it wakes at the latest
  Array<SpeedBound> speed_bound_;  // at the beginning of the sleep
  Array<std::int32_t> island_;     // slot that represents the island
  Array<double> longest_;          // maximum sleep of a block, or of the island that it represents, s
  double next_wake_ = 0;           // the earliest of all
  std::int64_t sleeping_ = 0;      // number of blocks
  std::uint32_t changes_ = 0;
};

extern template class Sleep<2>;
extern template class Sleep<3>;

}  // namespace halfspace
