#include "app/files/csv.hpp"

#include <algorithm>
#include <utility>

namespace spindrift::app {
namespace {

std::string quoted_where_needed(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

/// Takes the first row off a text that is not empty. A cell whose quotation mark is not closed goes
/// to the end of the text.
std::vector<std::string> take_row(std::string_view& text) {
  std::vector<std::string> cells(1);
  bool in_quotes = false;
  std::size_t i = 0;
  for (; i < text.size() && (in_quotes || text[i] != '\n'); ++i) {
    const char c = text[i];
    const bool next_too = i + 1 < text.size() && text[i + 1] == c;
    if (c == '"' && in_quotes && next_too)
      cells.back() += text[++i];
    else if (c == '"')
      in_quotes = !in_quotes;
    else if (c == ',' && !in_quotes)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  if (!in_quotes && i > 0 && i < text.size() && text[i - 1] == '\r')
    cells.back().pop_back();
  text.remove_prefix(std::min(i + 1, text.size()));
  return cells;
}

}  // namespace

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (std::size_t k = 0; k < cells.size(); ++k)
    row += (k == 0 ? "" : ",") + quoted_where_needed(cells[k]);
  return row + '\n';
}

std::vector<CsvColumn> csv_columns(std::string_view text) {
  std::vector<CsvColumn> columns;
  if (text.empty())
    return columns;
  for (std::string& name : take_row(text))
    columns.push_back({std::move(name), {}});
  while (!text.empty()) {
    std::vector<std::string> cells = take_row(text);
    cells.resize(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      columns[k].cells.push_back(std::move(cells[k]));
  }
  return columns;
}

}  // namespace spindrift::app
