#include "verification/cases/all_cases.h"

#include <array>

#include "verification/cases/bar_ends_cases.h"
#include "verification/cases/contact_oscillator_cases.h"
#include "verification/cases/p_bar_cases.h"
#include "verification/cases/rigid_motion_cases.h"
#include "verification/cases/statics_cases.h"

namespace verify {
namespace {

// One function a subject; its cases keep their order.
constexpr std::array subjects{
    rigid_motion_cases, contact_oscillator_cases, statics_cases, p_bar_cases, bar_ends_cases,
};

std::vector<Case> collect() {
  std::vector<Case> cases;
  for (const auto subject : subjects)
    for (Case& each : subject()) cases.push_back(std::move(each));
  return cases;
}

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = collect();
  return cases;
}

}  // namespace verify
