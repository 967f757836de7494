#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "contact.h"
#include "view.h"
#include "world.h"

using namespace halfspace;
using namespace halfspace::capi;

namespace {

hs_energy energy_of(const Ledger& ledger) {
  return {ledger.kinetic,
          ledger.gravity,
          ledger.strain,
          ledger.friction_loss,
          ledger.contact_damping_loss,
          ledger.local_damping_loss,
          ledger.mass_damping_loss,
          ledger.outer_work,
          ledger.residual()};
}

template <int D>
double largest_overlap(const World<D>& world) {
  double overlap = 0;
  for (std::size_t c = 0; c < world.contact_count(); ++c) overlap = std::max(overlap, -world.contact(c).gap);
  return overlap;
}

template <int D>
double largest_speed(const Blocks<D>& blocks) {
  double squared = 0;
  for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
    if (blocks.moves_freely(i)) squared = std::max(squared, blocks.velocity[i].squaredNorm());
  }
  return std::sqrt(squared);
}

template <int D>
void require_detected(const World<D>& world) {
  if (!world.is_detected()) {
    refuse(HS_ERROR_STATE, "poses, blocks or laws have changed; call hs_world_detect() first");
  }
}

/// Contacts are sorted as their pairs are.
template <int D>
std::size_t contact_index(const World<D>& world, std::int32_t a, std::int32_t b) {
  const auto wanted = std::minmax(a, b);
  std::size_t first = 0, last = world.contact_count();
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    const Candidate<D>& pair = world.candidate_of(middle);
    if (std::pair(pair.a, pair.b) < std::pair(wanted.first, wanted.second)) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  const bool found = first < world.contact_count() && world.candidate_of(first).a == wanted.first &&
                     world.candidate_of(first).b == wanted.second;
  if (!found) {
    const auto id = [&](std::int32_t slot) {
      return static_cast<unsigned long long>(id_of(world.blocks(), std::size_t(slot)));
    };
    refuse(HS_ERROR_STALE_ID, "block_a %#llx and block_b %#llx are not in contact", id(a), id(b));
  }
  return first;
}

/// What the contact does to its blocks, as far as forces have been evaluated.
template <int D>
void write_force(const ContactForce<D>& force, const Vector<D>& normal, const Vector<D>& origin,
                 hs_contact& out) {
  write_vector(force.force, out.force);
  write_vector(Vector<D>(force.point + origin), out.force_point);
  out.normal_force = normal.dot(force.force);
  write_vector(Vector<D>(force.force - out.normal_force * normal), out.shear_force);
  write_angular(force.couple, out.torque);
  if constexpr (D == 3) out.twist = force.couple.dot(normal);
}

}  // namespace

hs_status hs_world_detect(hs_world* world, int64_t* touching) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    w.detect();
    if (touching) *touching = std::int64_t(w.contact_count());
    return HS_OK;
  });
}

hs_status hs_world_forces(hs_world* world, double elapsed, hs_mutable_view forces, hs_mutable_view torques) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_from_zero(elapsed, "elapsed");
    require_view<D>(forces, "forces");
    require_angular_view<D>(torques, "torques");
    require_detected(w);
    w.evaluate_forces_for_host(elapsed);
    const Blocks<D>& all = w.blocks();
    for_each_block(all, [&](std::int64_t i, std::int32_t slot) {
      if (i < forces.count) write_point(forces, i, all.force[std::size_t(slot)]);
      if (i < torques.count) write_angular(torques, i, all.torque[std::size_t(slot)]);
    });
    const bool all_turns = torques.count == 0 || torques.count >= all.count();
    return all_turns ? fits(all.count(), forces.count) : HS_NOTE_TRUNCATED;
  });
}

hs_status hs_world_step(hs_world* world, int64_t steps) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_count(steps, "steps");
    for (std::int64_t i = 0; i < steps; ++i) {
      const StepResult result = w.step();
      if (result == StepResult::no_time_step) {
        refuse(HS_ERROR_STATE,
               "no time step was given, and without blocks that move freely none can be derived");
      }
      if (result == StepResult::too_fast) {
        const FastPair& pair = w.fast_pair();
        refuse(HS_ERROR_TOO_FAST,
               "blocks %#llx and %#llx meet at time %g (step %lld) by up to %g m/s: too fast for the time "
               "step %g "
               "where the thinner is %g m thick; a step of %g would do",
               static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.a))),
               static_cast<unsigned long long>(id_of(w.blocks(), std::size_t(pair.b))), w.time(),
               static_cast<long long>(w.steps()), pair.speed, w.time_step(), pair.thickness, pair.time_step);
      }
      if (result == StepResult::unstable) {
        refuse(HS_ERROR_UNSTABLE, "unstable at time %g (step %lld): time step %g, stable time step %g",
               w.time(), static_cast<long long>(w.steps()), w.time_step(), w.stable_time_step());
      }
    }
    return HS_OK;
  });
}

hs_status hs_world_get_report(hs_world* world, hs_world_report* report, size_t size) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(report, "report");
    require_report_size(size, offsetof(hs_world_report, energy) + sizeof(hs_energy));
    w.prepare();  // energies and the time step of a world that has been changed
    const double stable = w.stable_time_step();
    const double overlap = largest_overlap(w);
    const hs_world_report ours = {D,
                                  0,
                                  w.steps(),
                                  w.time(),
                                  w.time_step(),
                                  std::isfinite(stable) ? stable : 0,
                                  w.blocks().count(),
                                  std::int64_t(w.candidates().pairs().size()),
                                  std::int64_t(w.contact_count()),
                                  w.candidates().builds(),
                                  overlap,
                                  largest_speed(w.blocks()),
                                  energy_of(w.ledger()),
                                  w.knows_potential() ? w.potential_length() : 0,
                                  w.ledger().block_strain,
                                  w.ledger().block_damping_loss,
                                  w.divided_steps(),
                                  w.deepest_stop(),
                                  std::max(w.peak_overlap(), overlap),
                                  w.peak_speed()};
    write_sized(ours, report, size);
    return HS_OK;
  });
}

hs_status hs_world_get_contacts(const hs_world* world, hs_contact contacts[], int64_t capacity,
                                int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(contacts, "contacts");
    const Blocks<D>& blocks = w.blocks();
    const std::int64_t all = std::int64_t(w.contact_count());
    for (std::int64_t i = 0; i < std::min(all, capacity); ++i) {
      const std::size_t c = std::size_t(i);
      const Candidate<D>& pair = w.candidate_of(c);
      const Vector<D>& origin = blocks.position[std::size_t(pair.a)];
      hs_contact& out = contacts[i];
      out = {};
      const Contact<D> contact = w.contact(c);
      write_contact(contact, Rotation<D>(), origin, out);
      out.block_a = id_of(blocks, std::size_t(pair.a));
      out.block_b = id_of(blocks, std::size_t(pair.b));
      if (!w.knows_forces()) continue;  // detected, but forces not evaluated yet
      write_force(w.contact_force(c), contact.normal, origin, out);
    }
    if (count) *count = all;
    return fits(all, capacity);
  });
}

hs_status hs_world_set_shear_force(hs_world* world, hs_block block_a, hs_block block_b,
                                   const double shear_force[3]) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    const Vector<D> on_second = read_finite_vector<D>(shear_force, "shear_force");
    const std::int32_t a = slot_of(w.blocks(), block_a, "block_a");
    const std::int32_t b = slot_of(w.blocks(), block_b, "block_b");
    require_detected(w);
    // The contact is from the lower slot to the higher.
    if (!w.set_shear_force(contact_index(w, a, b), a < b ? on_second : Vector<D>(-on_second))) {
      refuse(HS_ERROR_STATE, "the law between block_a and block_b has no friction and no shear spring");
    }
    return HS_OK;
  });
}
