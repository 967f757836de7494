#include "force/law.h"

namespace halfspace {

void LawTable::resize(std::int32_t material_count) {
  Array<std::int32_t> wider(std::size_t(material_count) * std::size_t(material_count), -1,
                            law_of_pair_.get_allocator());
  for (std::int32_t a = 0; a < material_count_; ++a) {
    for (std::int32_t b = 0; b < material_count_; ++b) {
      wider[std::size_t(a * material_count + b)] = law_of_pair_[index(a, b)];
    }
  }
  law_of_pair_ = std::move(wider);
  material_count_ = material_count;
}

void LawTable::set(std::int32_t a, std::int32_t b, const SpringLaw& law) {
  std::int32_t& own = law_of_pair_[index(a, b)];
  if (own < 0) {
    own_.push_back(law);
    own = std::int32_t(own_.size()) - 1;
  } else {
    own_[std::size_t(own)] = law;
  }
  law_of_pair_[index(b, a)] = own;
}

}  // namespace halfspace
