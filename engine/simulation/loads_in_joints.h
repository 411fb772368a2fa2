// Loads on faces along which blocks touch, as the water in a joint is one, when some of these blocks are taken out.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// One flag an edge load of the model: whether it lies on a face along which one of `blocks` touches another as drawn,
// on either side.
std::vector<bool> loads_in_joints_of(const std::vector<int>& blocks, const Model& model);

// One flag an edge load: whether it acts on a block that stays, lies on a face that blocks covered which this stage
// takes out, and ends as they go. What blocks exerted through a joint with water in it is what the joint carried and
// what the water did, so both fade together; but not where another load comes on the face with the stage.
std::vector<bool> loads_that_go_with_blocks(std::size_t stage, const Model& model);

}  // namespace dda
