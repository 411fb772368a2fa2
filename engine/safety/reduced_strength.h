// A model whose joints have a share of their strength.
#pragma once

#include "engine/model/model.h"

namespace dda {

// The model with every joint's tan(friction angle), cohesion, tensile strength, residual values and tan(dilation angle)
// divided by `factor` (above 0): the strength reduction of Zienkiewicz, Humpheson & Lewis (1975), for joints. Bonded
// joints, bolts, linings and stiffnesses stay as they are. Above a factor of 1 the model is weaker than it was. To be
// finished anew.
[[nodiscard]] Model with_strength_over(double factor, Model model);

// Whether a joint has more cohesion or friction before it slides than afterwards.
[[nodiscard]] bool loses_strength(const Model& model);

// The model with joints that keep cohesion and friction as they slide, which is what limit equilibrium takes. To be
// finished anew.
[[nodiscard]] Model with_strength_kept(Model model);

}  // namespace dda
