// Catalogue 9: the friction beyond which an elastic block chatters instead of sliding.
#pragma once

#include <vector>

#include "verification/suite/case.h"

namespace verify {

std::vector<Case> chatter_cases();

}  // namespace verify
