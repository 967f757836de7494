#pragma once

#include <initializer_list>
#include <span>

#include "force/potential/space/division_plan.h"
#include "geometry/vector.h"

namespace halfspace {

/// Writes a plan. One that is too long is cut off.
class PlanWriter {
 public:
  explicit PlanWriter(Memory* memory) : codes_(memory) {}

  void reserve() { codes_.reserve(most_plan_codes); }
  void begin() {
    codes_.clear();
    is_too_long_ = false;
  }

  void put(std::initializer_list<int> codes) {
    is_too_long_ |= codes_.size() + codes.size() > most_plan_codes;
    if (is_too_long_) return;
    for (const int code : codes) codes_.push_back(PlanCode(code));
  }

  /// The count of what a list has comes first.
  void begin_list() {
    list_ = codes_.size();
    put({0});
  }
  void put_in_list(std::initializer_list<int> codes) {
    put(codes);
    if (!is_too_long_) ++codes_[list_];
  }
  /// With what has no volume.
  void fill_list_of_tetrahedra(std::initializer_list<int> codes) {
    while (!is_too_long_ && codes_[list_] % 4 != 0) put_in_list(codes);
  }

  bool is_too_long() const { return is_too_long_; }
  std::span<const PlanCode> plan() const { return codes_; }

 private:
  Array<PlanCode> codes_;
  std::size_t list_ = 0;
  bool is_too_long_ = false;
};

}  // namespace halfspace
