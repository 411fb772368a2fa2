#include "engine/record/history_writer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <sstream>

#include "engine/core/allocation_counter.h"
#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/model/quantity_names.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

using Row = std::vector<double>;

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::istringstream stream(read_file(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Row numbers_of(const std::string& line) {
  std::istringstream stream(line);
  Row row;
  for (std::string field; std::getline(stream, field, ',');) row.push_back(std::strtod(field.c_str(), nullptr));
  return row;
}

TEST(HistoryWriter, HeaderNamesUnitsAndRowsFollow) {
  const TemporaryFolder folder;
  HistoryWriter writer(folder / "h.csv", {{"at 50 m", "Pa"}, {"ratio", ""}, {R"(odd, "name")", "m"}});
  writer.append(0, Row{1, 2, 3});
  writer.append(1e-5, Row{-0.1, 1e300, 1.0 / 3});
  writer.close();
  EXPECT_EQ(writer.rows(), 2);
  EXPECT_EQ(read_file(folder / "h.csv"),
            "time [s],at 50 m [Pa],ratio [-],\"odd, \"\"name\"\" [m]\"\n"
            "0,1,2,3\n"
            "1e-05,-0.1,1e+300,0.3333333333333333\n");
}

TEST(HistoryWriter, EveryDoubleReadsBackAsItself) {
  const TemporaryFolder folder;
  std::mt19937_64 random(7);
  std::vector<Row> rows = {{0.0, -0.0, 5e-324},
                           {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 0.1 + 0.2},
                           {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1}};
  for (int i = 0; i < 5000; ++i) {
    Row row(3);
    for (double& value : row) {
      do value = std::bit_cast<double>(random());
      while (std::isnan(value));
    }
    rows.push_back(row);
  }
  HistoryWriter writer(folder / "h.csv", {{"a", "m"}, {"b", "m"}});
  for (const Row& row : rows) writer.append(row[0], std::span(row).subspan(1));
  writer.close();

  const std::vector<std::string> lines = lines_of(folder / "h.csv");
  ASSERT_EQ(lines.size(), rows.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row read = numbers_of(lines[i + 1]);
    ASSERT_EQ(read.size(), 3U);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(read[j]), std::bit_cast<std::uint64_t>(rows[i][j])) << lines[i + 1];
    }
  }
}

TEST(HistoryWriter, WithoutCloseTheRowsAreThereToo) {
  const TemporaryFolder folder;
  {
    HistoryWriter writer(folder / "h.csv", {{"a", "m"}});
    writer.append(1, Row{2});
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"h.csv.tmp"});
  }
  EXPECT_EQ(read_file(folder / "h.csv"), "time [s],a [m]\n1,2\n");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"h.csv"});
}

TEST(HistoryWriter, RowsReachTheDiskWhileTheRunGoesOn) {
  const TemporaryFolder folder;
  HistoryWriter writer(folder / "h.csv", {{"a", "m"}});
  EXPECT_EQ(lines_of(folder / "h.csv.tmp").size(), 1U);
  writer.append(1, Row{2});
  writer.flush();
  EXPECT_EQ(lines_of(folder / "h.csv.tmp").size(), 2U);
  for (int i = 0; i < 10'000; ++i) writer.append(1.0 / 3, Row{1.0 / 7});
  // 38 bytes a row: at most one buffer of 64 KiB, 1725 rows, is still in memory.
  EXPECT_GT(lines_of(folder / "h.csv.tmp").size(), 10'000U - 1725U);
  EXPECT_EQ(read_file(folder / "h.csv.tmp").back(), '\n');
}

TEST(HistoryWriter, FullDiskKeepsWholeRows) {
  const TemporaryFolder folder;
  const FullDisk full(100'000);
  {
    HistoryWriter writer(folder / "h.csv", {{"a", "m"}});
    const auto append_many = [&] {
      for (int i = 0; i < 10'000; ++i) writer.append(1.0 / 3, Row{1.0 / 7});
    };
    EXPECT_EQ(message_of<std::runtime_error>(append_many),
              "cannot write " + (folder / "h.csv").string() + ": File too large");
  }
  const std::vector<std::string> lines = lines_of(folder / "h.csv");
  EXPECT_GT(lines.size(), 1000U);
  for (std::size_t i = 1; i < lines.size(); ++i) ASSERT_EQ(lines[i], "0.3333333333333333,0.14285714285714285");
}

TEST(HistoryWriter, RefusesMisuse) {
  const TemporaryFolder folder;
  HistoryWriter writer(folder / "h.csv", {{"a", "m"}});
  EXPECT_THROW(writer.append(0, Row{}), std::invalid_argument);
  EXPECT_THROW(writer.append(0, Row{1, 2}), std::invalid_argument);
  writer.close();
  writer.close();
  EXPECT_THROW(writer.append(0, Row{1}), std::logic_error);
  EXPECT_EQ(read_file(folder / "h.csv"), "time [s],a [m]\n");
}

TEST(HistoryWriter, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder / "missing" / "h.csv";
  EXPECT_EQ(message_of<std::runtime_error>([&] {
              HistoryWriter(path, {{"a", "m"}});
            }),
            "cannot write " + path.string() + ": No such file or directory");
}

TEST(HistoryWriter, WarmAppendDoesNotAllocate) {
  const TemporaryFolder folder;
  const Row values(20, -1.2345678901234567e-300);  // long numbers
  HistoryWriter writer(folder / "h.csv", std::vector<Column>(values.size(), {"a", "m"}));
  const long before = allocations_so_far();
  for (int i = 0; i < 1000; ++i) writer.append(1.0 / 3, values);  // seven buffers full
  EXPECT_EQ(allocations_so_far() - before, 0);
}

TEST(QuantityNames, AreDifferentAndHaveUnits) {
  std::set<std::string_view> names;
  for (const QuantityFacts& quantity : all_quantities) {
    names.insert(quantity.name);
    EXPECT_FALSE(quantity.histories.empty()) << quantity.name;
    std::set<std::string_view> suffixes;
    for (const HistoryFacts& history : quantity.histories) {
      suffixes.insert(history.suffix);
      EXPECT_NE(history.unit, "") << quantity.name;
    }
    EXPECT_EQ(suffixes.size(), quantity.histories.size()) << quantity.name;
  }
  EXPECT_EQ(names.size(), all_quantities.size());
  EXPECT_EQ(to_string(Quantity::traction_shear), "traction_shear");
  EXPECT_EQ(histories_of(Quantity::traction_shear)[0].unit, "Pa");
  EXPECT_EQ(histories_of(Quantity::acceleration_y)[0].unit, "m/s2");
}

std::string resumed_text(const TemporaryFolder& folder, std::int64_t rows) {
  HistoryWriter writer(folder / "h.csv", {{"a", "m"}}, rows);
  EXPECT_EQ(writer.rows(), rows);
  writer.append(9, Row{9});
  EXPECT_EQ(writer.rows(), rows + 1);
  writer.close();
  return read_file(folder / "h.csv");
}

TEST(HistoryWriter, GoesOnAfterTheRowsThatCount) {
  const TemporaryFolder folder;
  write_file(folder / "h.csv", "time [s],a [m]\n0,1\n1,2\n2,3\n");
  EXPECT_EQ(resumed_text(folder, 2), "time [s],a [m]\n0,1\n1,2\n9,9\n");
  EXPECT_EQ(resumed_text(folder, 3), "time [s],a [m]\n0,1\n1,2\n9,9\n9,9\n");
  EXPECT_EQ(resumed_text(folder, 0), "time [s],a [m]\n9,9\n");
}

TEST(HistoryWriter, GoesOnWithWhatABrokenOffRunLeft) {
  const TemporaryFolder folder;
  write_file(folder / "h.csv", "time [s],a [m]\n0,7\n1,7\n");  // of an earlier run
  write_file(folder / "h.csv.tmp", "time [s],a [m]\n0,1\n1,2\n2,3\n2.5,");
  EXPECT_EQ(resumed_text(folder, 2), "time [s],a [m]\n0,1\n1,2\n9,9\n");
}

// Killed at any moment after it has begun to go on, the run still has the rows that its checkpoint counts.
TEST(HistoryWriter, GoingOnKeepsTheRowsOnDisk) {
  const TemporaryFolder folder;
  write_file(folder / "h.csv", "time [s],a [m]\n0,1\n1,2\n2,3\n");
  const HistoryWriter writer(folder / "h.csv", {{"a", "m"}}, 2);
  EXPECT_EQ(read_file(folder / "h.csv.tmp"), "time [s],a [m]\n0,1\n1,2\n");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"h.csv.tmp"})) << "older rows would be taken for all";
}

TEST(HistoryWriter, GoesOnWithTheWholeFileWhenNothingUsefulIsLeftOver) {
  const TemporaryFolder folder;
  write_file(folder / "h.csv", "time [s],a [m]\n0,1\n1,2\n");
  write_file(folder / "h.csv.tmp", "");
  EXPECT_EQ(resumed_text(folder, 2), "time [s],a [m]\n0,1\n1,2\n9,9\n");
}

TEST(HistoryWriter, DoesNotGoOnWithAnotherFile) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::vector<Column>& columns, std::int64_t rows) {
    return message_of<InputError>([&] { const HistoryWriter writer(folder / "h.csv", columns, rows); });
  };
  EXPECT_EQ(refusal({{"a", "m"}}, 0), (folder / "h.csv").string() +
                                          ": the history to go on with is missing, of other measurements or too short, "
                                          "expected a file with 0 rows of this scene's measurements");
  write_file(folder / "h.csv", "time [s],a [m]\n0,1\n1,2");
  EXPECT_EQ(refusal({{"a", "m"}}, 1), "");
  write_file(folder / "h.csv", "time [s],a [m]\n0,1\n1,2");
  EXPECT_NE(refusal({{"a", "m"}}, 2), "") << "the second row is not whole";
  EXPECT_NE(refusal({{"b", "m"}}, 1), "");
  EXPECT_EQ(names_in(folder.path()), (std::set<std::string>{"h.csv"})) << "a refusal leaves everything as it was";
  EXPECT_EQ(read_file(folder / "h.csv"), "time [s],a [m]\n0,1\n1,2");
}

}  // namespace
}  // namespace dda
