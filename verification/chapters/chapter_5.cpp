#include "verification/chapters/chapter_5.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace verify {
namespace {

// Table 5.2. The density is not given; marble has 2500 to 2900 kg/m3.
constexpr double young = 25.3e9;  // Pa
constexpr double poisson = 0.22;
constexpr std::array densities{2500.0, 2700.0, 2900.0};  // kg/m3

// Eq. 11 is density c^2 = this times Young's modulus.
constexpr double plane_strain = (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));

struct Pair {
  const Sensor* near;
  const Sensor* far;

  [[nodiscard]] std::string name() const { return near->name + " to " + far->name; }
  // m/s; negative where the farther one is triggered first
  [[nodiscard]] double speed() const { return (far->distance - near->distance) / (far->trigger - near->trigger); }
};

std::vector<Pair> pairs(std::span<const Sensor> sensors, bool same_group) {
  std::vector<Pair> all;
  for (const Sensor& a : sensors)
    for (const Sensor& b : sensors)
      if (a.distance < b.distance && (a.group == b.group) == same_group) all.push_back({&a, &b});
  return all;
}

std::vector<double> speeds(const std::vector<Pair>& of) {
  std::vector<double> all;
  for (const Pair& pair : of) all.push_back(pair.speed());
  return all;
}

Statement field_is_earlier(std::span<const Sensor> sensors) {
  std::vector<Reading> readings;
  for (const Pair& pair : pairs(sensors, false))
    for (const double density : densities)
      readings.push_back({fmt::format("{}, {:g} kg/m3", pair.name(), density), pair.speed() > speed_by_eq_11(density),
                          fmt::format("{:.0f} m/s against {:.0f}", pair.speed(), speed_by_eq_11(density))});
  return judged_over(
      {5, "5-field-earlier", "Arrivals in the field are earlier than by theory", std::string("much earlier"), "", "",
       std::nullopt,
       "The origin time is not given, so speeds between the two groups of sensors are compared: distances "
       "and trigger times of Table 5.1 against Eq. 11 with the densities of marble."},
      readings);
}

Statement one_speed_explains(std::span<const Sensor> sensors) {
  std::vector<Reading> readings;
  for (const Pair& pair : pairs(sensors, true))
    readings.push_back(
        {pair.name(), pair.speed() > 0,
         fmt::format("{} speed: the farther one is triggered {:.0f} us {}", pair.speed() > 0 ? "a" : "no",
                     1e6 * std::abs(pair.far->trigger - pair.near->trigger), pair.speed() > 0 ? "later" : "earlier")});
  const std::vector<double> found = speeds(pairs(sensors, false));
  const double least = std::ranges::min(found);
  const double most = std::ranges::max(found);
  const auto modulus = [](double speed, double density) { return density * speed * speed / plane_strain / 1e9; };
  return judged_over(
      {5, "5-material-explains", "The difference between field and theory is one of material properties",
       std::string("stiffer rock"), "", "", std::nullopt,
       fmt::format(
           "Were it so, some speed would explain all four trigger times; then the farther sensor of a group is "
           "triggered later. Between groups the speeds are {:.0f} to {:.0f} m/s, which by Eq. 11 with {:g} kg/m3 "
           "means {:.0f} to {:.0f} GPa in place of {:g}: distances or trigger times hold errors that no stiffness "
           "removes.",
           least, most, densities[1], modulus(least, densities[1]), modulus(most, densities[1]), young / 1e9)},
      readings);
}

}  // namespace

double speed_by_eq_11(double density) { return std::sqrt(young * plane_strain / density); }

std::span<const Sensor> jinping_sensors() {
  static const std::vector<Sensor> sensors{
      {"S1-2", 1, 108, 0.287857}, {"S1-4", 1, 107, 0.288190}, {"S2-1", 2, 81, 0.283023}, {"S2-4", 2, 77, 0.283858}};
  return sensors;
}

Chapter chapter_5(std::span<const Sensor> sensors) {
  Chapter chapter;
  chapter.number = 5;
  chapter.title = "Chapter 5: Jinping";
  chapter.statements = {field_is_earlier(sensors), one_speed_explains(sensors)};
  chapter.assumptions = {"density of marble: 2500, 2700 and 2900 kg/m3, as the text gives none",
                         "speeds between sensors of different groups, as the origin time is not given"};
  return chapter;
}

}  // namespace verify
