#include "verification/thesis/blast_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "verification/exact/wave_speeds.h"

namespace verify {
namespace {

// What the distances were inferred from: 1.1 R/c_P of Eq. 11 with nu = 1/3, within half a unit of the last digit
// printed or what is cut from it (6.906 is printed as 6.9).
TEST(ThesisBlast, PredictionsAreElevenTenthsOfTheWayOverTheSpeed) {
  const ThesisBlast& blast = thesis_blast();
  ASSERT_EQ(blast.points.size(), 10U);
  const double speed = exact::p_speed_plane_strain(blast.young, 1.0 / 3, blast.density);
  for (const PrintedArrival& point : blast.points)
    EXPECT_NEAR(1.1 * point.distance / speed * 1e3, point.predicted_ms, 0.01) << point.point;
}

// The printed percentages come from unrounded times: they recompute to within what rounding to 0.01 ms does.
TEST(ThesisBlast, PrintedErrorsFollowFromPrintedTimes) {
  const auto errors = nlohmann::json::parse(thesis_blast_text()).at("table_4_1").at("error");
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const PrintedArrival& point = thesis_blast().points[i];
    if (!point.actual_ms) {
      EXPECT_EQ(errors[i], "N/A");
      continue;
    }
    const double error = 100 * (*point.actual_ms / point.predicted_ms - 1);
    EXPECT_NEAR(error, std::stod(errors[i].get<std::string>()), 100 * 0.01 / point.predicted_ms + 0.2) << point.point;
  }
}

}  // namespace
}  // namespace verify
