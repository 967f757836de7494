#pragma once

#include <cstdint>

#include "geometry/vector.h"

namespace halfspace {

/// What a stiffness refers to. The values are those of the C API.
enum class StiffnessKind : std::int32_t { per_contact = 0, per_area = 1 };

/// Penalty spring with Mohr-Coulomb friction (Wang et al. 2021, section 3).
struct SpringLaw {
  StiffnessKind stiffness_kind = StiffnessKind::per_contact;
  std::int32_t reserved = 0;     // so that saved laws have no padding
  double normal_stiffness = 1e9;  // N/m or Pa/m
  double shear_stiffness = 1e9;   // N/m or Pa/m
  double friction_angle = 0;      // rad
  double tan_friction = 0;        // of the friction angle
  double cohesion = 0;            // Pa, of intact contacts
  double tensile_strength = 0;    // Pa, of intact contacts
  double normal_damping = 0;      // share of critical
  double shear_damping = 0;       // share of critical

  bool resists_shear() const { return shear_stiffness > 0 && (tan_friction > 0 || bonds()); }
  bool bonds() const { return cohesion > 0 || tensile_strength > 0; }
};

/// The law of each pair of materials, or the default.
class LawTable {
 public:
  explicit LawTable(Memory* memory) : own_(memory), law_of_pair_(memory) {}

  void resize(std::int32_t material_count);
  void set_default(const SpringLaw& law) { default_ = law; }
  void set(std::int32_t a, std::int32_t b, const SpringLaw& law);

  const SpringLaw& between(std::int32_t a, std::int32_t b) const {
    const std::int32_t own = law_of_pair_[index(a, b)];
    return own < 0 ? default_ : own_[std::size_t(own)];
  }

  /// True when the condition holds for a law that some pair of materials has.
  template <class Condition>
  bool any(Condition condition) const {
    for (std::int32_t index : law_of_pair_) {
      if (condition(index < 0 ? default_ : own_[std::size_t(index)])) return true;
    }
    return false;
  }

  template <class Archive>
  void visit(Archive& archive) {
    archive(default_, own_, law_of_pair_, material_count_);
  }

 private:
  std::size_t index(std::int32_t a, std::int32_t b) const { return std::size_t(a * material_count_ + b); }

  SpringLaw default_;
  Array<SpringLaw> own_;
  Array<std::int32_t> law_of_pair_;  // material_count^2, -1: default
  std::int32_t material_count_ = 0;
};

}  // namespace halfspace
