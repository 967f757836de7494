#include "scene/faults.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace halfspace::cli {

void Faults::add(Place place, std::string key, std::string text) {
  faults_.push_back({place, std::move(key), std::move(text)});
}

void Faults::note(Place place, std::string key, std::string text) {
  notes_.push_back({place, std::move(key), std::move(text)});
}

void Faults::withdraw_missing(const std::string& key) {
  std::erase_if(faults_,
                [&](const Fault& fault) { return fault.key == key && fault.text.starts_with("missing"); });
}

namespace {

std::string described(const Place& place, const std::string& file, const std::vector<std::string>& settings) {
  if (place.is_setting) return file + ": --set " + settings.at(static_cast<std::size_t>(place.line) - 1);
  return file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

std::string lines_of(std::vector<Fault> faults, const std::string& file,
                     const std::vector<std::string>& settings, const std::string& mark) {
  std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
    return std::tie(a.place.is_setting, a.place.line, a.place.column) <
           std::tie(b.place.is_setting, b.place.line, b.place.column);
  });
  std::string text;
  for (const Fault& fault : faults) {
    text += described(fault.place, file, settings) + ": " + mark;
    if (!fault.key.empty()) text += fault.key + ": ";
    text += fault.text + '\n';
  }
  return text;
}

}  // namespace

std::string Faults::describe(const std::string& file) const { return lines_of(faults_, file, settings_, ""); }

std::string Faults::describe_notes(const std::string& file) const {
  return lines_of(notes_, file, settings_, "note: ");
}

}  // namespace halfspace::cli
