#include "force/law.h"

namespace halfspace {

void LawTable::set(std::int32_t a, std::int32_t b, const SpringLaw& law) {
  std::int32_t& own = law_of_pair_[index(a, b)];
  if (own < 0) {
    own_.push_back(law);
    own = std::int32_t(own_.size()) - 1;
  } else {
    own_[std::size_t(own)] = law;
  }
  knows_potential_ |= law.is_potential();
}

}  // namespace halfspace
