#include "engine/scene/record_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/temporary_folder.h"
#include "engine/geometry/cut_pieces.h"
#include "engine/scene/bad_scene_test_support.h"

namespace dda {
namespace {

using std::string_literals::operator""s;

std::filesystem::path written(const std::string& text) {
  static const TemporaryFolder folder;
  const std::filesystem::path file = folder / "record.csv";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

Recording read(const std::string& text, RecordRequest request = {}) {
  request.file = written(text);
  request.dimension = Dimension::acceleration;
  return read_record(request, "place");
}

const std::vector<double> three_times{0, 0.5, 2};
const std::vector<double> three_values{0, -1.5, 20};

void expect_three(const Recording& record) {
  EXPECT_EQ(record.times(), three_times);
  EXPECT_EQ(record.values(), three_values);
}

TEST(RecordFile, TwoColumns) { expect_three(read("t,a\n0,0\n0.5,-1.5\n2,2e1\n")); }

TEST(RecordFile, NamedColumnsInAnyOrder) {
  expect_three(read("x,a,t\n9,0,0\n9,-1.5,0.5\n9,20,2\n", {.file = {}, .time = "t", .value = "a"}));
}

TEST(RecordFile, CommentsBlankLinesAndEndsOfLinesOfEitherKind) {
  expect_three(read("# made by hand\r\n\r\nt,a\r\n0,0\r\n  \r\n# more\r\n0.5,-1.5\r\n2,20"));
}

TEST(RecordFile, ByteOrderMarkQuotesPlusAndBlanks) {
  expect_three(read("\xEF\xBB\xBF\"t\" , \"a\"\n 0 , +0 \n0.5, -1.5\n+2,\t+20\n"));
}

TEST(RecordFile, OtherSeparators) {
  expect_three(read("t;a\n0;0\n0.5;-1.5\n2;20\n"));
  expect_three(read("t\ta\n0\t0\n0.5\t-1.5\n2\t20\n"));
}

TEST(RecordFile, DecimalCommasWhereCommasDoNotPartColumns) {
  expect_three(read("t;a\n0;0\n0,5;-1,5\n2;2,0e1\n"));
  expect_three(read("t [s]\ta\r\n0\t0\r\n\"0,5\"\t-1,5\r\n+2,00\t20\r\n"));
}

TEST(RecordFile, SeparatorsAtTheEndsOfRows) { expect_three(read("t,a,\n0,0,\n0.5,-1.5,,\n2,2e1\n")); }

TEST(RecordFile, UnitsOfTheHeader) {
  expect_three(read("t [ms],a (cm/s2)\n0,0\n500,-150\n2000,2000\n"));
  expect_three(read("t,a [-]\n0,0\n0.5,-1.5\n2,20\n"));
}

TEST(RecordFile, UnitsOfTheScene) {
  const Recording record = read("t,a\n0,0\n500,-1\n", {.file = {}, .time_unit = "ms", .value_unit = "g", .scale = 2});
  EXPECT_EQ(record.times().back(), 0.5);
  EXPECT_EQ(record.values().back(), -2 * 9.80665);
}

TEST(RecordFile, WithoutUnitValuesAreFactors) { EXPECT_EQ(read("t,a\n0,0\n1,3\n").values().back(), 3); }

// As where a velocity drives a traction, whose figure is an impedance.
TEST(RecordFile, ValuesAreFactorsWhereTheSceneSaysSo) {
  const std::string file = "t,v [m/s]\n0,0\n1,3\n";
  EXPECT_EQ(read(file, {.file = {}, .value_unit = "-", .dimension = Dimension::stress}).values().back(), 3);
}

TEST(RecordFile, BaselineOnRequest) {
  const Recording record = read("t,a\n0,1\n1,3\n", {.file = {}, .correct_baseline = true});
  EXPECT_NEAR(record.integral(1), 0, 1e-15);
  EXPECT_NEAR(record.second_integral(1), 0, 1e-15);
}

// The integrals here are sums of Simpson's rule, which is exact for straight lines, from sample to sample.
TEST(RecordFile, BaselineOfWhatActsWhereTheRestComesBefore) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SeededNumbers random(seed);
    std::string text = "t,a\n";
    const int samples = random.integer(2, 80);
    double time = random.number(-3, -1);
    for (int i = 0; i < samples; ++i, time += random.number(0.001, 0.2))
      text += std::to_string(time) + "," + std::to_string(random.number(-5, 5)) + "\n";
    const double last = time, from = random.number(-2, 1);
    const Recording record = read(text, {.file = {}, .correct_baseline = true, .acts_from = from});
    if (from >= record.times().back()) continue;
    double velocity = 0, displacement = 0, begin = std::max(from, record.times().front());
    for (const double end : record.times()) {
      if (end <= begin) continue;
      const double h = end - begin, middle = record.value((begin + end) / 2), first = record.value(begin);
      displacement += h * velocity + h * h * (first + 2 * middle) / 6;
      velocity += h * (first + 4 * middle + record.value(end)) / 6;
      begin = end;
    }
    EXPECT_NEAR(velocity, 0, 1e-12 * (last + 3)) << "seed " << seed;
    EXPECT_NEAR(displacement, 0, 1e-12 * (last + 3) * (last + 3)) << "seed " << seed;
  }
}

struct Bad {
  std::string what;
  std::string text;
  std::vector<std::string> sentence;
  RecordRequest request = {};
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.what; }

class BadRecord : public testing::TestWithParam<Bad> {};

TEST_P(BadRecord, GivesOneSentence) {
  try {
    read(GetParam().text, GetParam().request);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    expect_sentence(error.what(), {"place: record.csv", " is ", ", expected "});
    expect_sentence(error.what(), GetParam().sentence);
  }
}

const RecordRequest named{.file = {}, .time = "t", .value = "a"};

const std::vector<Bad> bad_records = {
    {"empty", "", {"is empty", "header"}},
    {"only comments", "# t,a\n\n", {"is empty"}},
    {"only a header", "t,a\n", {"of 0 samples", "at least two"}},
    {"one sample", "t,a\n0,0\n", {"of 1 samples"}},
    {"no header", "0,0\n1,1\n", {"line 1", "\"0,0\"", "names of the columns"}},
    {"no such column", "time,a\n0,0\n1,1\n", {"line 1", "\"time\", \"a\"", "a column \"t\""}, named},
    {"column twice", "t,a,a\n0,0,0\n1,1,1\n", {"line 1", "one column \"a\""}, named},
    {"same column twice", "t,a\n0,0\n1,1\n", {"two columns"}, {.file = {}, .time = "a", .value = "a"}},
    {"one column", "t\n0\n1\n", {"line 1", "two columns"}},
    {"which of three", "t,a,b\n0,0,0\n1,1,1\n", {"line 1", "\"value\" in the scene"}},
    {"text", "t,a\n0,0\n\n1,fast\n", {"line 4, column \"a\"", "\"fast\"", "a finite number"}},
    {"number and more", "t,a\n0,0\n1,1 g\n", {"line 3, column \"a\"", "\"1 g\""}},
    {"two signs", "t,a\n0,0\n1,+-1\n", {"line 3, column \"a\"", "\"+-1\""}},
    {"commas after points", "t;a\n0;0.5\n1;1,500\n", {"line 3, column \"a\"", "\"1,500\"", "\".\" before"}},
    {"points after commas", "t;a\n0;0,5\n1.5;1\n", {"line 3, column \"t\"", "\"1.5\"", "\",\" before"}},
    {"thousands", "t;a\n0;0\n1;1,500.5\n", {"line 3, column \"a\"", "\"1,500.5\"", "a finite number"}},
    {"decimal commas between commas", "t,a\n0,0\n0,1,1,5\n0,2,2\n", {"line 3", "of 4 columns", "2 as in the header"}},
    {"NaN", "t,a\n0,0\n1,nan\n", {"line 3, column \"a\"", "\"nan\"", "a finite number"}},
    {"infinite time", "t,a\n0,0\ninf,1\n", {"line 3, column \"t\"", "\"inf\""}},
    {"too large", "t,a\n0,0\n1,1e999\n", {"line 3, column \"a\"", "1e999"}},
    {"too large in SI", "t,a\n0,0\n1,1e308\n", {"line 3, column \"a\"", "scale"}, {.file = {}, .scale = 1e10}},
    {"empty cell", "t,a\n0,0\n1,\n", {"line 3, column \"a\"", "\"\""}},
    {"missing cell", "t,a\n0,0\n1\n", {"line 3, column \"a\"", "is missing"}},
    {"time stands still", "t,a\n0,0\n1,1\n1,2\n", {"line 4, column \"t\"", "\"1\"", "later time"}},
    {"time goes back", "t,a\n0,0\n1,1\n0.5,2\n", {"line 4, column \"t\"", "\"0.5\""}},
    {"unknown unit in the header", "t,a [gal]\n0,0\n1,1\n", {"line 1, column \"a\"", "\"gal\"", "acceleration"}},
    {"unit of another dimension", "t,a [kN]\n0,0\n1,1\n", {"line 1, column \"a\"", "\"kN\"", "acceleration"}},
    {"two units", "t,a [g]\n0,0\n1,1\n", {"column \"a\"", "\"g\"", "\"m/s2\""}, {.file = {}, .value_unit = "m/s2"}},
    {"a NUL", "t,a\n0,0\n1,1\0junk\n"s, {"line 3, column \"a\""}},
    {"too long", "t,a\n0,0\n1,1\n2,0\n", {"line 4", "at most 2 samples"}, {.file = {}, .most_samples = 2}},
    {"endless line", "t,a\n0," + std::string(20000, '1'), {"line 2", "longer than"}},
    {"text of spreadsheets", "\xFF\xFEt\0,\0a\0\n\0"s, {"text in UTF-16", "text in UTF-8"}},
    {"binary", std::string(3000, '\x01') + "\n", {"line 1"}},
};

INSTANTIATE_TEST_SUITE_P(RecordFile, BadRecord, testing::ValuesIn(bad_records));

TEST(BadRecordFile, MissingOrNoFile) {
  for (const std::filesystem::path& file :
       {std::filesystem::path("/nowhere/quake.csv"), std::filesystem::path(testing::TempDir()),
        std::filesystem::path("/dev/zero")}) {
    RecordRequest request;
    request.file = file;
    try {
      read_record(request, "place");
      FAIL() << "accepted " << file;
    } catch (const InputError& error) {
      expect_sentence(error.what(), {"place: ", file.string(), "expected a CSV file"});
    }
  }
}

}  // namespace
}  // namespace dda
