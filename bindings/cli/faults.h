#pragma once

#include <string>
#include <vector>

namespace halfspace::cli {

/// A place in the scene file, counted from 1.
struct Place {
  int line = 1;
  int column = 1;
};

/// One thing wrong with a scene, or worth a look.
struct Fault {
  Place place;
  std::string key;   ///< dotted path, e.g. block[2].vertices
  std::string text;  ///< what is wrong, the value, what is allowed
};

/// Everything wrong with a scene, so that all of it can be told at once; and apart from that notes: what is
/// legal, but seldom meant.
class Faults {
 public:
  void add(Place place, std::string key, std::string text);
  void note(Place place, std::string key, std::string text);
  /// Of a key that is there under another name.
  void withdraw_missing(const std::string& key);
  bool none() const { return faults_.empty(); }
  std::size_t count() const { return faults_.size(); }

  /// One line each, `file:LINE:COLUMN: key: text`, in the order of the file.
  std::string describe(const std::string& file) const;
  /// Likewise of the notes, each key behind `note: `.
  std::string describe_notes(const std::string& file) const;

 private:
  std::vector<Fault> faults_;
  std::vector<Fault> notes_;
};

}  // namespace halfspace::cli
