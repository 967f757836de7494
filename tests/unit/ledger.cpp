#include "world/motion/ledger.h"

#include <limits>

#include "catch.h"

using namespace halfspace;

namespace {

/// Rates that grow evenly with time, each in its own way. All numbers here are short binary ones, of which
/// sums are exact.
EnergySample stock_at(double time) {
  EnergySample sample;
  sample.power = {.outer = 1 + 2 * time,
                  .contact_damping = 2 + 4 * time,
                  .local_damping = 3 + 6 * time,
                  .mass_damping = 4 + 8 * time,
                  .block_damping = 5 + 10 * time};
  return sample;
}

}  // namespace

TEST_CASE("of rates that grow evenly the ledger holds the integrals, whatever the motions") {
  EnergyLedger ledger;
  ledger.begin(stock_at(0), 0);
  double time = 0;
  for (const double duration : {0.5, 0.125, 1.0, 0.375}) {
    time += duration;
    EnergySample sample = stock_at(time);
    sample.applied_power = 0.25;
    ledger.book(sample, duration);
  }
  const double integral = time + time * time;  // of 1 + 2 t
  const Ledger& entries = ledger.entries();
  CHECK(entries.outer_work == integral + 0.25 * time);
  CHECK(entries.contact_damping_loss == 2 * integral);
  CHECK(entries.local_damping_loss == 3 * integral);
  CHECK(entries.mass_damping_loss == 4 * integral);
  CHECK(entries.block_damping_loss == 5 * integral);
  CHECK(entries.losses() == (2 + 3 + 4 + 5) * integral);
}

TEST_CASE("sums over parts of a world are those over all of it, and the fastest is the fastest of any") {
  EnergySample sum = stock_at(1), other = stock_at(2);
  sum.kinetic = sum.gravity = sum.block_strain = 1;
  other.kinetic = other.gravity = other.block_strain = 2;
  sum.squared_speed = other.squared_swing = 3;
  sum.add(other);
  EnergyLedger of_sum;
  of_sum.begin(sum, 0);
  CHECK(of_sum.entries().total() == 9);
  CHECK(sum.squared_speed == 3);
  CHECK(sum.squared_swing == 3);
  const Power &power = sum.power, both = stock_at(1).power, more = stock_at(2).power;
  CHECK(power.outer == both.outer + more.outer);
  CHECK(power.contact_damping == both.contact_damping + more.contact_damping);
  CHECK(power.local_damping == both.local_damping + more.local_damping);
  CHECK(power.mass_damping == both.mass_damping + more.mass_damping);
  CHECK(power.block_damping == both.block_damping + more.block_damping);
}

TEST_CASE("a residual is what no entry explains") {
  EnergyLedger ledger;
  ledger.begin({}, 0);
  ledger.set_contact_strain(2);
  ledger.add_friction_loss(4);
  ledger.add_contact_damping_loss(8);
  EnergySample sample;
  sample.kinetic = 16;
  sample.gravity = -32;
  sample.block_strain = 64;
  sample.applied_power = 1;
  ledger.book(sample, 1);
  CHECK(ledger.entries().total() == 2 + 4 + 8 + 16 - 32 + 64);
  CHECK(ledger.entries().residual() == 61);
}

TEST_CASE("what an edit does to the energy is outer work, and no residual is lost by it") {
  EnergyLedger ledger;
  EnergySample sample;
  sample.kinetic = 1;
  ledger.begin(sample, 0);
  CHECK(ledger.entries().outer_work == 1);
  sample.kinetic = 1.25;  // out of nothing
  ledger.book(sample, 1);
  ledger.note_edit();
  sample.gravity = 8;  // lifted
  ledger.begin(sample, 0);
  CHECK(ledger.entries().outer_work == 9);
  CHECK(ledger.entries().residual() == 0.25);
}

namespace {

/// Asks of a world that holds one energy before a motion and another after it.
bool is_unstable(double before, double after, double noise, double applied_power = 0) {
  EnergyLedger ledger;
  EnergySample sample;
  sample.kinetic = before;
  ledger.begin(sample, noise);
  sample.kinetic = after;
  sample.applied_power = applied_power;
  ledger.book(sample, 1);
  return ledger.is_unstable();
}

}  // namespace

TEST_CASE("energy is made where all but nothing of it was there before") {
  CHECK(is_unstable(0.004, 1, 0));
  CHECK_FALSE(is_unstable(0.006, 1, 0));
  CHECK_FALSE(is_unstable(1, 0.004, 0));         // lost
  CHECK_FALSE(is_unstable(0.004, 1, 0, 0.996));  // worked in
  CHECK(is_unstable(1, std::numeric_limits<double>::quiet_NaN(), 0));
}

TEST_CASE("energy within the noise is not judged, and what a world begins with counts as noise") {
  CHECK_FALSE(is_unstable(0, 0.9, 1));
  CHECK(is_unstable(0, 1.1, 1));
  CHECK_FALSE(is_unstable(0.004, 0.9, 1));
  CHECK(is_unstable(0.004, 1.1, 1));
  CHECK_FALSE(is_unstable(0.004, 1.006, 1));  // 1.002 made, 1.004 is noise
}
