#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "geometry/vector.h"

namespace halfspace {

/// The reference of a stiffness. The values are those of the C API.
enum class StiffnessKind : std::int32_t { per_contact, per_area, potential, none, last = none };

/// The kinds with springs.
#define HALFSPACE_SPRING_KINDS(VISIT) VISIT(per_contact) VISIT(per_area) VISIT(potential)

#define HALFSPACE_COUNT(KIND) +1
static_assert(HALFSPACE_SPRING_KINDS(HALFSPACE_COUNT) == int(StiffnessKind::last),
              "all but one have springs");
#undef HALFSPACE_COUNT

/// One of them, as a constant.
template <StiffnessKind kind>
using SpringKind = std::integral_constant<StiffnessKind, kind>;

/// Calls `visit(kind)` for each kind with springs.
template <class Visit>
void for_each_spring_kind(Visit visit) {
#define HALFSPACE_VISIT(KIND) visit(SpringKind<StiffnessKind::KIND>());
  HALFSPACE_SPRING_KINDS(HALFSPACE_VISIT)
#undef HALFSPACE_VISIT
}

/// Calls `visit(kind)` for one of them.
template <class Visit>
void for_spring_kind(StiffnessKind kind, Visit visit) {
  for_each_spring_kind([&](auto known) {
    if (known == kind) visit(known);
  });
}

/// The numbers of a law.
struct LawNumbers {
  double normal_stiffness = 1e9;  // N/m, Pa/m or, for potentials, Pa
  double shear_stiffness = 0;     // N/m or Pa/m; for potentials N/m; 0: as the normal one
  double friction_angle = 0;      // rad
  double cohesion = 0;            // Pa, until failure
  double tensile_strength = 0;    // Pa, until failure
  double normal_damping = 0.1;    // ratio to critical; at 0, friction on springs excites vibrations
  double shear_damping = 0.1;     // ratio to critical, likewise
  double restitution = 0;         // without springs: velocity after an impact over that before

  /// Those that a strength factor divides, as it does the tangent of the friction angle.
  static constexpr double LawNumbers::*strengths[] = {&LawNumbers::cohesion, &LawNumbers::tensile_strength};
};

/// A penalty law with Mohr-Coulomb friction (Wang et al. 2021, section 3), a potential law with the same
/// friction (Zheng et al. 2020, section 3), or no spring at all (Li et al. 2015, section 4), where stiffness
/// and damping are unused. Its numbers are those that steps read: a shear stiffness, and reduced strengths.
struct ContactLaw : LawNumbers {
  StiffnessKind stiffness_kind;
  std::int32_t reserved = 0;  // explicit padding of saved laws
  double tan_friction;        // tangent of the friction angle, reduced as the strengths
  LawNumbers given;           // by the host

  ContactLaw() : ContactLaw(StiffnessKind::per_contact, {}) {}
  ContactLaw(StiffnessKind kind, const LawNumbers& given);

  bool has_no_spring() const { return stiffness_kind == StiffnessKind::none; }
  bool resists_shear() const {
    return !has_no_spring() && shear_stiffness > 0 && (tan_friction > 0 || bonds());
  }
  bool is_damped() const { return !has_no_spring() && normal_damping + shear_damping > 0; }
  bool is_per_area() const { return stiffness_kind == StiffnessKind::per_area; }
  bool is_potential() const { return stiffness_kind == StiffnessKind::potential; }
  /// Its springs are those of force/spring/point_springs.h.
  bool has_springs_at_points() const { return !is_per_area() && !is_potential() && !has_no_spring(); }
  /// The stiffness of two aligned faces along their normal, N/m. `area`: of both, in 2D their length. By
  /// potentials they repel each other like springs per area of 2 k / H, with the potential length H.
  double face_stiffness(double area, double potential_length) const {
    switch (stiffness_kind) {
      case StiffnessKind::per_contact:
        return normal_stiffness;
      case StiffnessKind::per_area:
        return normal_stiffness * area;
      case StiffnessKind::potential:
        return 2 * normal_stiffness / potential_length * area;
      case StiffnessKind::none:
        break;
    }
    return 0;
  }
  /// The same along the faces.
  double face_shear_stiffness(double area) const {
    if (has_no_spring()) return 0;
    return is_per_area() ? shear_stiffness * area : shear_stiffness;
  }
  bool bonds() const { return cohesion > 0 || tensile_strength > 0; }
  /// The same law with all strengths divided by a factor.
  ContactLaw weaker_by(double factor) const;
  /// False for data of a damaged snapshot.
  bool is_consistent() const;
  /// The larger viscosity of both dashpots, for a spring between blocks of this reduced mass.
  double viscosity(double stiffness, double reduced_mass) const {
    return 2 * std::max(normal_damping, shear_damping) * std::sqrt(stiffness * reduced_mass);
  }
};

/// The law of each pair of materials, or the default.
class LawTable {
 public:
  explicit LawTable(Memory* memory) : own_(memory), law_of_pair_(memory) {}

  std::int32_t material_count() const { return material_count_; }

  /// Adds a material, with the default law for all its pairs.
  void add_material() {
    law_of_pair_.resize(law_of_pair_.size() + std::size_t(material_count_) + 1, -1);
    ++material_count_;
  }
  void set_default(const ContactLaw& law) {
    default_ = law;
    note(law);
  }
  void set(std::int32_t a, std::int32_t b, const ContactLaw& law);

  /// Divides all strengths by a factor.
  void weaken(double factor);

  const ContactLaw& between(std::int32_t a, std::int32_t b) const {
    const std::int32_t own = law_of_pair_[index(a, b)];
    return own < 0 ? default_ : own_[std::size_t(own)];
  }

  /// The law of all pairs without one of their own.
  const ContactLaw& default_law() const { return default_; }
  bool has_own(std::int32_t a, std::int32_t b) const { return law_of_pair_[index(a, b)] >= 0; }

  /// True if a potential law has ever been set; costs no loop over pairs.
  bool knows_potential() const { return knows_potential_; }

  /// The same for a law without a spring.
  bool knows_no_spring() const { return knows_no_spring_; }

  /// True if the condition holds for the law of any pair of materials.
  template <class Condition>
  bool any(Condition condition) const {
    for (std::int32_t index : law_of_pair_) {
      if (condition(index < 0 ? default_ : own_[std::size_t(index)])) return true;
    }
    return false;
  }

  /// False for data of a damaged snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(default_, own_, law_of_pair_, material_count_, knows_potential_, knows_no_spring_);
  }

 private:
  void note(const ContactLaw& law) {
    knows_potential_ |= law.is_potential();
    knows_no_spring_ |= law.has_no_spring();
  }
  /// The index in the lower triangle, row by row: a new material adds a row at the end.
  static std::size_t index(std::int32_t a, std::int32_t b) {
    const std::size_t row = std::size_t(std::max(a, b)), column = std::size_t(std::min(a, b));
    return row * (row + 1) / 2 + column;
  }

  ContactLaw default_;
  Array<ContactLaw> own_;
  Array<std::int32_t> law_of_pair_;  // -1: default
  std::int32_t material_count_ = 0;
  std::int32_t knows_potential_ = 0;
  std::int32_t knows_no_spring_ = 0;
};

}  // namespace halfspace
