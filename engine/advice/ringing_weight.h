// Weight that acts at once, on blocks that friction is to hold on slopes.
#pragma once

#include <string>
#include <vector>

#include "engine/contact/contact_set.h"
#include "engine/model/model.h"

namespace dda {

// A block on which its weight acts at once swings up and down on what it lies on, between no pressure and twice its
// weight. Where steps resolve that swing and nothing damps it, friction holds the block half of the time only and it
// creeps: a block of 1 m (10 GPa) on 20 degrees under a friction of 30 goes 88 mm in the first second at a dt of 10 us,
// and 0.4 um in steps that damp the swing, or after a static stage.
// One sentence, without a full stop, for the first stage of a run that begins with the drawing; none where the stage
// is static or damps, where the blocks begin with stress, and where nothing rubs on an inclined joint.
std::vector<std::string> ringing_weight(const Model& model, const ContactSet& contacts);

}  // namespace dda
