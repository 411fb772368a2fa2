// What blocks can be coloured by.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "engine/view/run_results.h"

namespace dda {

struct DrawnQuantity {
  std::string_view id;  // as on the command line
  std::string_view title;
  std::string_view unit;  // SI
  double (*value)(const Frame& frame, std::size_t block);
};

inline constexpr std::size_t drawn_quantity_count = 9;
extern const std::array<DrawnQuantity, drawn_quantity_count> drawn_quantities;

// Index by id; InputError naming `option` and listing the ids for one that is not known.
std::size_t find_quantity(std::string_view id, const std::string& option);

struct PrincipalStress {
  double first = 0, second = 0;  // Pa, first >= second, tension positive
  Vec2 direction;                // unit, of the first
};

PrincipalStress principal_stress(const Vec3& stress);

}  // namespace dda
