#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace halfspace::cli {

/// A place in the scene file, counted from 1, or a setting of the command line.
struct Place {
  int line = 1;  ///< of the file; the number of the setting
  int column = 1;
  bool is_setting = false;
};

/// A fault of a scene, or a note.
struct Fault {
  Place place;
  std::string key;   ///< dotted path, e.g. block[2].vertices
  std::string text;  ///< the fault, the value, the allowed values
};

/// A fault of a scene that is found only in its world.
struct SceneFault : std::runtime_error {
  SceneFault(Place place, std::string key, const std::string& text)
      : std::runtime_error(text), place(place), key(std::move(key)) {}

  Place place;
  std::string key;
};

/// Collects all faults of a scene, so that they are reported together, and its notes: legal but unusual
/// input.
class Faults {
 public:
  void add(Place place, std::string key, std::string text);
  void note(Place place, std::string key, std::string text);
  /// Removes the fault of a missing key that is present under another name.
  void withdraw_missing(const std::string& key);
  /// The settings of the command line, `key=value`, that places name.
  void name_settings(std::vector<std::string> settings) { settings_ = std::move(settings); }
  bool none() const { return faults_.empty(); }
  std::size_t count() const { return faults_.size(); }

  /// One line each, `file:LINE:COLUMN: key: text`, in the order of the file; then those of settings,
  /// `file: --set SETTING: key: text`.
  std::string describe(const std::string& file) const;
  /// The same for notes, with `note: ` before each key.
  std::string describe_notes(const std::string& file) const;

 private:
  std::vector<Fault> faults_;
  std::vector<Fault> notes_;
  std::vector<std::string> settings_;
};

}  // namespace halfspace::cli
