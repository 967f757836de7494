#pragma once

#include "engine.h"

namespace halfspace_trade {

/// Runs scenes at one setting and adds up what they cost.
class Trial {
 public:
  explicit Trial(const Setting& setting) : setting_(setting) {}

  /// A scene at its start, and how far it has come.
  class Run {
   public:
    State state(std::size_t body) const { return world_->state(body); }
    double time() const { return time_; }
    double time_step() const { return time_step_; }
    bool is_over() const { return done_ >= all_; }
    void step(long steps = 1);
    void finish() { step(all_ - done_); }

   private:
    friend class Trial;
    Run(Trial& trial, const Scene& scene);

    Trial& trial_;
    std::unique_ptr<World> world_;
    double time_ = 0, time_step_ = 0;
    long done_ = 0, all_ = 0;
  };

  Run start(const Scene& scene) { return Run(*this, scene); }

  double cpu_seconds() const { return cpu_seconds_; }
  double simulated() const { return simulated_; }
  double time_step() const { return time_step_; }

 private:
  Setting setting_;
  double cpu_seconds_ = 0;  // of steps; building a scene does not count
  double simulated_ = 0;    // s
  double time_step_ = 0;    // of the last run, s
};

}  // namespace halfspace_trade
