#pragma once

namespace halfspace {

/// The host's wish to end a long call early.
class Interrupt {
 public:
  virtual ~Interrupt() = default;
  virtual bool is_requested() = 0;
};

}  // namespace halfspace
