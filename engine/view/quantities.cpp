#include "engine/view/quantities.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/principal_stress.h"

namespace dda {

const std::array<DrawnQuantity, drawn_quantity_count> drawn_quantities = {{
    {"mean_stress", "Mean stress", "Pa", [](const Frame& f, std::size_t i) { return mean_stress(f.stress[i]); }},
    {"stress_1", "Largest principal stress", "Pa",
     [](const Frame& f, std::size_t i) { return largest_principal(f.stress[i]); }},
    {"stress_2", "Smallest principal stress", "Pa",
     [](const Frame& f, std::size_t i) { return smallest_principal(f.stress[i]); }},
    {"max_shear", "Largest shear stress", "Pa",
     [](const Frame& f, std::size_t i) { return largest_shear(f.stress[i]); }},
    {"stress_xx", "Stress \u03c3xx", "Pa", [](const Frame& f, std::size_t i) { return f.stress[i][0]; }},
    {"stress_yy", "Stress \u03c3yy", "Pa", [](const Frame& f, std::size_t i) { return f.stress[i][1]; }},
    {"stress_xy", "Stress \u03c3xy", "Pa", [](const Frame& f, std::size_t i) { return f.stress[i][2]; }},
    {"speed", "Speed", "m/s", [](const Frame& f, std::size_t i) { return f.velocity[i].norm(); }},
    {"displacement", "Displacement", "m", [](const Frame& f, std::size_t i) { return f.moved[i].norm(); }},
}};

std::size_t find_quantity(std::string_view id, const std::string& option) {
  std::vector<std::string_view> ids;
  for (std::size_t i = 0; i < drawn_quantities.size(); ++i) {
    if (drawn_quantities[i].id == id) return i;
    ids.push_back(drawn_quantities[i].id);
  }
  throw InputError("", option, fmt::format("\"{}\"", id), fmt::format("one of {}", fmt::join(ids, ", ")));
}

PrincipalStress principal_stress(const Vec3& stress) {
  const double angle = principal_angle(stress);
  return {largest_principal(stress), smallest_principal(stress), Vec2(std::cos(angle), std::sin(angle))};
}

}  // namespace dda
