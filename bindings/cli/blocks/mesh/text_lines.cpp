#include "blocks/mesh/text_lines.h"

#include <charconv>
#include <cmath>

#include "blocks/mesh/mesh_fault.h"

namespace halfspace::cli {
namespace {

constexpr std::string_view blanks = " \t\f\v";

void split(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
}

}  // namespace

TextLines::TextLines(const std::string& name, const std::string& content, char comment)
    : name_(name), rest_(content), size_(content.size()), comment_(comment) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
  if (rest_.starts_with("\xff\xfe") || rest_.starts_with("\xfe\xff"))
    throw MeshFault(name, "text in UTF-16; allowed: ASCII or UTF-8");
}

bool TextLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    text_ = rest_.substr(0, end);
    rest_.remove_prefix(end);
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
    ++line_;
    if (comment_ != 0) text_ = text_.substr(0, text_.find(comment_));
    split(text_, words_);
    if (!words_.empty()) return true;
  }
  return false;
}

void TextLines::next(std::string_view expected) {
  if (!next()) fail("the file ends here; expected: " + std::string(expected));
}

std::string TextLines::place() const { return name_ + ':' + std::to_string(line_); }

void TextLines::fail(const std::string& text) const { throw MeshFault(place(), text); }

std::string_view TextLines::word_at(std::size_t word) const {
  if (word >= words_.size()) fail("the line is too short; expected: a word " + std::to_string(word + 1));
  return words_[word];
}

double TextLines::number(std::size_t word) const { return number_of(word_at(word)); }

double TextLines::number_of(std::string_view word) const {
  std::string_view text = word;
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string with_e;
  if (const std::size_t mark = text.find_first_of("dD"); mark != std::string_view::npos) {
    with_e = text;
    with_e[mark] = 'e';
    text = with_e;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail("not a finite number: \"" + std::string(word) + '"');
  return value;
}

std::int64_t TextLines::integer_of(std::string_view word) const {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail("not a whole number: \"" + std::string(word) + '"');
  return value;
}

std::int64_t TextLines::integer(std::size_t word) const { return integer_of(word_at(word)); }

std::size_t TextLines::count(std::size_t word) const {
  const std::int64_t value = integer(word);
  if (value < 0 || static_cast<std::uint64_t>(value) > size_)
    fail("not a count that the file could hold: " + std::to_string(value));
  return static_cast<std::size_t>(value);
}

Point TextLines::point(std::size_t first_word) {
  for (std::size_t axis = 0; axis < 3; ++axis) digits_.add(word_at(first_word + axis));
  return {number(first_word), number(first_word + 1), number(first_word + 2)};
}

}  // namespace halfspace::cli
