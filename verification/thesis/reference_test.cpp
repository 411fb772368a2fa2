#include "verification/thesis/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace verify {
namespace {

TEST(ThesisReference, HoldsTheBarInSiUnits) {
  const ThesisBar& bar = thesis_reference().bar;
  EXPECT_EQ(bar.young, 50e9);
  EXPECT_NEAR(bar.wave_speed(), 4343.72, 0.005);  // m/s, two decimals in the project's notes
  EXPECT_NEAR(bar.friction_angle, 0.61087, 1e-5);
  EXPECT_EQ(bar.incident_stress(), 1e6);
}

// The thesis prints eta with three digits.
TEST(ThesisReference, EtaAgreesWithThePrintedOne) {
  const auto printed = nlohmann::json::parse(thesis_tables_text()).at("eta_printed");
  const ThesisReference& reference = thesis_reference();
  ASSERT_EQ(printed.size(), reference.block_lengths.size());
  for (std::size_t i = 0; i < printed.size(); ++i)
    EXPECT_NEAR(reference.bar.eta(reference.block_lengths[i]), std::stod(printed[i].get<std::string>()), 5.5e-4);
}

// Guards against slips of the pen: each printed percentage follows from the printed number, within half a unit of its
// last digit (7.25 is printed as 7.2, hence the small surplus).
void expect_percentages(const char* table, double reference) {
  const auto tables = nlohmann::json::parse(thesis_tables_text());
  for (const auto& row : tables.at(table).at("rows")) {
    for (std::size_t i = 0; i < row.at("printed").size(); ++i) {
      const double value = std::stod(row["printed"][i].get<std::string>());
      const std::string error = row["printed_error"][i];
      const std::size_t point = error.find('.');
      const auto digits = point == std::string::npos ? 0.0 : static_cast<double>(error.size() - point - 2);
      EXPECT_NEAR(100 * std::abs(value / reference - 1), std::stod(error), 0.501 * std::pow(10, -digits)) << value;
    }
  }
}

TEST(ThesisReference, PrintedPercentagesFollowFromPrintedNumbers) {
  expect_percentages("table_3_2", 1000);
  expect_percentages("table_3_3", thesis_reference().bar.wave_speed());
}

TEST(ThesisReference, FindsAColumnAndRefusesOthers) {
  EXPECT_EQ(thesis_reference().at(1e-4, 2).amplitude_kpa, 888.2);
  EXPECT_EQ(thesis_reference().at(1e-5, 0.5).velocity, 4219.16);
  EXPECT_THROW((void)thesis_reference().at(1e-4, 3), std::out_of_range);
}

}  // namespace
}  // namespace verify
