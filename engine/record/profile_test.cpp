#include "engine/record/profile.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/core/read_file.h"
#include "engine/record/record_test_support.h"

namespace dda {
namespace {

std::int64_t time_now = 0;
std::int64_t set_time() { return time_now; }

// Half a second of products within a second of solution, and a quarter of a second of nothing known.
void spend_time() {
  time_now += 125'000'000;
  const PhaseScope solution(Phase::solution);
  time_now += 500'000'000;
  const PhaseScope product(Phase::product);
  time_now += 500'000'000;
}

double shares_in(const std::string& table) {
  std::istringstream lines(table);
  double sum = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.ends_with(" %") && !line.starts_with("all")) sum += std::stod(line.substr(line.size() - 8));
  return sum;
}

TEST(Profile, SharesInTheTableAddUp) {
  PhaseClock clock(set_time);
  spend_time();
  time_now += 125'000'000;
  Counters counters;
  counters.solves = 7;
  const std::string table = profile_table(clock, counters);
  EXPECT_DOUBLE_EQ(shares_in(table), 100);
  EXPECT_NE(table.find("operator products                           1     0.500000  40.00 %"), std::string::npos)
      << table;
  EXPECT_NE(table.find("other                                       1     0.250000  20.00 %"), std::string::npos)
      << table;
  EXPECT_NE(table.find("all                                               1.250000 100.00 %"), std::string::npos)
      << table;
  EXPECT_NE(table.find("solves                                      7"), std::string::npos) << table;
  EXPECT_EQ(table.find("assembly"), std::string::npos) << table;
}

TEST(Profile, FileIsATraceWithTheSameFigures) {
  const TemporaryFolder folder;
  PhaseClock clock(set_time);
  spend_time();
  write_profile(folder / "profile.json", clock, {});
  const auto trace = nlohmann::json::parse(read_file(folder / "profile.json"));
  ASSERT_EQ(trace.at("traceEvents").size(), 2U);
  const auto& product = trace["traceEvents"][0];
  EXPECT_EQ(product.at("name"), "operator products");
  EXPECT_EQ(product.at("ph"), "X");
  EXPECT_DOUBLE_EQ(product.at("ts"), 625'000.0);
  EXPECT_DOUBLE_EQ(product.at("dur"), 500'000.0);
  const auto& summary = trace.at("otherData");
  EXPECT_DOUBLE_EQ(summary.at("wall_s"), 1.125);
  EXPECT_EQ(summary.at("events_left_out"), 0);
  EXPECT_EQ(summary.at("counters").at("steps"), 0);
  double seconds = 0;
  for (const auto& phase : summary.at("phases")) seconds += phase.at("seconds").get<double>();
  EXPECT_DOUBLE_EQ(seconds, 1.125);
}

TEST(Profile, WithoutEventsItIsAFileAsWell) {
  const TemporaryFolder folder;
  const PhaseClock clock(set_time);
  write_profile(folder / "profile.json", clock, {});
  EXPECT_TRUE(nlohmann::json::parse(read_file(folder / "profile.json")).at("traceEvents").empty());
}

}  // namespace
}  // namespace dda
