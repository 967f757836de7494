#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace halfspace {

/// The passes of a step, as its time is told.
enum class Pass { search, pairs, gather, bonds, motion, hard_contacts, book, water, bolts };
constexpr std::size_t pass_count = 9;

/// Adds up how long each pass takes, from when it is made on. A world has none unless it is measured.
class Stopwatch {
 public:
  /// The time since the lap before belongs to this pass.
  void lap(Pass pass) {
    const Clock::time_point now = Clock::now();
    seconds_[std::size_t(pass)] += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }
  double seconds(Pass pass) const { return seconds_[std::size_t(pass)]; }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point last_ = Clock::now();
  std::array<double, pass_count> seconds_{};
};

}  // namespace halfspace
