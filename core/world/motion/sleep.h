#pragma once

#include <cstdint>

#include "geometry/vector.h"
#include "world/contacts/contact_list.h"
#include "world/model/model.h"

namespace halfspace {

/// Steps between two looks for blocks that may fall asleep.
constexpr std::int64_t steps_between_looks = 64;

/// A sleep of fewer steps is not worth its while.
constexpr double least_sleep_in_steps = 256;

/// The speed of a block's farthest point at most, and how fast that changes.
struct SpeedBound {
  double speed = 0;
  double acceleration = 0;

  /// The way at most, if nothing that acts on the block changes.
  double way(double duration) const { return duration * (speed + 0.5 * acceleration * duration); }
  /// The time that a way takes at least.
  double time_for(double way) const;
};

/// Blocks that stand still in time while nothing reaches them: steps leave out them and the contacts among
/// them. An island is what contacts and bonds hold together. It falls asleep as a whole and wakes as a whole:
/// by touch, by any change from outside, and before one of its blocks has missed too much of its way. All
/// sleep of a run costs no block more of its way than the tolerance.
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

  /// Takes all memory that sleep needs.
  void reserve(std::size_t slots);
  /// Memory has been reserved.
  void resize(std::size_t slots);

  bool any() const { return sleeping_ > 0; }
  std::int64_t count() const { return sleeping_; }
  bool is_asleep(std::size_t slot) const { return any() && rest_[slot] == Rest::asleep; }
  /// Does a pair stay as it is, as both blocks sleep or do not move?
  bool leaves_out(const Candidate<D>& pair) const {
    return any() && rest_[std::size_t(pair.a)] != Rest::none && rest_[std::size_t(pair.b)] != Rest::none;
  }
  /// The most of its way that any block has missed.
  double max_error(double time) const;

  /// Puts islands to sleep that may sleep for a while; contacts are known. `speed_bound_of(slot)` tells how a
  /// free block moves. True when more blocks sleep than before.
  template <class PaceOf>
  bool look(const Model<D>& model, const ContactList<D>& contacts, double time, double least_sleep,
            PaceOf speed_bound_of) {
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (rest_[i] == Rest::asleep) continue;
      begin_look(model.blocks, i);
      if (model.blocks.moves_freely(i)) speed_bound_[i] = speed_bound_of(i);
      longest_[i] = longest_sleep(model, i, least_sleep);
    }
    find_islands(model.blocks, contacts);
    return put_to_sleep(time, least_sleep);
  }
  /// Wakes islands that have to wake before so much time has passed. True when there are any.
  bool wake_in_time(double time, double duration);
  /// Wakes islands that a block which moves has come to touch. True when there are any.
  bool wake_touched(const ContactList<D>& contacts, double time);
  /// Wakes the island of a block. True when it slept.
  bool wake_island_of(std::size_t slot, double time);
  void wake_all(double time);
  /// The slot of a block that is removed may come to be another's. All are awake.
  void forget(std::size_t slot);

  /// False for what no sleep can be, after reading a snapshot. A world that is ready for its next step, in
  /// which blocks may sleep, knows all slots.
  bool is_consistent(std::size_t slots, bool knows_all) const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(rest_, error_used_, since_, until_, speed_bound_, island_, next_wake_, sleeping_);
    if constexpr (Archive::reads) longest_.resize(rest_.size());
  }

 private:
  enum class Rest : std::uint8_t { none = 0, fixed = 1, asleep = 2 };

  void begin_look(const Blocks<D>& blocks, std::size_t slot);
  double longest_sleep(const Model<D>& model, std::size_t slot, double least_sleep) const;
  std::int32_t head_of(std::int32_t slot);
  void join(std::int32_t a, std::int32_t b);
  void find_islands(const Blocks<D>& blocks, const ContactList<D>& contacts);
  bool put_to_sleep(double time, double least_sleep);
  template <class Wakes>
  bool wake_islands(Wakes wakes, double time);

  Array<Rest> rest_;               // of each slot; `fixed` is as of the last look
  Array<double> error_used_;       // of the tolerance, by sleep that is over
  Array<double> since_;            // when it fell asleep
  Array<double> until_;            // when it wakes, if nothing wakes it before
  Array<SpeedBound> speed_bound_;  // as it fell asleep
  Array<std::int32_t> island_;     // the slot that stands for its island
  Array<double> longest_;          // that a block, or the island that it stands for, may sleep
  double next_wake_ = 0;           // the first of all
  std::int64_t sleeping_ = 0;      // blocks
};

extern template class Sleep<2>;
extern template class Sleep<3>;

}  // namespace halfspace
