// Tables as CSV (RFC 4180): cells with commas between them, a row a line, the first row the names
// of the columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spindrift::app {

/// A row with its line end, "\n". Cells that hold a comma, a quotation mark or a line break are in
/// quotation marks.
std::string csv_row(const std::vector<std::string>& cells);

struct CsvColumn {
  std::string name;
  std::vector<std::string> cells;  ///< one for each row below the first
};

/// The columns of a table whose lines end in "\n" or "\r\n". Cells that a row has too few are
/// empty, those that it has too many are left out.
std::vector<CsvColumn> csv_columns(std::string_view text);

}  // namespace spindrift::app
