#pragma once

#include <cstdint>
#include <span>

#include "geometry/vector.h"

namespace halfspace {

/// The integrals of a table over an interval.
struct TableIntegrals {
  Vector<3> once = Vector<3>::Zero();
  Vector<3> twice = Vector<3>::Zero();  // of the integral from the begin of the interval
};

/// Values at times, linear between them; before the first and after the last time constant. Two rows at one
/// time are a jump.
class Table {
 public:
  Table(std::span<const double> times, std::span<const Vector<3>> values) : times_(times), values_(values) {}

  std::span<const double> times() const { return times_; }
  std::span<const Vector<3>> values() const { return values_; }
  /// At a jump the later value.
  Vector<3> at(double time) const;
  /// Exact to rounding, also over bends and jumps.
  TableIntegrals integrals(double begin, double duration) const;

 private:
  /// The first row after a time.
  std::size_t row_after(double time) const;
  /// The value on the piece that ends at a row.
  Vector<3> before_row(std::size_t row, double time) const;

  std::span<const double> times_;
  std::span<const Vector<3>> values_;
};

/// The tables of a world.
class Tables {
 public:
  explicit Tables(Memory* memory) : times_(memory), values_(memory), ends_(memory) {}

  std::int32_t count() const { return std::int32_t(ends_.size()); }
  Table operator[](std::int32_t table) const;
  /// Returns the index of the new table. If memory runs out, nothing has changed.
  std::int32_t add(std::span<const double> times, std::span<const Vector<3>> values);

  /// Validates the state read from a snapshot.
  bool is_consistent() const;

  template <class Archive>
  void visit(Archive& archive) {
    archive(times_, values_, ends_);
  }

 private:
  Array<double> times_;  // of all tables, table after table
  Array<Vector<3>> values_;
  Array<std::int64_t> ends_;  // of each table
};

/// The first time that is less than the one before, or the third of its value; the count if there is none.
std::size_t first_out_of_order(std::span<const double> times);

}  // namespace halfspace
