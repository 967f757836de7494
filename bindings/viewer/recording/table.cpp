#include "recording/table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "recording/encoding.h"

namespace halfspace::viewer {
namespace {

constexpr double unset = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t max_samples = 8192;
constexpr std::size_t max_columns = 255;  // a byte of the page
constexpr double negligible = 1e-6;       // over the largest value so far

bool is_float(Coding coding) { return coding == Coding::rounded || coding == Coding::coarse; }

/// The bits of a float that are left out.
int dropped_bits(Coding coding) { return coding == Coding::coarse ? 19 : 16; }

/// A value as the whole number that stands for it.
std::int64_t code_of(const Column& column, double value) {
  if (column.coding == Coding::lattice) {
    constexpr double limit = 1U << 30;
    return std::llround(std::clamp(value / column.step, -limit, limit));
  }
  if (column.coding == Coding::flag) return std::isnan(value) ? 0 : std::llround(value);
  const int dropped = dropped_bits(column.coding);
  const std::int64_t bits = std::bit_cast<std::uint32_t>(std::abs(static_cast<float>(value)));
  const std::int64_t code = (bits + (1LL << (dropped - 1))) >> dropped;
  return value < 0 ? -code : code;
}

/// The codes of all frames. Where a value is unset, a flag is 0, and another column keeps the value that it
/// has before or, ahead of the first one, afterwards.
std::vector<std::vector<std::int64_t>> codes_of(const Column& column, std::size_t item_count) {
  std::vector<std::vector<std::int64_t>> codes(column.frames.size(), std::vector<std::int64_t>(item_count));
  for (std::size_t item = 0; item < item_count; ++item) {
    const auto value_at = [&](std::size_t f) {
      return item < column.frames[f].size() ? column.frames[f][item] : unset;
    };
    std::int64_t code = 0;
    for (std::size_t f = 0; f < codes.size(); ++f) {
      if (std::isnan(value_at(f))) continue;
      code = code_of(column, value_at(f));
      break;
    }
    for (std::size_t f = 0; f < codes.size(); ++f) {
      if (column.coding == Coding::flag || !std::isnan(value_at(f))) code = code_of(column, value_at(f));
      codes[f][item] = code;
    }
  }
  return codes;
}

/// The codes of all frames, and how often the differences from frame to frame were taken.
struct Codes {
  std::vector<std::vector<std::int64_t>> frames;
  int order = 0;
};

/// The differences between consecutive frames, of numbers of 32 bits that wrap around; the first frame
/// remains.
Codes differences_of(Codes codes) {
  for (std::size_t f = codes.frames.size(); f-- > 1;)
    for (std::size_t i = 0; i < codes.frames[f].size(); ++i)
      codes.frames[f][i] = static_cast<std::int32_t>(codes.frames[f][i] - codes.frames[f - 1][i]);
  ++codes.order;
  return codes;
}

/// Small for numbers near 0 of either sign.
std::uint64_t zigzag(std::int64_t value) {
  return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}

/// The byte of all values at this place, the lowest one first.
std::string plane_of(const Codes& codes, int plane) {
  std::string bytes;
  for (const auto& frame : codes.frames)
    for (const std::int64_t value : frame) bytes += static_cast<char>(zigzag(value) >> 8 * plane & 255);
  return bytes;
}

/// All bytes of the values but those that are 0 in every one.
std::vector<std::string> planes_of(const Codes& codes) {
  std::uint64_t united = 0;
  for (const auto& frame : codes.frames)
    for (const std::int64_t value : frame) united |= zigzag(value);
  std::vector<std::string> planes;
  for (int plane = 0; united >> 8 * plane != 0; ++plane) planes.push_back(plane_of(codes, plane));
  return planes;
}

/// The entropy of the bytes in bits: about their size when compressed.
double entropy_of(const std::string& bytes) {
  std::array<std::size_t, 256> counts{};
  for (const char byte : bytes) ++counts[static_cast<unsigned char>(byte)];
  double entropy = 0;
  for (const std::size_t count : counts)
    if (count > 0)
      entropy += static_cast<double>(count) *
                 std::log2(static_cast<double>(bytes.size()) / static_cast<double>(count));
  return entropy;
}

double entropy_of(const std::vector<std::string>& planes) {
  double sum = 0;
  for (const std::string& plane : planes) sum += entropy_of(plane);
  return sum;
}

/// The order of differences with the smallest entropy, the bytes per number, then the planes of bytes.
void append(std::string& bytes, const Column& column, std::size_t item_count) {
  constexpr int max_order = 2;
  Codes codes{codes_of(column, item_count)};
  std::vector<std::string> planes = planes_of(codes);
  int order = 0;
  while (codes.order < max_order) {
    codes = differences_of(std::move(codes));
    std::vector<std::string> others = planes_of(codes);
    if (entropy_of(others) >= entropy_of(planes)) continue;
    planes = std::move(others);
    order = codes.order;
  }
  bytes += static_cast<char>(order);
  bytes += static_cast<char>(planes.size());
  for (const std::string& plane : planes) bytes += plane;
}

}  // namespace

void Range::add(double value) {
  if (!std::isfinite(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
  if (passed++ % stride != 0) return;
  samples.push_back(value);
  if (samples.size() < max_samples) return;
  for (std::size_t i = 0; i < samples.size() / 2; ++i) samples[i] = samples[2 * i];
  samples.resize(samples.size() / 2);
  stride *= 2;
}

double Range::quantile(double fraction) const {
  if (samples.empty()) return unset;
  std::vector<double> sorted = samples;
  const auto place = static_cast<std::size_t>(std::lround(fraction * static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place), sorted.end());
  return sorted[place];
}

Table::Table(std::string name, std::vector<Column> columns)
    : name_(std::move(name)), columns_(std::move(columns)), ranges_(columns_.size()) {}

std::size_t Table::column(const std::string& name, const std::string& unit) {
  for (std::size_t c = 0; c < columns_.size(); ++c)
    if (columns_[c].name == name) return c;
  if (columns_.size() == max_columns)
    throw std::length_error("cannot add the field " + name + ": there are " + std::to_string(max_columns));
  columns_.push_back({.name = name, .unit = unit});
  columns_.back().frames.resize(frame_count_);
  ranges_.emplace_back();
  return columns_.size() - 1;
}

void Table::begin_frame() {
  ++frame_count_;
  for (Column& column : columns_) column.frames.emplace_back();
}

void Table::set(std::size_t column, std::size_t item, double value, bool is_in_range) {
  std::vector<double>& frame = columns_[column].frames.back();
  item_count_ = std::max(item_count_, item + 1);
  if (frame.size() <= item) frame.resize(item + 1, unset);
  frame[item] = value;
  if (is_in_range) ranges_[column].add(value);
  // Rounding errors at rest would be most of the page.
  const double largest = std::max(std::abs(ranges_[column].low), std::abs(ranges_[column].high));
  if (is_float(columns_[column].coding) && std::isfinite(largest) && std::abs(value) < negligible * largest)
    frame[item] = 0;
}

std::string Table::pack() const {
  std::string bytes;
  for (int plane = 0; plane < 4; ++plane) bytes += static_cast<char>(item_count_ >> 8 * plane & 255);
  bytes += static_cast<char>(columns_.size());
  for (const Column& column : columns_) append(bytes, column, item_count_);
  return bytes;
}

void Table::clear(bool keeps_items) {
  for (Column& column : columns_) column.frames.clear();
  frame_count_ = 0;
  if (!keeps_items) item_count_ = 0;
}

std::string Table::description() const {
  std::string text = "{\"name\":" + json(name_) + ",\"columns\":[";
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const Column& column = columns_[c];
    text += std::string(c > 0 ? "," : "") + "{\"name\":" + json(column.name) +
            ",\"unit\":" + json(column.unit) +
            (is_float(column.coding) ? ",\"dropped_bits\":" + std::to_string(dropped_bits(column.coding))
                                     : ",\"step\":" + json(column.step)) +
            ",\"low\":" + json(ranges_[c].low) + ",\"high\":" + json(ranges_[c].high) +
            ",\"usual_low\":" + json(ranges_[c].quantile(0.01)) +
            ",\"usual_high\":" + json(ranges_[c].quantile(0.99)) + '}';
  }
  return text + "]}";
}

}  // namespace halfspace::viewer
