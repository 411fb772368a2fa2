// Three colour maps with even steps of colour: equal differences of value look equally different.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/core/types.h"

namespace dda {

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

// "#rrggbb".
std::string to_hex(const Rgb& colour);

// Lightness and the two opponent axes of OKLab (B. Ottosson, "A perceptual color space for image processing", 2020), in
// which the distance of two colours is how different they look.
Vec3 oklab(const Rgb& colour);

using ColourMap = std::array<Rgb, 256>;

// From light (nothing) to dark (much), for quantities of one sign.
const ColourMap& sequential_map();

// Blue, light in the middle, red, for quantities of both signs: compression blue, tension red.
const ColourMap& diverging_map();

// For lines, of how much of its strength something carries: from green, nothing, to the orange of what yields.
const ColourMap& utilisation_map();

}  // namespace dda
