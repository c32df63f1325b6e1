// CSV as RFC 4180 has it, written and read.
#include <catch2/catch.hpp>

#include "app/files/csv.hpp"

namespace app_csv_tests {

using namespace spindrift::app;

namespace {

using Cells = std::vector<std::string>;

}  // namespace

TEST_CASE("cells of CSV are in quotation marks only where they have to be") {
  CHECK(csv_row({"a b", "", "-1.5e3", "ü"}) == "a b,,-1.5e3,ü\n");
  CHECK(csv_row({"a,b", "say \"a\"", "\"", "two\nlines", "\r"}) ==
        "\"a,b\",\"say \"\"a\"\"\",\"\"\"\",\"two\nlines\",\"\r\"\n");
}

TEST_CASE("a table of CSV is read as it was written") {
  const std::vector<Cells> columns{{"plain", "1", "", "4"},
                                   {"with, comma", "\"", "\"\"", "a\"b\","},
                                   {"line\nend", "\n", "\r\n", "\r"}};
  std::string text;
  for (std::size_t row = 0; row < 4; ++row)
    text += csv_row({columns[0][row], columns[1][row], columns[2][row]});
  const std::vector<CsvColumn> read = csv_columns(text);
  REQUIRE(read.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(read[k].name == columns[k][0]);
    CHECK(read[k].cells == Cells(columns[k].begin() + 1, columns[k].end()));
  }
}

TEST_CASE("rows of CSV that are too short are filled up, and longer ones cut off") {
  const std::vector<CsvColumn> read = csv_columns("a,b\n1\n1,2,3\n\n,4");
  REQUIRE(read.size() == 2);
  CHECK(read[0].cells == Cells{"1", "1", "", ""});
  CHECK(read[1].cells == Cells{"", "2", "", "4"});
}

TEST_CASE("lines of CSV may end as in DOS, and a quotation mark may stay open") {
  const std::vector<CsvColumn> read = csv_columns("a,\"b\"\r\n1,\"2\"\r\n3,\"4,\n5");
  REQUIRE(read.size() == 2);
  CHECK(read[1].name == "b");
  CHECK(read[0].cells == Cells{"1", "3"});
  CHECK(read[1].cells == Cells{"2", "4,\n5"});
  CHECK(csv_columns("").empty());
  CHECK(csv_columns("only names").front().cells.empty());
}

}  // namespace app_csv_tests
