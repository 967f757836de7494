#pragma once

#include "bare_law.h"
#include "block/blocks.h"
#include "contacts_3d.h"
#include "force/spring/pressure_room.h"
#include "force/spring/spring.h"

namespace halfspace::test {

/// Two blocks in space and the spring between them, which is evaluated as a world does.
struct TwoBlocks {
  Blocks<3> blocks{std::pmr::get_default_resource()};
  ContactLaw law = bare_law();
  DetectOptions detect;
  PotentialPair<3> pair;
  ShearSpring<3> shear;
  std::int32_t bonded = false;
  // Of the last evaluation.
  Contact<3> contact;
  ContactEnergy energy;

  TwoBlocks(const Shape<3>& a, const Shape<3>& b) {
    for (const Shape<3>* shape : {&a, &b}) {
      const std::int32_t slot = blocks.add(*shape, BlockKind::rigid, 0, 1);
      blocks.place(slot, Vector<3>::Zero(), Rotation<3>());
    }
  }

  Vector<3> to_b() const { return blocks.position[1] - blocks.position[0]; }

  /// The face of one block that looks most along a direction becomes the contact plane.
  void meet_at_face_of(std::int32_t owner, const Vector<3>& direction) {
    const Outline<3> o = blocks.outline(owner);
    int face = 0;
    for (int f = 1; f < o.face_count(); ++f)
      if (o.normal(f).dot(direction) > o.normal(face).dot(direction)) face = f;
    pair = owner == 0 ? PotentialPair<3>{PotentialPair<3>::face_vertex, face, 0}
                      : PotentialPair<3>{PotentialPair<3>::vertex_face, 0, face};
  }

  PairLoad<3> evaluate(double elapsed = 0) {
    const Outline<3> a = blocks.outline(0), b = blocks.outline(1);
    refresh(a, b, to_b(), pair);
    describe_contact(a, b, to_b(), pair, detect, contact);
    const PairMotion<3> motion{blocks.velocity[1] - blocks.velocity[0], to_b(), blocks.spin[0],
                               blocks.spin[1]};
    energy = {};
    const Spring<3> spring{law, 1, elapsed};
    PressureRoom<3> room(std::pmr::get_default_resource());
    return law.is_per_area() ? spring.evaluate(contact, pressure_between(a, b, to_b(), pair, room), motion,
                                               shear, bonded, energy)
                             : spring.evaluate(contact, point_springs(a, b, to_b(), contact), motion, shear,
                                               bonded, energy);
  }
};

/// Along the normal, on b: compression > 0.
inline double normal_force(const PairLoad<3>& load) { return load.normal.dot(load.contact.force); }

}  // namespace halfspace::test
