// What a search for the factor of safety does not see: loads and motions that still change after the moment it takes
// them at.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// "a load on "box"", "the motion of "base"" and so on, once each; `time` in s.
std::vector<std::string> unseen_by_fos(const Model& model, double time);

// Says so in a line, and how a steady acceleration is given instead; empty where nothing is unseen.
std::string said_of_unseen(const std::vector<std::string>& unseen, double time);

}  // namespace dda
