#include "scene/settings.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "common/suggestion.h"
#include "scene/deep_key.h"

namespace halfspace::cli {
namespace {

/// The source of values that are settings; their line is the number of the setting.
constexpr std::string_view source_name = "--set";

Place place_of_setting(std::size_t number) {
  return {.line = static_cast<int>(number), .column = 1, .is_setting = true};
}

toml::table parsed(std::size_t number, const std::string& value) {
  return toml::parse(std::string(number - 1, '\n') + "value = " + value, source_name);
}

/// True for text without the characters that TOML gives a meaning: such a value is a string.
bool is_bare_word(const std::string& value) {
  return !value.empty() && std::all_of(value.begin(), value.end(), [](unsigned char c) {
    return c >= ' ' && c != 0x7f &&
           std::string_view("\"'\\[]{}#,=").find(static_cast<char>(c)) == std::string_view::npos;
  });
}

/// The path of a setting, read from its front.
class Path {
 public:
  explicit Path(std::string_view text) : left_(text) {}
  bool is_over() const { return left_.empty(); }
  bool has_index() const { return left_.starts_with('['); }

  /// The name up to the next dot or index; empty if there is none.
  std::string_view take_name() { return take(std::min(left_.find_first_of(".["), left_.size())); }
  /// The longest of these names with which the path goes on; empty if there is none. Names may have dots.
  std::string_view take_one_of(const std::vector<std::string_view>& names) {
    std::string_view longest;
    for (const std::string_view name : names) {
      if (!left_.starts_with(name) || name.size() <= longest.size()) continue;
      const std::string_view behind = left_.substr(name.size());
      if (behind.empty() || behind.starts_with('.') || behind.starts_with('[')) longest = name;
    }
    return take(longest.size());
  }
  /// The index in brackets, if it is one.
  std::optional<std::size_t> take_index() {
    const std::size_t close = left_.find(']');
    if (close == std::string_view::npos) return std::nullopt;
    const std::string_view digits = left_.substr(1, close - 1);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    take(close + 1);
    return index;
  }

 private:
  /// Takes so many letters, and a dot after them.
  std::string_view take(std::size_t count) {
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    if (left_.starts_with('.') && left_.size() > 1) left_.remove_prefix(1);
    return taken;
  }

  std::string_view left_;
};

/// Replaces or removes one value of a scene.
class Setter {
 public:
  Setter(std::size_t number, std::string key, Faults& faults)
      : number_(number), key_(std::move(key)), path_(key_), faults_(faults) {}

  /// @param value under the key "value"; empty to remove what the path leads to
  void set(toml::table& scene, toml::table value) {
    toml::node* node = &scene;
    while (node) {
      if (toml::table* table = node->as_table()) {
        node = through(*table, value);
      } else if (toml::array* list = node->as_array()) {
        node = through(*list, value);
      } else {
        fault(taken_ + " has no keys; allowed: the path of a key");
        return;
      }
    }
  }

 private:
  void fault(const std::string& text) { faults_.add(place_of_setting(number_), key_, text); }

  /// The next node of the path, or nullptr when the value is set or a fault is found.
  toml::node* through(toml::table& table, toml::table& value) {
    const std::string name(path_.take_name());
    if (name.empty()) {
      fault("not a key; allowed: names and indices, as block[2].velocity or material.rock.density");
      return nullptr;
    }
    taken_ += (taken_.empty() ? "" : ".") + name;
    list_ = name;
    if (!path_.is_over() && table.contains(name)) return table.get(name);
    if (path_.has_index()) {
      fault("no such list: " + taken_ + "; allowed: a list of the scene");
      return nullptr;
    }
    if (path_.is_over() && value.empty()) {
      if (table.erase(name) == 0)
        fault("no such key: " + taken_ + "; allowed: a key of the scene, or a value to add");
      return nullptr;
    }
    toml::table added = path_.is_over() ? std::move(value) : parsed(number_, "{}");
    toml::node* node = added.get("value");
    const toml::key key(name, node->source());
    std::move(*node).visit([&](auto&& of_type) { table.insert_or_assign(key, std::move(of_type)); });
    return path_.is_over() ? nullptr : table.get(name);
  }

  toml::node* through(toml::array& list, toml::table& value) {
    const std::optional<std::size_t> index = path_.has_index() ? index_in(list) : index_of_name(list);
    if (!index) return nullptr;
    taken_ += '[' + std::to_string(*index) + ']';
    if (!path_.is_over()) return list.get(*index);
    if (value.empty()) {
      list.erase(list.cbegin() + static_cast<std::ptrdiff_t>(*index));
      return nullptr;
    }
    std::move(*value.get("value")).visit([&](auto&& of_type) {
      list.replace(list.cbegin() + static_cast<std::ptrdiff_t>(*index), std::move(of_type));
    });
    return nullptr;
  }

  std::optional<std::size_t> index_in(const toml::array& list) {
    const std::optional<std::size_t> index = path_.take_index();
    if (index && *index < list.size()) return index;
    fault("no such element of " + taken_ + "; allowed: " +
          (list.empty() ? "none, it is empty" : "[0] to [" + std::to_string(list.size() - 1) + ']'));
    return std::nullopt;
  }

  std::optional<std::size_t> index_of_name(const toml::array& list) {
    std::vector<std::string_view> names;
    for (const toml::node& element : list) {
      const toml::table* table = element.as_table();
      const toml::value<std::string>* name = table ? (*table)["name"].as_string() : nullptr;
      names.push_back(name ? std::string_view(name->get()) : std::string_view());
    }
    const std::string_view name = path_.take_one_of(names);
    if (!name.empty()) return std::find(names.begin(), names.end(), name) - names.begin();
    const std::string_view other = path_.take_name();
    fault("no such " + list_ + ": \"" + std::string(other) + '"' + suggestion(other, names) +
          "; allowed: the name of an element of " + taken_ + ", or " + taken_ + "[0] for the first");
    return std::nullopt;
  }

  const std::size_t number_;
  const std::string key_;
  Path path_;
  std::string taken_;  ///< the path so far
  std::string list_;   ///< the last name in it
  Faults& faults_;
};

/// The value of a setting under the key "value", or a table without it where there is none; empty after a
/// fault.
std::optional<toml::table> parsed_value(std::size_t number, const std::string& key, const std::string& value,
                                        Faults& faults) {
  if (value.find_first_not_of(' ') == std::string::npos) return toml::table{};
  try {
    toml::table table = parsed(number, value);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
    if (is_bare_word(value)) return parsed(number, '"' + value + '"');
  }
  faults.add(place_of_setting(number), key,
             "not a value: " + value +
                 "; allowed: a number, true, false, [a list], \"text\", or nothing to remove the key");
  return std::nullopt;
}

}  // namespace

void apply_settings(const std::vector<std::string>& settings, toml::table& scene, Faults& faults) {
  faults.name_settings(settings);
  for (std::size_t number = 1; number <= settings.size(); ++number) {
    const std::string& setting = settings[number - 1];
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      faults.add(place_of_setting(number), "", "no value; allowed: key=value, or key= to remove the key");
      continue;
    }
    const std::string key = setting.substr(0, equals);
    if (deep_key(setting, max_names)) {
      faults.add(place_of_setting(number), "",
                 "more than " + std::to_string(max_names) + " names in a key; allowed: the keys of a scene");
      continue;
    }
    std::optional<toml::table> value = parsed_value(number, key, setting.substr(equals + 1), faults);
    if (value) Setter(number, key, faults).set(scene, std::move(*value));
  }
}

Place place_of(const toml::source_region& source) {
  if (!source.begin) return {};
  return {.line = static_cast<int>(source.begin.line),
          .column = static_cast<int>(source.begin.column),
          .is_setting = source.path && *source.path == source_name};
}

}  // namespace halfspace::cli
