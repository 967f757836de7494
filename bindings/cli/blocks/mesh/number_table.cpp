#include "blocks/mesh/number_table.h"

#include <algorithm>
#include <cctype>

#include "blocks/mesh/text_lines.h"

namespace halfspace::cli {
namespace {

/// Splits a line at blanks, semicolons and, if they separate, commas, but not within quotes.
std::vector<std::string> split(std::string_view line, bool at_commas) {
  std::vector<std::string> fields(1);
  bool is_quoted = false, is_after_blank = false;
  for (const char c : line) {
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (c == ';' || (at_commas && c == ','))) {
      fields.emplace_back();
      is_after_blank = false;
    } else if (!is_quoted && std::isspace(static_cast<unsigned char>(c))) {
      is_after_blank = true;
    } else {
      if (is_after_blank && !fields.back().empty()) fields.emplace_back();
      fields.back() += c;
      is_after_blank = false;
    }
  }
  if (fields.back().empty()) fields.pop_back();  // behind a separator at the end of the line
  return fields;
}

/// Commas separate numbers where nothing else does, or with a blank beside them. Between other separators
/// they are decimal commas.
std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> fields = split(line, false);
  const bool has_semicolon = line.find(';') != std::string_view::npos;
  const auto has_outer_comma = [](const std::string& field) {
    return field.starts_with(',') || field.ends_with(',');
  };
  if (!has_semicolon && (fields.size() == 1 || std::any_of(fields.begin(), fields.end(), has_outer_comma)))
    return split(line, true);
  for (std::string& field : fields) std::replace(field.begin(), field.end(), ',', '.');
  return fields;
}

/// False for the line of a header: its first field has no digit behind signs and decimal marks.
bool begins_with_number(const std::vector<std::string>& fields) {
  const auto first =
      std::find_if(fields.begin(), fields.end(), [](const auto& field) { return !field.empty(); });
  if (first == fields.end()) return false;
  std::string word = first->substr(std::min(first->find_first_not_of("+-.,"), first->size()));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word == "nan" || word == "inf" ||
         (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])));
}

}  // namespace

NumberTable read_number_table(const std::string& name, const std::string& content, const std::string& unit) {
  NumberTable table;
  TextLines lines(name, content, '#');
  while (lines.next()) {
    std::vector<std::string> fields = fields_of(lines.text());
    if (table.rows.empty() && !begins_with_number(fields)) {
      table.names = std::move(fields);
      continue;
    }
    std::vector<double>& row = table.rows.emplace_back();
    for (const std::string& field : fields) row.push_back(lines.number_of(field));
    table.lines.push_back(lines.line());
    const std::size_t expected = table.rows.front().size();
    if (row.size() == expected) continue;
    lines.fail("a row of " + std::to_string(row.size()) + ' ' + unit + "; the first row has " +
               std::to_string(expected));
  }
  return table;
}

}  // namespace halfspace::cli
