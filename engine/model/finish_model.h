// The two halves of finish_model, for those who need finished blocks to say what acts on them.
#pragma once

#include "engine/model/model.h"

namespace dda {

// Materials, joints and shapes: checked, with the moments of the blocks and the tolerance for lengths.
void finish_blocks(Model& model);

// All else, of a model whose blocks are finished and have kept their shapes, materials and names since.
void finish_around_blocks(Model& model);

}  // namespace dda
