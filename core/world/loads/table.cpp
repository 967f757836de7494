#include "world/loads/table.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers.h"

namespace halfspace {

std::size_t Table::row_after(double time) const {
  return std::size_t(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
}

Vector<3> Table::before_row(std::size_t row, double time) const {
  if (row == 0) return values_.front();
  if (row == times_.size()) return values_.back();
  const double part = (time - times_[row - 1]) / (times_[row] - times_[row - 1]);
  return (1 - part) * values_[row - 1] + part * values_[row];
}

Vector<3> Table::at(double time) const { return before_row(row_after(time), time); }

/// Times of pieces are counted from the begin, so that they are exact far from time 0.
TableIntegrals Table::integrals(double begin, double duration) const {
  TableIntegrals sum;
  double from = 0;
  Vector<3> first = at(begin);
  const auto add_piece = [&](double to, const Vector<3>& last) {
    const double length = to - from, rest_before = duration - from, rest_after = duration - to;
    sum.once += 0.5 * length * (first + last);
    sum.twice +=
        length / 6 * ((2 * rest_before + rest_after) * first + (rest_before + 2 * rest_after) * last);
  };
  std::size_t row = row_after(begin);
  for (; row < times_.size() && times_[row] - begin < duration; ++row) {
    add_piece(times_[row] - begin, values_[row]);
    from = times_[row] - begin;
    first = values_[row];
  }
  add_piece(duration, before_row(row, begin + duration));
  return sum;
}

Table Tables::operator[](std::int32_t table) const {
  const std::size_t first = table == 0 ? 0 : std::size_t(ends_[std::size_t(table) - 1]);
  const std::size_t rows = std::size_t(ends_[std::size_t(table)]) - first;
  return {std::span(times_).subspan(first, rows), std::span(values_).subspan(first, rows)};
}

std::int32_t Tables::add(std::span<const double> times, std::span<const Vector<3>> values) {
  const std::size_t rows = times_.size() + times.size();
  times_.reserve(rows);
  values_.reserve(rows);
  make_room_for_one(ends_);
  times_.insert(times_.end(), times.begin(), times.end());
  values_.insert(values_.end(), values.begin(), values.end());
  ends_.push_back(std::int64_t(rows));
  return count() - 1;
}

bool Tables::is_consistent() const {
  if (values_.size() != times_.size() || (ends_.empty() && !times_.empty())) return false;
  if (!ends_.empty() && std::size_t(ends_.back()) != times_.size()) return false;
  std::int64_t first = 0;
  for (const std::int64_t end : ends_) {
    if (end <= first || std::size_t(end) > times_.size()) return false;
    const auto times = std::span(times_).subspan(std::size_t(first), std::size_t(end - first));
    if (!all(times, is_finite) || first_out_of_order(times) < times.size()) return false;
    first = end;
  }
  return all(values_, [](const Vector<3>& value) { return value.allFinite(); });
}

std::size_t first_out_of_order(std::span<const double> times) {
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1] || (i > 1 && times[i] == times[i - 2])) return i;
  }
  return times.size();
}

}  // namespace halfspace
