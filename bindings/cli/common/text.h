#pragma once

#include <array>
#include <charconv>
#include <string>

namespace halfspace::cli {

/// The shortest text that reads back as the same number, in any locale.
inline std::string shortest(double value) {
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

/// With a given number of significant digits, trailing zeros dropped.
inline std::string rounded(double value, int digits) {
  char buffer[64];
  return std::string(
      buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr);
}

/// With a given number of decimals.
inline std::string decimals(double value, int count) {
  char buffer[400];  // the largest double has 309 digits before the point
  return std::string(
      buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, count).ptr);
}

/// Padded with blanks to a width, for aligned columns.
inline std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

/// Texts with commas between them.
template <class Texts>
std::string joined(const Texts& texts) {
  std::string text;
  for (const auto& part : texts) text += (text.empty() ? "" : ", ") + std::string(part);
  return text;
}

/// A text as a value of a CSV file, in quotes where it needs them (RFC 4180).
inline std::string csv_value(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

/// A line of a report: a name, and a text that begins at a column.
inline std::string report_line(const std::string& name, const std::string& text, std::size_t column = 20) {
  return padded(name, column) + text + '\n';
}

/// A point as in scene files: [x, y] or [x, y, z].
inline std::string described(const std::array<double, 3>& point, int dimension = 3) {
  std::string text = '[' + shortest(point[0]) + ", " + shortest(point[1]);
  if (dimension == 3) text += ", " + shortest(point[2]);
  return text + ']';
}

}  // namespace halfspace::cli
