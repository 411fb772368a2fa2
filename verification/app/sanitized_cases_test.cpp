// Under sanitizers only cases that take milliseconds without, one of every kind of scene, law and integrator. Their
// files are the library basic_cases, so that a sanitized build need not compile the others.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "verification/cases/bar_ends_cases.h"
#include "verification/cases/contact_oscillator_cases.h"
#include "verification/cases/p_bar_cases.h"
#include "verification/cases/rigid_motion_cases.h"
#include "verification/cases/statics_cases.h"
#include "verification/suite/row.h"
#include "verification/suite/runner.h"

namespace verify {
namespace {

constexpr std::array subjects{rigid_motion_cases, contact_oscillator_cases, statics_cases, p_bar_cases, bar_ends_cases};

class SanitizedCase : public testing::TestWithParam<const char*> {};

TEST_P(SanitizedCase, Passes) {
  int found = 0;
  for (const auto subject : subjects)
    for (const Case& each : subject()) {
      if (each.id != GetParam()) continue;
      ++found;
      for (const Row& row : run_case(each)) EXPECT_TRUE(row.passed) << describe(row);
    }
  EXPECT_EQ(found, 1);
}

INSTANTIATE_TEST_SUITE_P(Milliseconds, SanitizedCase,
                         testing::Values("free-fall", "free-spin", "contact-oscillator-no-decay",
                                         "uniaxial-compression-consistent", "stack-stiffness", "self-weight-stress",
                                         "p-bar-chain-plane-strain", "p-bar-chain-cubic-options", "p-bar-speed-cubic",
                                         "bar-ends-matched"));

}  // namespace
}  // namespace verify
