#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/digits.h"
#include "scene.h"

namespace halfspace::cli {

/// A text read line by line, so that whatever is wrong with it can be told with its line.
class TextLines {
 public:
  /// Both must outlive this. What follows the mark of a comment on its line is skipped; 0 is no mark.
  TextLines(const std::string& name, const std::string& content, char comment);

  /// Goes to the next line with a word on it; false at the end of the text.
  bool next();
  /// The same for a line that has to be there. @throws MeshFault naming what was awaited
  void next(std::string_view awaited);

  const std::vector<std::string_view>& words() const { return words_; }
  /// The first word of the line.
  std::string_view keyword() const { return words_.front(); }
  int line() const { return line_; }
  std::string place() const;

  /// Words of this line as numbers. @throws MeshFault if they are missing, no numbers, or not finite
  double number(std::size_t word) const;
  std::int64_t integer(std::size_t word) const;
  /// An integer that is a size: at least 0, and no larger than the text could hold.
  std::size_t count(std::size_t word) const;
  /// Three words as a place. Their digits count.
  Point point(std::size_t first_word);
  const Digits& digits() const { return digits_; }
  /// Word as an integer in place of one of this line.
  std::int64_t integer_of(std::string_view word) const;

  [[noreturn]] void fail(const std::string& text) const;

 private:
  std::string_view word_at(std::size_t word) const;

  const std::string& name_;
  std::string_view rest_;
  std::size_t size_;
  char comment_;
  int line_ = 0;
  Digits digits_;
  std::vector<std::string_view> words_;
};

}  // namespace halfspace::cli
