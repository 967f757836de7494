#include "force/law.h"

#include <array>
#include <bit>

#include "geometry/angle.h"
#include "geometry/numbers.h"

namespace halfspace {

namespace {

bool are_consistent(const LawNumbers& numbers) {
  using Values = std::array<double, sizeof numbers / sizeof(double)>;
  return all(std::bit_cast<Values>(numbers), is_nonnegative) && numbers.normal_stiffness > 0 &&
         numbers.restitution <= 1;
}

}  // namespace

ContactLaw::ContactLaw(StiffnessKind kind, const LawNumbers& given)
    : LawNumbers(given), stiffness_kind(kind), tan_friction(tangent_of(given.friction_angle)), given(given) {
  if (shear_stiffness == 0) shear_stiffness = normal_stiffness;
}

bool ContactLaw::is_consistent() const {
  return stiffness_kind >= StiffnessKind::per_contact && stiffness_kind <= StiffnessKind::last &&
         are_consistent(*this) && are_consistent(given) && is_nonnegative(tan_friction);
}

ContactLaw ContactLaw::weaker_by(double factor) const {
  ContactLaw weaker = *this;
  weaker.tan_friction /= factor;
  for (double LawNumbers::*strength : strengths) weaker.*strength /= factor;
  return weaker;
}

void LawTable::set(std::int32_t a, std::int32_t b, const ContactLaw& law) {
  std::int32_t& own = law_of_pair_[index(a, b)];
  if (own < 0) {
    own_.push_back(law);
    own = std::int32_t(own_.size()) - 1;
  } else {
    own_[std::size_t(own)] = law;
  }
  note(law);
}

void LawTable::weaken(double factor) {
  default_ = default_.weaker_by(factor);
  for (ContactLaw& law : own_) law = law.weaker_by(factor);
}

bool LawTable::is_consistent() const {
  const std::size_t materials = std::size_t(material_count_);
  const auto names_a_law = [&](std::int32_t index) {
    return index >= -1 && index < std::int64_t(own_.size());
  };
  const auto is_known = [&](const ContactLaw& law) {
    return law.is_consistent() && (knows_potential_ || !law.is_potential()) &&
           (knows_no_spring_ || !law.has_no_spring());
  };
  return material_count_ >= 0 && law_of_pair_.size() == materials * (materials + 1) / 2 &&
         all(law_of_pair_, names_a_law) && is_known(default_) && all(own_, is_known);
}

}  // namespace halfspace
