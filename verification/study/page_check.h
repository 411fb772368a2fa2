// Whether a page in the repository still says what a study gives.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace verify {

// The lines of `printed`, a page made earlier, that are not so in `made`, a sentence each. Texts must be the same; a
// number may differ by that many in its last printed digit: by one, because round-off is not the same on every
// processor, or by more where the page says more than the study can.
[[nodiscard]] std::vector<std::string> stale_lines(std::string_view printed, std::string_view made,
                                                   int last_digits = 1);

}  // namespace verify
