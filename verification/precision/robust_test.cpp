#include "verification/precision/robust.h"

#include <gtest/gtest.h>

#include <limits>

namespace verify {
namespace {

Measured run(const PrecisionScheme& scheme, double size, double dt, double error) {
  Measured measured;
  measured.job = {Problem::bar, scheme, size, dt};
  measured.result.error = error;
  return measured;
}

std::vector<double> sizes(const std::vector<Measured>& runs) {
  std::vector<double> result;
  for (const Measured& measured : runs) result.push_back(measured.job.size);
  return result;
}

TEST(RobustRuns, AreThoseWhoseFinerRunsHoldToo) {
  const PrecisionScheme scheme{"cubic", "trapezoidal"};
  const std::vector<Measured> runs = {run(scheme, 4, 4, 0.009), run(scheme, 4, 2, 0.02), run(scheme, 2, 2, 0.008),
                                      run(scheme, 2, 1, 0.001), run(scheme, 3, 3, 0.02)};
  EXPECT_EQ(sizes(robust_runs(runs, Norm::l2, 0.01)), (std::vector<double>{2, 2}));
  EXPECT_EQ(sizes(robust_runs(runs, Norm::l2, 0.02)), (std::vector<double>{4, 4, 2, 2, 3}));
  EXPECT_TRUE(robust_runs(runs, Norm::l2, 1e-4).empty());
}

TEST(RobustRuns, FinerIsWithARatioNoLarger) {
  const PrecisionScheme scheme{"cubic", "trapezoidal"};
  EXPECT_EQ(robust_runs({run(scheme, 4, 2, 0.009), run(scheme, 1, 2, 0.5)}, Norm::l2, 0.01).size(), 1U);
}

TEST(RobustRuns, OfOneSchemeAreNotAskedOfAnother) {
  const std::vector<Measured> runs = {run({"cubic", "trapezoidal"}, 4, 4, 0.009), run({"cubic", "thesis"}, 2, 2, 0.5)};
  EXPECT_EQ(robust_runs(runs, Norm::l2, 0.01).size(), 1U);
}

TEST(RobustRuns, WithoutAnErrorNoRunHolds) {
  const PrecisionScheme scheme{"cubic", "trapezoidal"};
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(robust_runs({run(scheme, 4, 4, 0.009), run(scheme, 2, 2, none)}, Norm::l2, 0.01).empty());
}

}  // namespace
}  // namespace verify
