#include "scene/deep_key.h"

#include <algorithm>
#include <string>

namespace halfspace::cli {
namespace {

/// The end of the string that begins here. An unterminated string, which is no TOML, ends with its line or
/// with the text.
std::size_t end_of_string(std::string_view toml, std::size_t begin) {
  const char quote = toml[begin];
  const std::string three(3, quote);
  const bool has_lines = toml.substr(begin).starts_with(three);
  std::size_t at = begin + (has_lines ? 3 : 1);
  for (; at < toml.size(); ++at) {
    if (toml[at] == '\\' && quote == '"') {
      ++at;
    } else if (has_lines && toml.substr(at).starts_with(three)) {
      return std::min(toml.find_first_not_of(quote, at),
                      toml.size());  // the string may end with quotes of its own
    } else if (!has_lines && (toml[at] == quote || toml[at] == '\n')) {
      return toml[at] == quote ? at + 1 : at;
    }
  }
  return toml.size();
}

/// The end of the string, comment or single letter that begins here.
std::size_t end_of_token(std::string_view toml, std::size_t begin) {
  const char c = toml[begin];
  if (c == '"' || c == '\'') return end_of_string(toml, begin);
  if (c == '#') return std::min(toml.find('\n', begin), toml.size());
  return begin + 1;
}

}  // namespace

std::optional<Place> deep_key(std::string_view toml, int max_names) {
  Place place;
  int names = 1;
  for (std::size_t at = 0; at < toml.size();) {
    const std::size_t end = end_of_token(toml, at);
    if (toml[at] == '.' && ++names > max_names) return place;
    if (std::string_view("=[]{},\n").find(toml[at]) != std::string_view::npos) names = 1;
    for (; at < end; ++at) {
      place = toml[at] == '\n' ? Place{place.line + 1, 1} : Place{place.line, place.column + 1};
    }
  }
  return std::nullopt;
}

}  // namespace halfspace::cli
