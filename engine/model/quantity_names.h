// Names and units of what can be measured, as scenes and CSV headers write them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "engine/model/measurement.h"

namespace dda {

// What a measurement is taken of.
enum class Subject { block, joint, bolt, lining, reaction, contact_force, resultant, excess_shear, contacts };

// A history is called as its measurement, with the suffix behind; the unit is SI.
struct HistoryFacts {
  std::string_view suffix, unit;
};

struct QuantityFacts {
  Quantity quantity;
  std::string_view name;
  Subject subject;
  std::span<const HistoryFacts> histories;
};

namespace histories {

inline constexpr std::array<HistoryFacts, 1> pressure{{{"", "Pa"}}};
inline constexpr std::array<HistoryFacts, 1> angle{{{"", "rad"}}};
inline constexpr std::array<HistoryFacts, 1> length{{{"", "m"}}};
inline constexpr std::array<HistoryFacts, 1> velocity{{{"", "m/s"}}};
inline constexpr std::array<HistoryFacts, 1> acceleration{{{"", "m/s2"}}};
inline constexpr std::array<HistoryFacts, 1> force{{{"", "N"}}};
inline constexpr std::array<HistoryFacts, 1> moment{{{"", "N m"}}};
inline constexpr std::array<HistoryFacts, 1> energy{{{"", "J"}}};
inline constexpr std::array<HistoryFacts, 3> force_and_moment{{{"_x", "N"}, {"_y", "N"}, {"_moment", "N m"}}};
inline constexpr std::array<HistoryFacts, 4> force_on_joint{
    {{"_x", "N"}, {"_y", "N"}, {"_normal", "N"}, {"_shear", "N"}}};
inline constexpr std::array<HistoryFacts, 2> excess{{{"", "Pa"}, {"_length", "m"}}};
inline constexpr std::array<HistoryFacts, 5> statistics{
    {{"_open", "-"}, {"_sliding", "-"}, {"_sticking", "-"}, {"_passes", "-"}, {"_penetration", "m"}}};

}  // namespace histories

inline constexpr std::array all_quantities{
    // in the order of Quantity
    QuantityFacts{Quantity::stress_xx, "stress_xx", Subject::block, histories::pressure},
    QuantityFacts{Quantity::stress_yy, "stress_yy", Subject::block, histories::pressure},
    QuantityFacts{Quantity::stress_xy, "stress_xy", Subject::block, histories::pressure},
    QuantityFacts{Quantity::stress_1, "stress_1", Subject::block, histories::pressure},
    QuantityFacts{Quantity::stress_2, "stress_2", Subject::block, histories::pressure},
    QuantityFacts{Quantity::stress_angle, "stress_angle", Subject::block, histories::angle},
    QuantityFacts{Quantity::mean_stress, "mean_stress", Subject::block, histories::pressure},
    QuantityFacts{Quantity::max_shear, "max_shear", Subject::block, histories::pressure},
    QuantityFacts{Quantity::displacement_x, "displacement_x", Subject::block, histories::length},
    QuantityFacts{Quantity::displacement_y, "displacement_y", Subject::block, histories::length},
    QuantityFacts{Quantity::velocity_x, "velocity_x", Subject::block, histories::velocity},
    QuantityFacts{Quantity::velocity_y, "velocity_y", Subject::block, histories::velocity},
    QuantityFacts{Quantity::acceleration_x, "acceleration_x", Subject::block, histories::acceleration},
    QuantityFacts{Quantity::acceleration_y, "acceleration_y", Subject::block, histories::acceleration},
    QuantityFacts{Quantity::rotation, "rotation", Subject::block, histories::angle},
    QuantityFacts{Quantity::kinetic_energy, "kinetic_energy", Subject::block, histories::energy},
    QuantityFacts{Quantity::traction_normal, "traction_normal", Subject::joint, histories::pressure},
    QuantityFacts{Quantity::traction_shear, "traction_shear", Subject::joint, histories::pressure},
    QuantityFacts{Quantity::bolt_force, "bolt_force", Subject::bolt, histories::force},
    QuantityFacts{Quantity::bolt_shear, "bolt_shear", Subject::bolt, histories::force},
    QuantityFacts{Quantity::bolt_elongation, "bolt_elongation", Subject::bolt, histories::length},
    QuantityFacts{Quantity::lining_thrust, "lining_thrust", Subject::lining, histories::force},
    QuantityFacts{Quantity::lining_moment, "lining_moment", Subject::lining, histories::moment},
    QuantityFacts{Quantity::lining_shear, "lining_shear", Subject::lining, histories::force},
    QuantityFacts{Quantity::reaction, "reaction", Subject::reaction, histories::force_and_moment},
    QuantityFacts{Quantity::contact_force, "contact_force", Subject::contact_force, histories::force_on_joint},
    QuantityFacts{Quantity::resultant, "resultant", Subject::resultant, histories::force_and_moment},
    QuantityFacts{Quantity::excess_shear, "excess_shear", Subject::excess_shear, histories::excess},
    QuantityFacts{Quantity::contacts, "contacts", Subject::contacts, histories::statistics},
};

static_assert([] {
  for (std::size_t i = 0; i < all_quantities.size(); ++i)
    if (static_cast<std::size_t>(all_quantities[i].quantity) != i) return false;
  return true;
}());

constexpr const QuantityFacts& facts_of(Quantity quantity) {
  return all_quantities[static_cast<std::size_t>(quantity)];
}
constexpr std::string_view to_string(Quantity quantity) { return facts_of(quantity).name; }
constexpr Subject subject_of(Quantity quantity) { return facts_of(quantity).subject; }
constexpr std::span<const HistoryFacts> histories_of(Quantity quantity) { return facts_of(quantity).histories; }

// Taken at the point that it names, and of nothing else.
inline bool is_at_point(const Measurement& measurement) {
  const Subject subject = subject_of(measurement.quantity);
  return subject == Subject::joint || (subject == Subject::block && measurement.blocks.empty());
}

}  // namespace dda
