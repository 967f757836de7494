#include <algorithm>
#include <cmath>
#include <cstddef>

#include "prepared_world.h"
#include "refuse_step.h"
#include "sized_struct.h"
#include "strided_view.h"
#include "world_handle.h"
#include "write_contact.h"

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
void require_detected(const World<D>& world) {
  if (!world.state().contacts.are_found()) {
    refuse(HS_ERROR_STATE, "poses, blocks or laws have changed; call hs_world_detect() first");
  }
}

/// Writes the force of a contact.
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

static_assert(int(Meeting::corner_and_face) == HS_PAIR_VERTEX_FACE &&
              int(Meeting::edges) == HS_PAIR_EDGE_EDGE);

template <int D>
std::int64_t contact_count_of(const World<D>& world) {
  return std::int64_t(world.state().contacts.count() + world.state().hard_contacts.count());
}

template <int D>
void write_spring_contact(const World<D>& world, std::size_t c, hs_contact& out) {
  const Blocks<D>& blocks = world.blocks();
  const Candidate<D>& pair = world.state().contacts.pair_of(c);
  const Vector<D>& origin = blocks.position[std::size_t(pair.a)];
  out.block_a = id_of(blocks, std::size_t(pair.a));
  out.block_b = id_of(blocks, std::size_t(pair.b));
  Contact<D> contact = world.state().contacts.contact(c);
  // Forces may not have been evaluated since detection.
  if (world.state().forces.are_known())
    write_force(world.state().forces.of_contact(c), contact.normal, origin, out);
  place(contact, Rotation<D>(), origin);
  write_contact(contact, out);
}

/// Writes a contact constraint of a law without springs. In core the block of the vertex is first, and normal
/// and force point towards it.
template <int D>
void write_constraint(const World<D>& world, const PointContact<D>& at, hs_contact& out) {
  const Blocks<D>& blocks = world.blocks();
  const bool is_turned = at.a > at.b, is_corner = at.meeting == Meeting::corner_and_face;
  out.block_a = id_of(blocks, std::size_t(is_turned ? at.b : at.a));
  out.block_b = id_of(blocks, std::size_t(is_turned ? at.a : at.b));
  out.type = !is_corner ? HS_CONTACT_EDGE_EDGE : D == 2 ? HS_CONTACT_VERTEX_EDGE : HS_CONTACT_VERTEX_FACE;
  out.pair_kind = is_corner && is_turned ? HS_PAIR_FACE_VERTEX : std::int32_t(at.meeting);
  out.feature_a = is_turned ? at.feature_b : at.feature_a;
  out.feature_b = is_turned ? at.feature_a : at.feature_b;
  out.point_count = 1;
  const Vector<D> place = place_of(at.of_a, blocks);
  const Vector<D> normal = is_turned ? at.normal : Vector<D>(-at.normal);
  write_vector(place, out.points[0]);
  write_vector(place, out.center);
  out.gap = out.center_gap = out.gaps[0] = at.gap;
  write_vector(normal, out.normal);
  const Vector<D> force = is_turned ? at.force : Vector<D>(-at.force);
  write_vector(force, out.force);
  write_vector(place, out.force_point);
  out.normal_force = normal.dot(force);
  write_vector(Vector<D>(force - out.normal_force * normal), out.shear_force);
  out.touched_at = at.touched_at;
}

/// Where the impulses of two blocks' manifold act.
template <int D>
void write_rigid_contact(const World<D>& world, const RigidContact<D>& at, hs_contact& out) {
  const Blocks<D>& blocks = world.blocks();
  const Manifold<D>& manifold = at.manifold;
  const std::size_t carrier = std::size_t(is_carried_by_b(manifold) ? at.b : at.a);
  out.block_a = id_of(blocks, std::size_t(at.a));
  out.block_b = id_of(blocks, std::size_t(at.b));
  const bool is_of_edges = manifold.plane == ManifoldPlane::edges;
  out.pair_kind = is_of_edges                 ? HS_PAIR_EDGE_EDGE
                  : is_carried_by_b(manifold) ? HS_PAIR_FACE_VERTEX
                                              : HS_PAIR_VERTEX_FACE;
  (manifold.plane == ManifoldPlane::face_of_b ? out.feature_b : out.feature_a) = manifold.feature;
  if (is_of_edges) out.feature_b = manifold.other_feature;
  out.point_count = manifold.count;
  constexpr std::int32_t in_plane[] = {HS_CONTACT_VERTEX_EDGE, HS_CONTACT_EDGE_EDGE};
  constexpr std::int32_t in_space[] = {HS_CONTACT_VERTEX_FACE, HS_CONTACT_EDGE_FACE, HS_CONTACT_FACE_FACE};
  out.type = is_of_edges ? HS_CONTACT_EDGE_EDGE
             : D == 2    ? in_plane[manifold.count - 1]
                         : in_space[std::min(manifold.count, 3) - 1];
  Vector<D> center = Vector<D>::Zero();
  for (std::size_t i = 0; i < std::size_t(at.manifold.count); ++i) {
    const Vector<D> place = blocks.position[carrier] + blocks.rotation[carrier] * at.manifold.point[i];
    write_vector(place, out.points[i]);
    out.gaps[i] = at.gap[i];
    const double part = 1.0 / at.manifold.count;
    center += part * place;
    out.center_gap += part * at.gap[i];
  }
  out.gap = at.min_gap();
  write_vector(center, out.center);
  write_vector(at.normal, out.normal);
  write_force(world.state().hard_contacts.rigid().load_of(at), at.normal, blocks.position[std::size_t(at.a)],
              out);
  out.touched_at = at.touched_at;
}

template <int D>
void write_hard_contact(const World<D>& world, std::size_t c, hs_contact& out) {
  const Array<PointContact<D>>& points = world.state().hard_contacts.points();
  if (c < points.size()) return write_constraint(world, points[c], out);
  write_rigid_contact(world, world.state().hard_contacts.rigid().all()[c - points.size()], out);
}

template <int D>
void write_report(World<D>& w, hs_world_report* report, std::size_t size) {
  State<D>& state = w.state();
  const Clock& clock = state.clock;
  const Ledger& ledger = state.ledger.entries();
  const double stable = state.stable_step.bound();
  const double overlap = state.largest_overlap();
  const hs_world_report ours = {
      D,
      0,
      clock.steps(),
      clock.time(),
      clock.time_step(),
      std::isfinite(stable) ? stable : 0,
      w.blocks().count(),
      std::int64_t(state.contacts.neighbors().pairs().size()),
      contact_count_of(w),
      state.contacts.neighbors().builds(),
      overlap,
      state.largest_speed(),
      energy_of(ledger),
      w.model().materials.laws().knows_potential() ? w.model().potential_length() : 0,
      ledger.block_strain,
      ledger.block_damping_loss,
      clock.divided_steps(),
      state.penetration_bound.deepest(),
      std::max(state.contacts.peak_overlap(), overlap),
      state.peak_speed,
      state.sleep.count(),
      state.sleep.max_error(clock.time()),
      state.hard_contacts.touches(),
      state.hard_contacts.iterations(),
      ledger.impact_loss,
      state.hard_contacts.unbalanced_velocity(),
      ledger.water,
      state.bolt_strain,
      ledger.bolt_loss};
  write_sized(ours, report, size);
}

}  // namespace

hs_status hs_world_detect(hs_world* world, int64_t* touching) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_copies_in_place(w);
    w.detect();
    if (touching) *touching = std::int64_t(w.state().contacts.count());
    return HS_OK;
  });
}

hs_status hs_world_forces(hs_world* world, double elapsed, hs_mutable_view forces, hs_mutable_view torques) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    require_from_zero(elapsed, "elapsed");
    require_view<D>(forces, "forces");
    require_angular_view<D>(torques, "torques");
    require_detected(w);
    w.evaluate_forces_for_host(elapsed);
    return write_blocks(w.blocks(), w.blocks().force, forces, w.blocks().torque, torques);
  });
}

hs_status hs_world_step(hs_world* world, int64_t steps) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_joined(w);
    require_count(steps, "steps");
    if (steps == 0) w.prepare();
    for (std::int64_t i = 0; i < steps; ++i) require_stepped(w, w.step());
    return HS_OK;
  });
}

hs_status hs_world_get_report(hs_world* world, hs_world_report* report, size_t size) {
  return with_world(world, __func__, [&]<int D>(World<D>& w) {
    require_pointer(report, "report");
    require_report_size(size, offsetof(hs_world_report, energy) + sizeof(hs_energy));
    // Of several shares none evaluates a change alone, as blocks that it has taken over still count in
    // another.
    if (w.state().share.has_losses_of_its_own()) {
      write_report(w, report, size);
    } else {
      query_prepared(*world, w, [&](World<D>& prepared) { write_report(prepared, report, size); });
    }
    return HS_OK;
  });
}

hs_status hs_world_get_contacts(const hs_world* world, hs_contact contacts[], int64_t capacity,
                                int64_t* count) {
  return with_world(world, __func__, [&]<int D>(const World<D>& w) {
    require_count(capacity, "capacity");
    if (capacity > 0) require_pointer(contacts, "contacts");
    const std::int64_t all = contact_count_of(w);
    if (count) *count = all;
    return write_all(all, capacity, [&](int i) {
      const std::size_t c = std::size_t(i);
      contacts[i] = {};
      if (c < w.state().contacts.count()) {
        write_spring_contact(w, c, contacts[i]);
      } else {
        write_hard_contact(w, c - w.state().contacts.count(), contacts[i]);
      }
    });
  });
}

hs_status hs_world_set_shear_force(hs_world* world, hs_block block_a, hs_block block_b,
                                   const double shear_force[3]) {
  return with_world_between_steps(world, __func__, [&]<int D>(World<D>& w) {
    const Vector<D> on_second = read_finite_vector<D>(shear_force, "shear_force");
    const std::int32_t a = slot_of(w.blocks(), block_a, "block_a");
    const std::int32_t b = slot_of(w.blocks(), block_b, "block_b");
    require_detected(w);
    const std::optional<std::size_t> contact = w.state().contacts.contact_between(a, b);
    if (!contact) {
      refuse(HS_ERROR_STALE_ID, "block_a %#llx and block_b %#llx are not in contact",
             static_cast<unsigned long long>(block_a), static_cast<unsigned long long>(block_b));
    }
    // A contact is from the lower slot to the higher.
    if (!w.set_shear_force(*contact, a < b ? on_second : Vector<D>(-on_second))) {
      refuse(HS_ERROR_STATE,
             "the law of block_a and block_b has neither friction nor cohesion, so no shear spring");
    }
    return HS_OK;
  });
}
