#include "engine/record/csv.h"

#include <gtest/gtest.h>

namespace dda {
namespace {

TEST(Csv, ReadsWhatItWrites) {
  const std::vector<std::string> cells = {"plain", "", "a, b", "\"", "say \"go\",\nthen stop", " x "};
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
  const std::string table = line + "\nnext,1\n";
  std::string_view rest = table;
  EXPECT_EQ(take_csv_row(rest), cells);
  EXPECT_EQ(take_csv_row(rest), (std::vector<std::string>{"next", "1"}));
  EXPECT_TRUE(rest.empty());
}

TEST(Csv, QuotesOnlyWhatNeedsIt) {
  EXPECT_EQ(csv_cell("rock 17"), "rock 17");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a\"b"), "\"a\"\"b\"");
}

TEST(Csv, ANumberIsTheWholeCell) {
  EXPECT_EQ(csv_number("-1.5e3"), -1500.0);
  for (const char* cell : {"", "1 ", "1m", "one"}) EXPECT_EQ(csv_number(cell), std::nullopt) << cell;
}

}  // namespace
}  // namespace dda
