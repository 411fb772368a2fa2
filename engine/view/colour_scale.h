// From values to colours: range, kind of map, ticks and unit of the colour bar.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/view/colour_map.h"

namespace dda {

struct ColourScale {
  double low = 0;
  double high = 1;
  bool diverging = false;
  // Sequential maps are light at the end nearer to zero: at `low`, or where this is set at `high`.
  bool dark_low = false;
  double least = 0, most = 0;  // of all values; what lies beyond low or high has the colour of that end

  [[nodiscard]] Rgb colour(double value) const;     // of a value that is no number: grey
  [[nodiscard]] Rgb colour_at(double share) const;  // from 0 at `low` to 1 at `high`
};

// A scale for these values: from zero where that is near; both signs: as far to either side; without the outermost
// values where a few are far beyond the rest (2 % at either end), as in impacts. Values that are no numbers do not
// count.
ColourScale scale_of(std::vector<double> values);

// An SI unit with a prefix, for numbers of this magnitude: "Pa" and 2e6 give {1e6, "MPa"}.
struct ScaledUnit {
  double factor = 1;
  std::string name;
};
ScaledUnit scaled_unit(std::string_view unit, double magnitude);

// Round values between low and high, at most `most` + 1 of them, in steps of 1, 2 or 5 times a power of ten.
std::vector<double> ticks(double low, double high, int most);

// A number for a label, with as many digits as `step` needs, U+2212 as minus.
std::string label(double value, double step);

}  // namespace dda
