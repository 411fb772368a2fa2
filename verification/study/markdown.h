// Documents as Markdown (GitHub's tables).
#pragma once

#include <string>

#include "verification/study/document.h"

namespace verify {

[[nodiscard]] std::string to_markdown(const Document& document);

}  // namespace verify
