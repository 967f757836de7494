#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "blocks/mesh/digits.h"
#include "common/vector.h"

namespace halfspace::cli {

/// Reads a text line by line, and reports faults with their line. Lines end with the marks of any system. The
/// byte order mark of UTF-8 is skipped.
class TextLines {
 public:
  /// Both strings must outlive this. The rest of a line after the character `comment` is skipped; 0: no
  /// comments. @throws MeshFault for UTF-16
  TextLines(const std::string& name, const std::string& content, char comment);

  /// Goes to the next line with a word on it; false at the end of the text.
  bool next();
  /// The same for a required line. @throws MeshFault with the expected content
  void next(std::string_view expected);

  /// The whole line without its comment.
  std::string_view text() const { return text_; }
  const std::vector<std::string_view>& words() const { return words_; }
  /// The first word of the line.
  std::string_view keyword() const { return words_.front(); }
  int line() const { return line_; }
  std::string place() const;

  /// Words of this line as numbers. @throws MeshFault if they are missing, no numbers, or not finite
  double number(std::size_t word) const;
  std::int64_t integer(std::size_t word) const;
  /// A count: an integer from 0 to the size of the text.
  std::size_t count(std::size_t word) const;
  /// Three words as a point; their digits are added to digits().
  Point point(std::size_t first_word);
  const Digits& digits() const { return digits_; }
  /// Any word as a number, whose exponent may be marked by D as Fortran writes it.
  double number_of(std::string_view word) const;
  /// Any word as an integer.
  std::int64_t integer_of(std::string_view word) const;

  [[noreturn]] void fail(const std::string& text) const;

 private:
  std::string_view word_at(std::size_t word) const;

  const std::string& name_;
  std::string_view rest_;
  std::string_view text_;
  std::size_t size_;
  char comment_;
  int line_ = 0;
  Digits digits_;
  std::vector<std::string_view> words_;
};

}  // namespace halfspace::cli
