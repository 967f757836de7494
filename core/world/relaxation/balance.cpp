#include "world/relaxation/balance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {
namespace {

/// Forces on a block or node: the magnitude of their sum, and the sum of their magnitudes.
struct Acting {
  double unbalanced = 0;
  double whole = 0;
};

template <int D>
class Acts {
 public:
  Acts(const Model<D>& model, const Integrator<D>& integrator, BalanceRoom& room)
      : model_(model),
        integrator_(integrator),
        blocks_(model.blocks),
        meshes_(model.blocks.meshes()),
        of_block_(room.of_block),
        of_node_(room.of_node) {
    std::fill(of_block_.begin(), of_block_.end(), 0);
    std::fill(of_node_.begin(), of_node_.end(), 0);
  }

  void add(std::int32_t block, double size) {
    if (!blocks_.is_of_mesh(std::size_t(block))) {
      of_block_[blocks_.mover_of(std::size_t(block))] += size;
      return;
    }
    for (const std::int32_t node : meshes_.surface_of_block(std::size_t(block)).node)
      of_node_[std::size_t(node)] += size / (D + 1);
  }
  void add_elements() {
    meshes_.for_each_element([&]<int N>(const Element<D, N>& element) {
      const auto forces =
          element.elastic_forces(element.field_of(gathered<D, N>(meshes_.place, element.node)),
                                 model_.materials.elasticity(element.material));
      for (int i = 0; i < N; ++i) of_node_[std::size_t(element.node[std::size_t(i)])] += forces.col(i).norm();
    });
  }

  Acting on_block(std::size_t i) const {
    const Vector<D> weight = blocks_.mass[i] * model_.settings.gravity;
    const auto reaction = integrator_.reaction(i);
    Vector<D> applied = blocks_.applied_force[i];
    Angular<D> torque = blocks_.applied_torque[i];
    Tensor<D> virial = Tensor<D>::Zero();
    applied += blocks_.mass[i] * model_.actions.acceleration();
    if (const auto* target = model_.actions.target_of(i)) {
      applied += target->force;
      torque += target->torque;
      virial = target->virial;
    }
    Vector<D> force = blocks_.force[i] + applied + weight + reaction.force;
    double turning = (blocks_.freed_turn(i, blocks_.torque[i] + torque + reaction.torque)).norm();
    double loads = applied.norm() + torque.norm() / blocks_.radius[i];
    if (blocks_.is_affine(i)) {
      const Deformation<D>& deformation = blocks_.deformation(i);
      force += deformation.load_force;
      loads += (deformation.load.norm() + virial.norm()) / blocks_.radius[i];
      turning = (deformation.drive(torque, model_.elasticity_of(i)) + virial + integrator_.strain_reaction(i))
                    .norm();
    }
    force = blocks_.freed(i, force);
    return {force.norm() + turning / blocks_.radius[i], of_block_[i] + weight.norm() + loads};
  }
  Acting on_node(std::size_t i) const {
    const Vector<D> load = integrator_.load_of_actions_on_node(i);
    Vector<D> force = meshes_.force[i] + load + integrator_.reaction_on_node(i);
    for (int k = 0; k < D; ++k) {
      if (meshes_.held[i] >> k & 1) force[k] = 0;
    }
    return {force.norm(), of_node_[i] + meshes_.mass[i] * model_.settings.gravity.norm() +
                              meshes_.applied_force[i].norm() + load.norm()};
  }

 private:
  const Model<D>& model_;
  const Integrator<D>& integrator_;
  const Blocks<D>& blocks_;
  const Meshes<D>& meshes_;
  Array<double>& of_block_;
  Array<double>& of_node_;
};

/// The block of slot i, or the first surface cell at node i - slot_count().
template <int D>
std::int32_t block_at(const Blocks<D>& blocks, std::size_t i) {
  if (i < blocks.slot_count()) return std::int32_t(i);
  const auto node = std::int32_t(i - blocks.slot_count());
  for (std::size_t slot = 0; slot < blocks.slot_count(); ++slot) {
    if (!blocks.is_of_mesh(slot)) continue;
    for (const std::int32_t corner : blocks.meshes().surface_of_block(slot).node) {
      if (corner == node) return std::int32_t(slot);
    }
  }
  return -1;  // inside a body
}

}  // namespace

template <int D>
Balance balance_of(const State<D>& state, BalanceRoom& room) {
  const Model<D>& model = state.model;
  const Blocks<D>& blocks = model.blocks;
  const ContactList<D>& contacts = state.contacts;
  const HardContacts<D>& hard_contacts = state.hard_contacts;
  Acts<D> acts(model, state.integrator, room);
  const auto add_to_both = [&](std::int32_t a, std::int32_t b, double size) {
    acts.add(a, size);
    acts.add(b, size);
  };
  for (std::size_t c = 0; c < contacts.count(); ++c)
    add_to_both(contacts.pair_of(c).a, contacts.pair_of(c).b, state.forces.of_contact(c).force.norm());
  for (const PointContact<D>& contact : hard_contacts.points())
    add_to_both(contact.a, contact.b, contact.force.norm());
  for (const RigidContact<D>& contact : hard_contacts.rigid().all())
    add_to_both(contact.a, contact.b, hard_contacts.rigid().load_of(contact).force.norm());
  for (const Bond<D>& bond : blocks.bonds().all()) {
    if (!bond.is_joint) continue;
    for (const BondPoint<D>& point : blocks.bonds().points_of(bond))
      add_to_both(bond.a, bond.b, point.area * std::hypot(point.normal_traction, point.shear.norm()));
  }
  for (const Bolt<D>& bolt : model.bolts.all()) {
    if (bolt.a >= 0) acts.add(bolt.a, std::abs(bolt.tension));
    if (bolt.b >= 0) acts.add(bolt.b, std::abs(bolt.tension));
  }
  if (!model.water.empty()) {
    for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
      if (blocks.moves_freely(i)) acts.add(std::int32_t(i), model.water_load_on(i).force.norm());
    }
  }
  acts.add_elements();

  Balance balance;
  double unbalanced = 0, whole = 0, count = 0;
  const auto for_each = [&](auto visit) {
    for (std::size_t i = 0; i < blocks.slot_count(); ++i) {
      if (blocks.moves_by_itself(i)) visit(acts.on_block(i), i);
    }
    for (std::size_t i = 0; i < blocks.meshes().node_count(); ++i)
      visit(acts.on_node(i), blocks.slot_count() + i);
  };
  std::size_t at = 0;
  for_each([&](const Acting& acting, std::size_t i) {
    unbalanced += acting.unbalanced;
    whole += acting.whole;
    ++count;
    if (acting.unbalanced <= balance.largest_force) return;
    balance.largest_force = acting.unbalanced;
    at = i;
  });
  if (balance.largest_force > 0) balance.block = block_at(blocks, at);
  if (whole == 0) {
    balance.mean = balance.largest = unbalanced > 0 ? 1 : 0;
    return balance;
  }
  balance.mean = unbalanced / whole;
  const double typical = whole / count;
  for_each([&](const Acting& acting, std::size_t) {
    balance.largest = std::max(balance.largest, acting.unbalanced / std::max(acting.whole, typical));
  });
  return balance;
}

/// Only the translation of free blocks and nodes counts.
template <int D>
double SlowestMotion<D>::look() {
  const Blocks<D>& blocks = model_.blocks;
  const Meshes<D>& meshes = blocks.meshes();
  const std::size_t slots = blocks.slot_count();
  double stiffness = 0, inertia = 0;
  const auto note = [&](std::size_t i, double mass, const Vector<D>& place, const Vector<D>& force) {
    const Vector<D> moved = place - places_[i];
    stiffness -= moved.dot(force - forces_[i]);
    inertia += mass * moved.squaredNorm();
    places_[i] = place;
    forces_[i] = force;
  };
  for (std::size_t i = 0; i < slots; ++i) {
    if (blocks.moves_by_itself(i))
      note(i, blocks.mass[i], blocks.position[i], blocks.force[i] + blocks.applied_force[i]);
  }
  for (std::size_t i = 0; i < meshes.node_count(); ++i) {
    Vector<D> force = meshes.force[i], place = meshes.place[i];
    for (int k = 0; k < D; ++k) {
      if (meshes.held[i] >> k & 1) force[k] = place[k] = 0;
    }
    note(slots + i, meshes.mass[i], place, force);
  }
  const bool is_known = std::exchange(has_looked_, true) && stiffness > 0 && inertia > 0;
  return is_known ? 2 * std::sqrt(stiffness / inertia) : -1;
}

template class SlowestMotion<2>;
template class SlowestMotion<3>;
template Balance balance_of(const State<2>&, BalanceRoom&);
template Balance balance_of(const State<3>&, BalanceRoom&);

}  // namespace halfspace
