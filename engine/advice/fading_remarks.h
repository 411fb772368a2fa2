// What removed blocks, bolts and linings exerted, where it still fades when the run ends.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// A sentence for every stage whose removed blocks, and for the bolts and the linings of every withdrawal, of which more
// (or less) acts at the end of the run than their tables come to, without a full stop. A table that ends above zero is
// meant so, and nothing is said of it once the run has reached its end.
std::vector<std::string> fading_remarks(const Model& model);

}  // namespace dda
