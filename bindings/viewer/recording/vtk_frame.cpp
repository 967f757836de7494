#include "recording/vtk_frame.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "recording/bytes.h"

namespace halfspace::viewer {
namespace {

constexpr std::string_view begin_of_data = "<AppendedData encoding=\"raw\">\n_";

/// The value of an attribute in an XML element; empty if it has none.
std::string_view attribute(std::string_view element, const std::string& name) {
  const std::string begin = ' ' + name + "=\"";
  const std::size_t place = element.find(begin);
  if (place == std::string_view::npos) return {};
  const std::string_view rest = element.substr(place + begin.size());
  return rest.substr(0, rest.find('"'));
}

template <class Number>
Number number(std::string_view text) {
  Number value{};
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Calls `visit` with each element of a name.
template <class Visit>
void for_each_element(std::string_view text, const std::string& name, Visit visit) {
  for (std::size_t place = text.find('<' + name); place != std::string_view::npos;
       place = text.find('<' + name, place + 1))
    visit(text.substr(place, text.find('>', place) - place));
}

/// An array behind the XML, with its length in bytes before it.
template <class Number>
std::vector<Number> raw_array(std::string_view data, std::size_t offset, const std::string& file) {
  std::uint64_t size = 0;
  if (offset > data.size() || data.size() - offset < sizeof size)
    throw std::runtime_error(file + " is incomplete");
  std::memcpy(&size, data.data() + offset, sizeof size);
  if (data.size() - offset - sizeof size < size) throw std::runtime_error(file + " is incomplete");
  std::vector<Number> values(size / sizeof(Number));
  if (!values.empty())
    std::memcpy(values.data(), data.data() + offset + sizeof size, values.size() * sizeof(Number));
  return values;
}

}  // namespace

VtkFrame::VtkFrame(const std::string& file) : file_(file) {
  const std::string bytes = bytes_of(file);
  const std::size_t end_of_xml = bytes.find(begin_of_data);
  if (end_of_xml == std::string::npos) throw std::runtime_error(file + " is no frame of a run");
  const std::string_view xml = std::string_view(bytes).substr(0, end_of_xml);
  const std::string_view data = std::string_view(bytes).substr(end_of_xml + begin_of_data.size());
  for_each_element(xml, "DataArray", [&](std::string_view element) {
    if (attribute(element, "format") != "appended") return;
    const std::string name(attribute(element, "Name"));
    const auto offset = number<std::size_t>(attribute(element, "offset"));
    const bool is_whole = attribute(element, "type") == "Int64";
    if (name == "connectivity" || name == "offsets") {
      (name == "offsets" ? offsets_ : connectivity_) = raw_array<std::int64_t>(data, offset, file);
      return;
    }
    Array array{.components =
                    std::max<std::size_t>(number<std::size_t>(attribute(element, "NumberOfComponents")), 1)};
    if (is_whole) {
      const auto values = raw_array<std::int64_t>(data, offset, file);
      array.values.assign(values.begin(), values.end());
    } else {
      array.values = raw_array<double>(data, offset, file);
    }
    if (name != "points") {
      data_[name] = std::move(array);
      return;
    }
    for (std::size_t i = 0; i + 2 < array.values.size(); i += 3)
      points_.push_back({array.values[i], array.values[i + 1], array.values[i + 2]});
  });
  for (const auto& [name, array] : data_)
    if (array.values.size() != array.components * offsets_.size())
      throw std::runtime_error(file + ": the array " + name + " has another number of cells");
  for (const std::int64_t point : connectivity_)
    if (point < 0 || static_cast<std::size_t>(point) >= points_.size())
      throw std::runtime_error(file + ": a cell has no such point: " + std::to_string(point));
}

std::vector<std::size_t> VtkFrame::cell(std::size_t index) const {
  const std::int64_t begin = index == 0 ? 0 : offsets_[index - 1], end = offsets_[index];
  if (begin < 0 || end < begin || static_cast<std::size_t>(end) > connectivity_.size())
    throw std::runtime_error(file_ + ": invalid offsets of cells");
  return {connectivity_.begin() + begin, connectivity_.begin() + end};
}

const VtkFrame::Array& VtkFrame::array(const std::string& name) const {
  const auto found = data_.find(name);
  if (found == data_.end()) throw std::runtime_error(file_ + " has no array " + name);
  return found->second;
}

double VtkFrame::value(const std::string& name, std::size_t cell, std::size_t component) const {
  const Array& values = array(name);
  return component < values.components ? values.values[cell * values.components + component] : 0;
}

std::size_t VtkFrame::index(const std::string& name, std::size_t cell) const {
  const double index = value(name, cell);
  constexpr double limit = 1U << 31;
  if (!(index >= 0 && index < limit)) throw std::runtime_error(file_ + ": invalid " + name);
  return static_cast<std::size_t>(index);
}

Point VtkFrame::vector(const std::string& name, std::size_t cell) const {
  return {value(name, cell, 0), value(name, cell, 1), value(name, cell, 2)};
}

std::vector<std::pair<double, std::string>> read_collection(const std::string& file) {
  const std::string text = bytes_of(file);
  std::vector<std::pair<double, std::string>> entries;
  for_each_element(text, "DataSet", [&](std::string_view element) {
    entries.emplace_back(number<double>(attribute(element, "timestep")), attribute(element, "file"));
  });
  return entries;
}

}  // namespace halfspace::viewer
