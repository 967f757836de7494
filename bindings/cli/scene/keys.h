#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/faults.h"
#include "scene/scene.h"

namespace halfspace::cli {

/// Marks a key that has no default.
inline constexpr std::nullopt_t required = std::nullopt;

/// The allowed range of a number.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool with_low = true;
  bool with_high = true;

  bool holds(double value) const;
  std::string describe() const;
};

inline Range any_number() { return {}; }
inline Range above(double low) { return {.low = low, .with_low = false}; }
inline Range at_least(double low) { return {.low = low}; }

/// Reads one table of a scene, key by key. An invalid value adds a fault and returns a substitute, so that
/// one pass finds all faults of a file. Call finish() after the last key.
class Keys {
 public:
  /// An empty path is the top of the file. Points have two components until set_dimension().
  Keys(const toml::table& table, std::string path, Faults& faults);

  /// Sets the number of components of points, in this table and in tables read from it afterwards.
  void set_dimension(int dimension) { dimension_ = dimension; }
  int dimension() const { return dimension_; }

  double number(std::string_view key, Range range, std::optional<double> fallback);
  std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high,
                       std::optional<std::int64_t> fallback);
  std::string text(std::string_view key, std::optional<std::string> fallback);
  /// Required. Returns an empty string only with a fault.
  std::string nonempty_text(std::string_view key);
  bool boolean(std::string_view key, bool fallback);
  /// The index of the word among the allowed ones.
  int word(std::string_view key, const std::vector<std::string_view>& allowed, std::optional<int> fallback);
  /// As word(), for a key that selects the other keys: while it is faulty, none of them is reported as
  /// missing or unknown.
  int kind(std::string_view key, const std::vector<std::string_view>& allowed, std::optional<int> fallback);
  bool is_kind_known() const { return is_kind_known_; }
  /// Keys of the file that the kind does not have are left out with a note, as a setting has replaced it.
  void leave_out_others() { leaves_out_others_ = true; }
  /// True if the first of two alternative keys is present.
  bool either(std::string_view key, std::string_view other);
  Point point(std::string_view key, std::optional<Point> fallback);
  std::vector<Point> points(std::string_view key, std::size_t min_count,
                            std::optional<std::vector<Point>> fallback);
  /// Increasing numbers within the range; empty by default.
  std::vector<double> rising_numbers(std::string_view key, Range range);
  /// Rows of numbers, at least one, all of the same length; empty after a fault.
  std::vector<std::vector<double>> rows(std::string_view key, const std::string& allowed);
  /// Exactly `count` whole numbers within a range. @return empty after a fault
  std::vector<std::int64_t> integers(std::string_view key, std::size_t count, std::int64_t low,
                                     std::int64_t high);
  /// Lists of three or more indices, 0 <= index < count; empty by default.
  std::vector<std::vector<int>> loops(std::string_view key, std::size_t count);
  /// A list that is required is not empty.
  std::vector<std::string> texts(std::string_view key, std::vector<Place>& places,
                                 std::optional<std::vector<std::string>> fallback);
  /// The strings of an optional list that may also have tables, which tables_among() reads.
  std::vector<std::string> texts_among(std::string_view key, std::vector<Place>& places);

  /// A [table]; empty if it is optional and missing.
  Keys table(std::string_view key, bool is_required);
  /// The members of a [[table]].
  std::vector<Keys> tables(std::string_view key, bool is_required);
  /// The tables of an optional list that may also have strings; texts_among() reports other members.
  std::vector<Keys> tables_among(std::string_view key);

  bool has(std::string_view key) const { return table_->contains(key); }
  bool has_text(std::string_view key) const { return (*table_)[key].is_string(); }
  /// True if the key is missing and a similar one is present.
  bool is_misspelt(std::string_view key) const;
  bool has_only(std::initializer_list<std::string_view> keys) const;
  /// True if any of these keys is present. All of them are allowed, even if they are not read afterwards.
  bool has_any(std::initializer_list<std::string_view> keys);
  Place place() const;
  Place place(std::string_view key) const;
  std::optional<Place> place_if_given(std::string_view key) const;
  std::string path(std::string_view key) const;
  void fault(std::string_view key, std::string text) { faults_->add(place(key), path(key), std::move(text)); }

  void note(std::string_view key, std::string text) { faults_->note(place(key), path(key), std::move(text)); }

  /// Adds a fault for every key that was not read, or a note if a setting has replaced the kind and the key
  /// resembles none. If it resembles a missing key, only the unknown one is reported.
  void finish();

 private:
  /// A table's header in the file: its path without indices, in brackets.
  std::string header(std::string_view key) const;
  void allow(std::string_view key);
  const toml::node* find(std::string_view key, std::string_view what, bool is_required);
  Keys member(const toml::table& table, std::string_view key, std::size_t index) const;
  /// The list of an optional key; nullptr if it is missing, or no list, which is a fault.
  const toml::array* list_at(std::string_view key, const std::string& allowed);
  std::optional<double> finite_number(const toml::node& node, const std::string& path);
  const char* point_form() const { return dimension_ == 3 ? "[x, y, z]" : "[x, y]"; }
  std::optional<std::vector<int>> loop_of(const toml::node& node, std::size_t count);
  std::optional<Point> point_of(const toml::node& node, const std::string& path);
  void withdraw_missing(std::string_view key);

  const toml::table* table_;
  std::string path_;
  int dimension_ = 2;
  Faults* faults_;
  std::vector<std::string_view> allowed_;
  std::vector<std::pair<std::string_view, std::string_view>> alternatives_;
  std::string_view kind_;
  bool is_kind_known_ = true;
  bool leaves_out_others_ = false;
};

}  // namespace halfspace::cli
