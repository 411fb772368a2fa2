// A picture (SVG) of key blocks: bodies by type, the way they begin to move, what is taken out.
#pragma once

#include <string>

#include "engine/keyblocks/key_blocks.h"

namespace dda {

std::string keyblocks_picture(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model);

}  // namespace dda
