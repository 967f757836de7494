#include "faults.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace halfspace::cli {

void Faults::add(Place place, std::string key, std::string text) {
  faults_.push_back({place, std::move(key), std::move(text)});
}

std::string Faults::describe(const std::string& file) const {
  std::vector<Fault> sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::string text;
  for (const Fault& fault : sorted) {
    text += file + ':' + std::to_string(fault.place.line) + ':' + std::to_string(fault.place.column) + ": ";
    if (!fault.key.empty()) text += fault.key + ": ";
    text += fault.text + '\n';
  }
  return text;
}

}  // namespace halfspace::cli
