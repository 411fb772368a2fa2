#include "engine/core/quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <system_error>

#include "engine/core/error.h"

namespace dda {
namespace {

constexpr double standard_gravity = 9.80665;  // m/s2, exact by definition (CGPM 1901)

constexpr std::array dimensionless_units = {Unit{"", 1, 1}, Unit{"%", 1, 100}};
constexpr std::array length_units = {Unit{"m", 1, 1}, Unit{"km", 1e3, 1}, Unit{"cm", 1, 1e2}, Unit{"mm", 1, 1e3},
                                     Unit{"um", 1, 1e6}};
constexpr std::array time_units = {Unit{"s", 1, 1},    Unit{"ms", 1, 1e3}, Unit{"us", 1, 1e6},
                                   Unit{"ns", 1, 1e9}, Unit{"min", 60, 1}, Unit{"h", 3600, 1}};
constexpr std::array angle_units = {Unit{"rad", 1, 1}, Unit{"mrad", 1, 1e3}, Unit{"deg", std::numbers::pi, 180}};
constexpr std::array mass_units = {Unit{"kg", 1, 1}, Unit{"g", 1, 1e3}, Unit{"t", 1e3, 1}};
constexpr std::array mass_density_units = {Unit{"kg/m3", 1, 1}, Unit{"t/m3", 1e3, 1}, Unit{"g/cm3", 1e3, 1}};
constexpr std::array stress_units = {Unit{"Pa", 1, 1},      Unit{"kPa", 1e3, 1}, Unit{"MPa", 1e6, 1},
                                     Unit{"GPa", 1e9, 1},   Unit{"N/m2", 1, 1},  Unit{"kN/m2", 1e3, 1},
                                     Unit{"MN/m2", 1e6, 1}, Unit{"bar", 1e5, 1}};
constexpr std::array force_units = {Unit{"N", 1, 1}, Unit{"kN", 1e3, 1}, Unit{"MN", 1e6, 1}, Unit{"GN", 1e9, 1}};
constexpr std::array force_per_length_units = {Unit{"N/m", 1, 1}, Unit{"kN/m", 1e3, 1}, Unit{"MN/m", 1e6, 1},
                                               Unit{"GN/m", 1e9, 1}};
constexpr std::array stiffness_per_area_units = {Unit{"Pa/m", 1, 1},    Unit{"kPa/m", 1e3, 1}, Unit{"MPa/m", 1e6, 1},
                                                 Unit{"GPa/m", 1e9, 1}, Unit{"N/m3", 1, 1},    Unit{"kN/m3", 1e3, 1},
                                                 Unit{"MN/m3", 1e6, 1}, Unit{"GN/m3", 1e9, 1}};
constexpr std::array frequency_units = {Unit{"Hz", 1, 1}, Unit{"kHz", 1e3, 1}, Unit{"MHz", 1e6, 1}};
constexpr std::array rate_units = {Unit{"1/s", 1, 1}, Unit{"1/ms", 1e3, 1}, Unit{"1/us", 1e6, 1}, Unit{"1/min", 1, 60}};
constexpr std::array velocity_units = {Unit{"m/s", 1, 1}, Unit{"km/s", 1e3, 1}, Unit{"cm/s", 1, 1e2},
                                       Unit{"mm/s", 1, 1e3}, Unit{"km/h", 1e3, 3600}};
constexpr std::array angular_velocity_units = {Unit{"rad/s", 1, 1}, Unit{"deg/s", std::numbers::pi, 180}};
constexpr std::array acceleration_units = {Unit{"m/s2", 1, 1}, Unit{"cm/s2", 1, 1e2}, Unit{"mm/s2", 1, 1e3},
                                           Unit{"g", standard_gravity, 1}};
constexpr std::array impedance_units = {Unit{"Pa s/m", 1, 1}, Unit{"kPa s/m", 1e3, 1}, Unit{"MPa s/m", 1e6, 1}};

struct DimensionEntry {
  std::string_view name;
  std::span<const Unit> units;
};

// In the order of Dimension.
constexpr std::array<DimensionEntry, dimension_count> dimensions = {{
    {"dimensionless", dimensionless_units},
    {"length", length_units},
    {"time", time_units},
    {"angle", angle_units},
    {"mass", mass_units},
    {"mass density", mass_density_units},
    {"stress", stress_units},
    {"force", force_units},
    {"force per length", force_per_length_units},
    {"stiffness per area", stiffness_per_area_units},
    {"frequency", frequency_units},
    {"rate", rate_units},
    {"velocity", velocity_units},
    {"angular velocity", angular_velocity_units},
    {"acceleration", acceleration_units},
    {"impedance", impedance_units},
}};

const DimensionEntry& entry(Dimension dimension) { return dimensions.at(static_cast<std::size_t>(dimension)); }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The other spellings of a unit, brought to the one of the tables.
std::string plain_symbol(std::string_view unit) {
  constexpr std::array<std::array<std::string_view, 2>, 7> spellings = {{{"^2", "2"},
                                                                         {"^3", "3"},
                                                                         {"\u00b2", "2"},
                                                                         {"\u00b3", "3"},
                                                                         {"\u00b5", "u"},
                                                                         {"\u03bc", "u"},
                                                                         {"\u00b0", "deg"}}};
  std::string symbol(unit);
  for (const auto& [from, to] : spellings) {
    for (std::size_t at = symbol.find(from); at != std::string::npos; at = symbol.find(from, at + to.size())) {
      symbol.replace(at, from.size(), to);
    }
  }
  return symbol;
}

const Unit* find_unit(std::string_view text, Dimension dimension) {
  const std::string symbol = plain_symbol(text);
  for (const Unit& unit : units(dimension)) {
    if (unit.symbol == symbol) return &unit;
  }
  return nullptr;
}

// In quotes, on one line and not longer than a sentence bears.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string shown(text.substr(0, longest));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return "\"" + shown + (text.size() > longest ? "..." : "") + "\"";
}

}  // namespace

std::span<const Unit> units(Dimension dimension) { return entry(dimension).units; }

std::string_view si_unit(Dimension dimension) { return units(dimension).front().symbol; }

std::string_view to_string(Dimension dimension) { return entry(dimension).name; }

std::string expected_quantity(Dimension dimension) {
  if (dimension == Dimension::dimensionless) return "a finite number without a unit, or with %";
  std::string list;
  for (const Unit& unit : units(dimension)) list.append(list.empty() ? "" : ", ").append(unit.symbol);
  return "a finite number with a unit of " + std::string(to_string(dimension)) + " (" + list + ")";
}

double parse_quantity(std::string_view text, Dimension dimension, std::string_view field) {
  const std::string_view body = trimmed(text);
  double number = 0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error == std::errc{}) {
    const std::string_view symbol = trimmed(body.substr(static_cast<std::size_t>(end - body.data())));
    const Unit* unit = find_unit(symbol, dimension);
    const double value =
        unit != nullptr ? number * unit->numerator / unit->denominator : std::numeric_limits<double>::quiet_NaN();
    if (std::isfinite(value)) return value;
  }
  throw InputError("", std::string(field), quoted(text), expected_quantity(dimension));
}

}  // namespace dda
