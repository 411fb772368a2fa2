#include "verification/cases/all_cases.h"

#include <initializer_list>

namespace verify {
namespace {

// One function a subject; its cases keep their order.
const std::initializer_list<std::vector<Case> (*)()> subjects = {};

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
