// Every case of the verification catalogue that `dda-verify run` knows.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

const std::vector<Case>& all_cases();

}  // namespace verify
