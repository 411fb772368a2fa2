#include "verification/harness/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace verify {

nlohmann::ordered_json json_of(const Check& check) {
  using Json = nlohmann::ordered_json;
  return {{"what", check.what},
          {"value", std::isfinite(check.value) ? Json(check.value) : Json(nullptr)},
          {"allowed", check.allowed},
          {"holds", check.holds()}};
}

std::string first_failure(const std::vector<Check>& checks) {
  const auto failed = std::ranges::find_if_not(checks, &Check::holds);
  return failed == checks.end()
             ? ""
             : fmt::format("{}: {:.3g}, {:.2g} is allowed", failed->what, failed->value, failed->allowed);
}

}  // namespace verify
