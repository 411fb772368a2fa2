// Blocks of one name that are taken out of the rock in several places.
#pragma once

#include <string>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// Sorts `opening` (ascending blocks of a model whose blocks are complete) by the places in which it leaves the rock
// open: blocks are in one place where they touch along a face, directly or over others that are `away` then (one flag a
// block, those of the opening among them), or where one wall surrounds them, as around an opening that had no blocks in
// its middle. Places, and the blocks in each, are in ascending order.
std::vector<std::vector<int>> separate_places(const std::vector<int>& opening, const std::vector<bool>& away,
                                              const Model& model);

// Says so of a name whose blocks lie in more than one place: its part of a sentence.
std::string in_several_places(const std::string& name, const std::vector<std::vector<int>>& places, const Model& model);

}  // namespace dda
