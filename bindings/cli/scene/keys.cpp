#include "scene/keys.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "common/suggestion.h"
#include "common/text.h"
#include "scene/settings.h"

namespace halfspace::cli {
namespace {

const toml::table no_keys;

/// A value for error texts, in nearly its form in the file.
std::string shown(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (const auto* text = node.as_string()) return '"' + text->get() + '"';
  std::ostringstream stream;
  node.visit([&stream](const auto& value) { stream << value; });
  const std::string text = stream.str();
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

/// Renamed keys: the old and the new name. Old names are still read, with a note.
constexpr std::pair<std::string_view, std::string_view> renamed_keys[] = {{"most_steps", "max_steps"},
                                                                          {"spread", "jitter"}};

/// The value of a key, under its new or its old name.
const toml::node* value_of(const toml::table& table, std::string_view key) {
  if (const toml::node* node = table.get(key)) return node;
  for (const auto& [before, now] : renamed_keys)
    if (key == now) return table.get(before);
  return nullptr;
}

/// The new name of a renamed key, or empty.
std::string_view new_name(std::string_view key) {
  for (const auto& [before, now] : renamed_keys)
    if (key == before) return now;
  return {};
}

}  // namespace

bool Range::holds(double value) const {
  return (with_low ? value >= low : value > low) && (with_high ? value <= high : value < high);
}

std::string Range::describe() const {
  std::string text = "a number";
  if (std::isfinite(low)) text += (with_low ? ", at least " : " above ") + shortest(low);
  if (std::isfinite(high)) text += (with_high ? ", at most " : ", below ") + shortest(high);
  return text;
}

Keys::Keys(const toml::table& table, std::string path, Faults& faults)
    : table_(&table), path_(std::move(path)), faults_(&faults) {}

Place Keys::place() const { return place_of(table_->source()); }

Place Keys::place(std::string_view key) const {
  const toml::node* node = value_of(*table_, key);
  return place_of((node ? *node : *table_).source());
}

std::optional<Place> Keys::place_if_given(std::string_view key) const {
  return has(key) ? std::optional(place(key)) : std::nullopt;
}

std::string Keys::path(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + '.' + std::string(key);
}

void Keys::allow(std::string_view key) {
  if (std::find(allowed_.begin(), allowed_.end(), key) == allowed_.end()) allowed_.push_back(key);
}

bool Keys::has_any(std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) allow(key);
  return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return has(key); });
}

const toml::node* Keys::find(std::string_view key, std::string_view what, bool is_required) {
  allow(key);
  const toml::node* node = value_of(*table_, key);
  const bool is_reported = table_ == &no_keys;  // its absence is a fault already, or allowed
  if (!node && is_required && !is_reported) fault(key, "missing; required: " + std::string(what));
  return node;
}

std::optional<double> Keys::finite_number(const toml::node& node, const std::string& path) {
  const std::optional<double> value = node.value<double>();
  if (node.is_number() && value && std::isfinite(*value)) return value;
  const char* wrong = node.is_number() ? "not finite: " : "not a number: ";
  faults_->add(place_of(node.source()), path, wrong + shown(node) + "; allowed: a finite number");
  return {};
}

double Keys::number(std::string_view key, Range range, std::optional<double> fallback) {
  const toml::node* node = find(key, range.describe(), !fallback);
  if (node) {
    const std::optional<double> value = finite_number(*node, path(key));
    if (value && range.holds(*value)) return *value;
    if (value) fault(key, "out of range: " + shown(*node) + "; allowed: " + range.describe());
  }
  // A substitute that no other key can exceed.
  return fallback.value_or(std::numeric_limits<double>::infinity());
}

std::int64_t Keys::integer(std::string_view key, std::int64_t low, std::int64_t high,
                           std::optional<std::int64_t> fallback) {
  std::string allowed = low == high ? std::to_string(low) : "a whole number, at least " + std::to_string(low);
  if (low < high && high < std::numeric_limits<std::int64_t>::max())
    allowed += ", at most " + std::to_string(high);
  const toml::node* node = find(key, allowed, !fallback);
  if (node) {
    const toml::value<std::int64_t>* value = node->as_integer();
    if (value && value->get() >= low && value->get() <= high) return value->get();
    fault(key, (value ? "out of range: " : "not a whole number: ") + shown(*node) + "; allowed: " + allowed);
  }
  return fallback.value_or(low);
}

std::string Keys::text(std::string_view key, std::optional<std::string> fallback) {
  const toml::node* node = find(key, "a string", !fallback);
  if (node) {
    if (const toml::value<std::string>* value = node->as_string()) return value->get();
    fault(key, "not a string: " + shown(*node) + "; allowed: a string in quotes");
  }
  return fallback.value_or("");
}

std::string Keys::nonempty_text(std::string_view key) {
  const std::string value = text(key, required);
  if (value.empty() && has_text(key)) fault(key, "empty; allowed: a string of at least one letter");
  return value;
}

bool Keys::boolean(std::string_view key, bool fallback) {
  const toml::node* node = find(key, "true or false", false);
  if (node) {
    if (const toml::value<bool>* value = node->as_boolean()) return value->get();
    fault(key, "not a boolean: " + shown(*node) + "; allowed: true or false");
  }
  return fallback;
}

int Keys::word(std::string_view key, const std::vector<std::string_view>& allowed,
               std::optional<int> fallback) {
  const toml::node* node = find(key, joined(allowed), !fallback);
  if (node) {
    const toml::value<std::string>* value = node->as_string();
    const auto found = value ? std::find(allowed.begin(), allowed.end(), value->get()) : allowed.end();
    if (found != allowed.end()) return static_cast<int>(found - allowed.begin());
    const std::string near = value ? suggestion(value->get(), allowed) : "";
    fault(key, "unknown word: " + shown(*node) + near + "; allowed: " + joined(allowed));
  }
  return fallback.value_or(0);
}

std::optional<Point> Keys::point_of(const toml::node& node, const std::string& path) {
  const toml::array* components = node.as_array();
  const auto count = static_cast<std::size_t>(dimension_);
  if (!components || components->size() != count) {
    faults_->add(place_of(node.source()), path, "not a point: " + shown(node) + "; allowed: " + point_form());
    return {};
  }
  Point point{};
  bool whole = true;
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> component = finite_number((*components)[i], path);
    if (component) point[i] = *component;
    whole = whole && component;
  }
  return whole ? std::optional(point) : std::nullopt;
}

Point Keys::point(std::string_view key, std::optional<Point> fallback) {
  const toml::node* node = find(key, point_form(), !fallback);
  return (node ? point_of(*node, path(key)) : fallback).value_or(Point{});
}

std::vector<Point> Keys::points(std::string_view key, std::size_t min_count,
                                std::optional<std::vector<Point>> fallback) {
  const std::string form = point_form();
  const std::string allowed =
      '[' + form + ", " + form + ", ...] with " + std::to_string(min_count) + " points or more";
  const toml::node* node = find(key, allowed, !fallback);
  if (!node) return fallback.value_or(std::vector<Point>{});
  const toml::array* list = node->as_array();
  if (!list || list->size() < min_count) {
    fault(key,
          (list ? "too few points: " : "not a list of points: ") + shown(*node) + "; allowed: " + allowed);
    return {};
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::optional<Point> point = point_of((*list)[i], path(key) + '[' + std::to_string(i) + ']');
    if (point) points.push_back(*point);
  }
  return points.size() == list->size() ? points : std::vector<Point>{};
}

const toml::array* Keys::list_at(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key, allowed, false);
  if (!node) return nullptr;
  const toml::array* list = node->as_array();
  if (!list) fault(key, "not a list: " + shown(*node) + "; allowed: " + allowed);
  return list;
}

std::vector<double> Keys::rising_numbers(std::string_view key, Range range) {
  const std::string allowed = "a list of increasing numbers, each " + range.describe();
  const toml::array* list = list_at(key, allowed);
  if (!list) return {};
  std::vector<double> numbers;
  for (const toml::node& item : *list) {
    const std::optional<double> value = finite_number(item, path(key));
    if (!value) continue;
    if (!range.holds(*value) || (!numbers.empty() && *value <= numbers.back())) {
      faults_->add(place_of(item.source()), path(key),
                   "out of range: " + shown(item) + "; allowed: " + allowed);
    }
    numbers.push_back(*value);
  }
  return numbers;
}

std::vector<std::vector<double>> Keys::rows(std::string_view key, const std::string& allowed) {
  const toml::node* node = find(key, allowed, true);
  if (!node) return {};
  const toml::array* list = node->as_array();
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const toml::array* row = (*list)[i].as_array();
    std::vector<double> numbers;
    for (std::size_t k = 0; row && k < row->size(); ++k) {
      const std::optional<double> number = finite_number((*row)[k], path(key));
      if (number) numbers.push_back(*number);
    }
    const bool is_row = row && numbers.size() == row->size() && !numbers.empty() &&
                        (rows.empty() || numbers.size() == rows.front().size());
    if (!is_row) {
      faults_->add(place_of((*list)[i].source()), path(key) + '[' + std::to_string(i) + ']',
                   "not a row: " + shown((*list)[i]) + "; allowed: " + allowed);
      return {};
    }
    rows.push_back(std::move(numbers));
  }
  if (rows.empty()) fault(key, "no rows: " + shown(*node) + "; allowed: " + allowed);
  return rows;
}

std::vector<std::int64_t> Keys::integers(std::string_view key, std::size_t count, std::int64_t low,
                                         std::int64_t high) {
  const std::string allowed = std::to_string(count) + " whole numbers, at least " + std::to_string(low) +
                              ", at most " + std::to_string(high);
  const toml::node* node = find(key, allowed, true);
  if (!node) return {};
  const toml::array* list = node->as_array();
  std::vector<std::int64_t> numbers;
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const toml::value<std::int64_t>* number = (*list)[i].as_integer();
    if (number && low <= number->get() && number->get() <= high) numbers.push_back(number->get());
  }
  if (list && list->size() == count && numbers.size() == count) return numbers;
  fault(key, "out of range: " + shown(*node) + "; allowed: " + allowed);
  return {};
}

std::optional<std::vector<int>> Keys::loop_of(const toml::node& node, std::size_t count) {
  const toml::array* list = node.as_array();
  if (!list || list->size() < 3) return {};
  std::vector<int> loop;
  for (const toml::node& item : *list) {
    const toml::value<std::int64_t>* index = item.as_integer();
    if (!index || index->get() < 0 || static_cast<std::uint64_t>(index->get()) >= count) return {};
    loop.push_back(static_cast<int>(index->get()));
  }
  return loop;
}

std::vector<std::vector<int>> Keys::loops(std::string_view key, std::size_t count) {
  const std::string allowed =
      "lists of three or more whole numbers, at least 0, below " + std::to_string(count);
  const toml::array* list = list_at(key, allowed);
  if (!list) return {};
  std::vector<std::vector<int>> loops;
  for (std::size_t i = 0; i < list->size(); ++i) {
    std::optional<std::vector<int>> loop = loop_of((*list)[i], count);
    if (loop) {
      loops.push_back(std::move(*loop));
    } else {
      faults_->add(place_of((*list)[i].source()), path(key) + '[' + std::to_string(i) + ']',
                   "not a face: " + shown((*list)[i]) + "; allowed: " + allowed);
    }
  }
  return loops.size() == list->size() ? loops : std::vector<std::vector<int>>{};
}

std::vector<std::string> Keys::texts(std::string_view key, std::vector<Place>& places,
                                     std::optional<std::vector<std::string>> fallback) {
  const toml::node* node = find(key, "[\"string\", ...]", !fallback);
  if (!node) return fallback.value_or(std::vector<std::string>{});
  const toml::array* list = node->as_array();
  if (!list ||
      !std::all_of(list->begin(), list->end(), [](const toml::node& item) { return item.is_string(); })) {
    fault(key, "not a list of strings: " + shown(*node) + "; allowed: [\"string\", ...]");
    return {};
  }
  if (list->empty() && !fallback) fault(key, "an empty list; allowed: [\"string\", ...]");
  std::vector<std::string> texts;
  for (const toml::node& item : *list) {
    texts.push_back(item.as_string()->get());
    places.push_back(place_of(item.source()));
  }
  return texts;
}

std::vector<std::string> Keys::texts_among(std::string_view key, std::vector<Place>& places) {
  const std::string allowed = "[\"string\", {...}, ...]";
  const toml::array* list = list_at(key, allowed);
  std::vector<std::string> texts;
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const toml::node& item = (*list)[i];
    if (const toml::value<std::string>* text = item.as_string()) {
      texts.push_back(text->get());
      places.push_back(place_of(item.source()));
    } else if (!item.is_table()) {
      faults_->add(place_of(item.source()), path(key),
                   "not a string or a table: " + shown(item) + "; allowed: " + allowed);
    }
  }
  return texts;
}

std::string Keys::header(std::string_view key) const {
  std::string text = path(key);
  for (auto open = text.find('['); open != std::string::npos; open = text.find('[')) {
    text.erase(open, text.find(']', open) + 1 - open);
  }
  return '[' + text + ']';
}

Keys Keys::table(std::string_view key, bool is_required) {
  const toml::node* node = find(key, "a table " + header(key), is_required);
  if (node && !node->is_table()) fault(key, "not a table: " + shown(*node) + "; allowed: " + header(key));
  Keys keys(node && node->is_table() ? *node->as_table() : no_keys, path(key), *faults_);
  keys.set_dimension(dimension_);
  return keys;
}

std::vector<Keys> Keys::tables(std::string_view key, bool is_required) {
  const std::string allowed = "one or more tables [" + header(key) + "]";
  const toml::node* node = find(key, allowed, is_required);
  if (!node) return {};
  const toml::array* list = node->as_array();
  if (!list ||
      !std::all_of(list->begin(), list->end(), [](const toml::node& item) { return item.is_table(); })) {
    fault(key, "not a list of tables: " + shown(*node) + "; allowed: " + allowed);
    return {};
  }
  std::vector<Keys> members;
  for (std::size_t i = 0; i < list->size(); ++i) members.push_back(member(*(*list)[i].as_table(), key, i));
  return members;
}

std::vector<Keys> Keys::tables_among(std::string_view key) {
  std::vector<Keys> members;
  const toml::array* list = (*table_)[key].as_array();
  for (std::size_t i = 0; list && i < list->size(); ++i)
    if (const toml::table* table = (*list)[i].as_table()) members.push_back(member(*table, key, i));
  return members;
}

Keys Keys::member(const toml::table& table, std::string_view key, std::size_t index) const {
  Keys keys(table, path(key) + '[' + std::to_string(index) + ']', *faults_);
  keys.set_dimension(dimension_);
  return keys;
}

int Keys::kind(std::string_view key, const std::vector<std::string_view>& allowed,
               std::optional<int> fallback) {
  kind_ = key;
  const std::size_t faults_before = faults_->count();
  const int chosen = word(key, allowed, fallback);
  is_kind_known_ = faults_->count() == faults_before && !is_misspelt(key);
  if (has(key) && place(key).is_setting) leave_out_others();
  return chosen;
}

bool Keys::either(std::string_view key, std::string_view other) {
  allow(key);
  allow(other);
  alternatives_.emplace_back(key, other);
  return has(key);
}

bool Keys::is_misspelt(std::string_view key) const {
  if (has(key)) return false;
  std::vector<std::string_view> present;
  for (const auto& [name, node] : *table_) present.push_back(name.str());
  return !nearest(key, present).empty();
}

bool Keys::has_only(std::initializer_list<std::string_view> keys) const {
  return std::all_of(table_->begin(), table_->end(), [&](const auto& entry) {
    return std::find(keys.begin(), keys.end(), entry.first.str()) != keys.end();
  });
}

void Keys::withdraw_missing(std::string_view key) {
  if (key.empty() || has(key)) return;
  faults_->withdraw_missing(path(key));
  for (const auto& [one, other] : alternatives_) {
    if (key == one || key == other)
      for (std::string_view alternative : {one, other}) faults_->withdraw_missing(path(alternative));
  }
}

void Keys::finish() {
  for (const auto& [key, node] : *table_) {
    if (std::find(allowed_.begin(), allowed_.end(), key.str()) != allowed_.end()) continue;
    const Place place = place_of(key.source());
    const std::string_view now = new_name(key.str());
    if (std::find(allowed_.begin(), allowed_.end(), now) != allowed_.end()) {
      faults_->note(place, path(key.str()), "renamed; use " + std::string(now));
      continue;
    }
    const std::string_view meant = nearest(key.str(), allowed_);
    withdraw_missing(meant);
    if (leaves_out_others_ && meant.empty() && !place_of(node.source()).is_setting) {
      faults_->note(place, path(key.str()), "left out; it does not fit the kind that --set gives");
      continue;
    }
    // Another kind would have other keys.
    if (!is_kind_known_ && (has(kind_) || meant != kind_)) continue;
    faults_->add(place, path(key.str()),
                 "unknown key" + suggestion(key.str(), allowed_) + "; allowed: " + joined(allowed_));
  }
  if (is_kind_known_) return;
  for (std::string_view key : allowed_)
    if (key != kind_) withdraw_missing(key);
}

}  // namespace halfspace::cli
