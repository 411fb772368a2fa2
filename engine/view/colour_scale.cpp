#include "engine/view/colour_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dda {
namespace {

constexpr double outermost = 0.02;   // share of the values at either end
constexpr double far_beyond = 2;     // times the range of the rest
constexpr double near_zero = 0.5;    // of the far end: a range that begins nearer to zero begins there
constexpr double other_sign = 0.05;  // of the far end: less of the other sign does not make a map diverge
constexpr Rgb no_value = {150, 150, 150};

struct Extent {
  double least = 0, most = 0;
  double low = 0, high = 0;  // without outliers
};

Extent extent_of(std::vector<double>& values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  const auto [least, most] = std::ranges::minmax(values);
  const auto skipped = static_cast<std::ptrdiff_t>(outermost * static_cast<double>(values.size()));
  std::ranges::nth_element(values, values.begin() + skipped);
  const double low = values[static_cast<std::size_t>(skipped)];
  std::ranges::nth_element(values, values.end() - 1 - skipped);
  const double high = values[values.size() - 1 - static_cast<std::size_t>(skipped)];
  if (high > low && most - least > far_beyond * (high - low)) return {least, most, low, high};
  return {least, most, least, most};
}

}  // namespace

Rgb ColourScale::colour_at(double share) const {
  const double place = diverging || !dark_low ? share : 1 - share;
  const auto index = static_cast<std::size_t>(std::lround(255 * std::clamp(place, 0.0, 1.0)));
  return (diverging ? diverging_map() : sequential_map())[index];
}

Rgb ColourScale::colour(double value) const {
  return std::isfinite(value) ? colour_at((value - low) / (high - low)) : no_value;
}

ColourScale scale_of(std::vector<double> values) {
  auto [least, most, low, high] = extent_of(values);
  const double far = std::max(std::abs(low), std::abs(high));
  if (far == 0) return {0, 1, false, false, least, most};
  const double near = std::min(std::abs(low), std::abs(high));
  if (low < 0 && high > 0 && near > other_sign * far) return {-far, far, true, false, least, most};
  const bool negative = -low > high;
  if (low * high < 0 || near < near_zero * far) (negative ? high : low) = 0;
  if (high - low < 1e-9 * far) (negative ? low : high) *= 1.01;
  return {low, high, false, negative, least, most};
}

ScaledUnit scaled_unit(std::string_view unit, double magnitude) {
  constexpr std::array<std::pair<double, std::string_view>, 7> prefixes = {
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "\u00b5"}, {1e-9, "n"}}};
  const double largest = unit.starts_with('m') || unit == "s" ? 1 : 1e9;  // no Mm, no km/s, no ks
  for (const auto& [factor, prefix] : prefixes)
    if (factor <= largest && std::abs(magnitude) >= factor) return {factor, fmt::format("{}{}", prefix, unit)};
  return {1, std::string(unit)};
}

std::vector<double> ticks(double low, double high, int most) {
  const double rough = (high - low) / most;
  if (!(rough > 0) || !std::isfinite(rough)) return {low};
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0})
    if (digit * power >= rough * (1 - 1e-9)) step = digit * power;
  std::vector<double> found;
  for (double i = std::ceil(low / step - 1e-6); i * step <= high + 1e-6 * step; ++i) found.push_back(i * step + 0.0);
  return found;
}

std::string label(double value, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 0, 9);
  const std::string number = fmt::format("{:.{}f}", std::abs(value), digits);
  const bool zero = number.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "\u2212" : "") + number;
}

}  // namespace dda
