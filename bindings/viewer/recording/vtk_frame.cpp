#include "recording/vtk_frame.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

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
  for (std::size_t place = text.find('<' + name); place != std::string_view::npos;) {
    const std::size_t end = text.find('>', place);
    if (end == std::string_view::npos) return;
    visit(text.substr(place, end - place));
    place = text.find('<' + name, end);
  }
}

/// The arrays behind the XML, each with its length in bytes before it. Each is read once, so that all of them
/// together are no longer than the file.
class RawArrays {
 public:
  RawArrays(std::string_view data, const std::string& file) : data_(data), left_(data.size()), file_(file) {}

  template <class Number>
  std::vector<Number> read(std::size_t offset) {
    std::uint64_t size = 0;
    if (offset > data_.size() || data_.size() - offset < sizeof size) throw incomplete();
    std::memcpy(&size, data_.data() + offset, sizeof size);
    const std::size_t begin = offset + sizeof size;
    if (data_.size() - begin < size || left_ < size) throw incomplete();
    left_ -= size;
    std::vector<Number> values(size / sizeof(Number));
    if (!values.empty()) std::memcpy(values.data(), data_.data() + begin, values.size() * sizeof(Number));
    return values;
  }

 private:
  std::runtime_error incomplete() const { return std::runtime_error(file_ + " is incomplete"); }

  std::string_view data_;
  std::size_t left_;
  const std::string& file_;
};

}  // namespace

VtkFrame::VtkFrame(const std::string& content, std::string file) : file_(std::move(file)) {
  const std::size_t end_of_xml = content.find(begin_of_data);
  if (end_of_xml == std::string::npos) throw std::runtime_error(file_ + " is no frame of a run");
  const std::string_view xml = std::string_view(content).substr(0, end_of_xml);
  RawArrays arrays(std::string_view(content).substr(end_of_xml + begin_of_data.size()), file_);
  for_each_element(xml, "DataArray", [&](std::string_view element) {
    if (attribute(element, "format") != "appended") return;
    const std::string name(attribute(element, "Name"));
    const auto offset = number<std::size_t>(attribute(element, "offset"));
    if (name == "connectivity" || name == "offsets") {
      (name == "offsets" ? offsets_ : connectivity_) = arrays.read<std::int64_t>(offset);
      return;
    }
    Array array{.components =
                    std::max<std::size_t>(number<std::size_t>(attribute(element, "NumberOfComponents")), 1)};
    if (attribute(element, "type") == "Int64") {
      const auto values = arrays.read<std::int64_t>(offset);
      array.values.assign(values.begin(), values.end());
    } else {
      array.values = arrays.read<double>(offset);
    }
    if (name != "points") {
      data_[name] = std::move(array);
      return;
    }
    points_.clear();
    for (std::size_t i = 0; i + 2 < array.values.size(); i += 3)
      points_.push_back({array.values[i], array.values[i + 1], array.values[i + 2]});
  });
  for (const auto& [name, array] : data_)
    if (array.values.size() / array.components != offsets_.size() ||
        array.values.size() % array.components != 0)
      throw std::runtime_error(file_ + ": the array " + name + " has another number of cells");
  for (const std::int64_t point : connectivity_)
    if (point < 0 || static_cast<std::size_t>(point) >= points_.size())
      throw std::runtime_error(file_ + ": a cell has no such point: " + std::to_string(point));
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

std::vector<std::pair<double, std::string>> read_collection(const std::string& content) {
  std::vector<std::pair<double, std::string>> entries;
  for_each_element(content, "DataSet", [&](std::string_view element) {
    entries.emplace_back(number<double>(attribute(element, "timestep")), attribute(element, "file"));
  });
  return entries;
}

}  // namespace halfspace::viewer
