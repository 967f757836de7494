#pragma once

#include <span>
#include <vector>

#include "bare_law.h"
#include "polyhedra.h"
#include "world/contacts/contact_list.h"
#include "world/contacts/force_pass.h"
#include "world/model/model.h"
#include "world/motion/clock.h"
#include "world/motion/continuous_collision.h"
#include "world/motion/integrator.h"
#include "world/motion/penetration_bound.h"
#include "world/motion/stable_step.h"

namespace halfspace::test {

/// A rectangle, or in space a box of these sides.
template <int D>
Shape<D> cuboid(const Vector<D>& sides) {
  if constexpr (D == 2) {
    return shape_of(rectangle(sides[0], sides[1]));
  } else {
    return shape_of(completed(box(sides)));
  }
}
template <int D>
Shape<D> cube() {
  return cuboid<D>(Vector<D>::Ones());
}
/// x and y, and 0 in space.
template <int D>
Vector<D> at(double x, double y) {
  Vector<D> place = Vector<D>::Zero();
  place.template head<2>() = Vector<2>(x, y);
  return place;
}

/// A law per contact with a normal spring and nothing else.
inline ContactLaw normal_spring(double stiffness) {
  ContactLaw law = bare_law();
  law.normal_stiffness = stiffness;
  law.shear_stiffness = 0;
  return law;
}

/// The parts of a world without what orders them: a test calls those that it is about.
template <int D>
struct WorldParts {
  Memory* const memory = std::pmr::get_default_resource();
  Model<D> model;
  Blocks<D>& blocks = model.blocks;
  Clock clock;
  ContactList<D> contacts{model, nullptr, memory};
  NeighborList<D>& neighbors = contacts.neighbors();
  ForcePass<D> forces{model, contacts, nullptr, memory};
  Sleep<D> sleep{memory};
  Share share{memory};
  Integrator<D> integrator{model, neighbors, forces, sleep, share, nullptr, memory};
  StableStep<D> stable_step{model, contacts, memory};
  PenetrationBound<D> spring_stop{model, contacts};
  ContinuousCollision<D> fast_motion{model, contacts, integrator, clock, stable_step, spring_stop, 1, memory};
  PairSums sums;  // of the contacts last found

  explicit WorldParts(const ContactLaw& law, const WorldSettings<D>& settings = {}, double density = 1)
      : model(settings, memory) {
    model.materials.add(density);
    model.materials.laws().set_default(law);
  }

  std::int32_t add(const Shape<D>& shape, BlockKind kind, const Vector<D>& position,
                   const Vector<D>& velocity = Vector<D>::Zero()) {
    contacts.make_room_for_block();
    const std::int32_t slot = blocks.add(shape, kind, 0, model.materials.density(0));
    contacts.add_fresh(slot, blocks.slot_count());
    blocks.place(slot, position, {});
    blocks.set_motion(slot, velocity, Angular<D>::Zero());
    return slot;
  }

  /// Makes the neighbour list, and room for what comes of it.
  void list_neighbors() {
    const bool with_shear =
        model.materials.laws().any([](const ContactLaw& law) { return law.resists_shear(); });
    neighbors.search_again(blocks, {model.settings.skin}, with_shear);
    contacts.fit_room();
    forces.fit_rooms();
    fast_motion.fit_room();
    integrator.resize(blocks.slot_count());
    neighbors.renew(blocks, with_shear);
  }

  /// Finds each listed pair, in their order: one chunk of pairs.
  std::vector<Found> find_contacts() {
    std::vector<Found> found;
    Contact<D> contact;
    sums = {};
    contacts.forget();
    for (std::size_t k = 0; k < neighbors.pairs().size(); ++k) {
      for_spring_kind(model.law_of(neighbors.pairs()[k]).stiffness_kind, [&](auto kind) {
        found.push_back(contacts.template find<kind>(k, contact, sums));
        if (found.back() == Found::apart) return;
        contacts.keep(k, 0, sums);
        contacts.template note_overlap<kind>(contact, sums);
      });
    }
    contacts.end(std::span(&sums, 1));
    return found;
  }

  /// Loads the blocks with the forces of the contacts found.
  ContactEnergy load_blocks(double elapsed = 0) {
    typename ForcePass<D>::Evaluation evaluation = forces.begin(elapsed);
    for (std::size_t c = 0; c < contacts.count(); ++c)
      for_spring_kind(model.law_of(contacts.pair_of(c)).stiffness_kind, [&](auto kind) {
        forces.template load<kind>(contacts.touching()[c], contacts.contact(c), evaluation);
      });
    sums.last_block = evaluation.last_block;
    forces.gather(std::span(&sums, 1));
    return evaluation.energy;
  }
};

}  // namespace halfspace::test
