#include "engine/view/colour_map.h"

#include <fmt/format.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace dda {
namespace {

// Linear sRGB to cone responses, and the cube roots of those to OKLab.
const Mat3 to_cones = (Mat3() << 0.4122214708, 0.5363325363, 0.0514459929, 0.2119034982, 0.6806995451, 0.1073969566,
                       0.0883024619, 0.2817188376, 0.6299787005)
                          .finished();
const Mat3 to_lab = (Mat3() << 0.2104542553, 0.7936177850, -0.0040720468, 1.9779984951, -2.4285922050, 0.4505937099,
                     0.0259040371, 0.7827717662, -0.8086757660)
                        .finished();

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t encoded(double linear) {
  const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(c, 0.0, 1.0)));
}

Rgb colour_of(const Vec3& lab) {
  static const Mat3 from_lab = to_lab.inverse();
  static const Mat3 from_cones = to_cones.inverse();
  const Vec3 roots = from_lab * lab;
  const Vec3 rgb = from_cones * roots.cwiseProduct(roots).cwiseProduct(roots);
  return {encoded(rgb(0)), encoded(rgb(1)), encoded(rgb(2))};
}

// The polyline through some colours in OKLab, by its length from the first.
class Path {
 public:
  explicit Path(std::span<const Rgb> colours) {
    for (const Rgb& colour : colours) {
      const Vec3 lab = oklab(colour);
      lengths_.push_back(points_.empty() ? 0 : lengths_.back() + (lab - points_.back()).norm());
      points_.push_back(lab);
    }
  }

  [[nodiscard]] double length() const { return lengths_.back(); }

  [[nodiscard]] Vec3 at(double length) const {
    std::size_t i = 1;
    while (i + 1 < points_.size() && lengths_[i] < length) ++i;
    const double share = (length - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
    return points_[i - 1] + std::clamp(share, 0.0, 1.0) * (points_[i] - points_[i - 1]);
  }

 private:
  std::vector<Vec3> points_;
  std::vector<double> lengths_;
};

ColourMap along(const Path& path) {
  ColourMap map;
  for (std::size_t i = 0; i < map.size(); ++i)
    map[i] = colour_of(path.at(path.length() * static_cast<double>(i) / 255));
  return map;
}

ColourMap made_sequential() {
  constexpr std::array<Rgb, 6> colours = {
      {{255, 246, 205}, {196, 226, 160}, {96, 190, 160}, {38, 142, 176}, {48, 86, 164}, {48, 28, 104}}};
  return along(Path(colours));
}

ColourMap made_utilisation() {
  constexpr std::array<Rgb, 3> colours = {{{0, 122, 61}, {150, 186, 20}, {240, 138, 0}}};
  return along(Path(colours));
}

// Both arms are as long as the shorter of them, so that a step is the same on either side.
ColourMap made_diverging() {
  constexpr std::array<Rgb, 4> cold = {{{245, 242, 236}, {150, 190, 222}, {58, 120, 184}, {24, 48, 110}}};
  constexpr std::array<Rgb, 4> warm = {{{245, 242, 236}, {232, 172, 140}, {196, 80, 64}, {106, 16, 40}}};
  const Path to_cold(cold);
  const Path to_warm(warm);
  const double arm = std::min(to_cold.length(), to_warm.length());
  ColourMap map;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const double place = 2 * static_cast<double>(i) / 255 - 1;
    map[i] = colour_of(place < 0 ? to_cold.at(-place * arm) : to_warm.at(place * arm));
  }
  return map;
}

}  // namespace

std::string to_hex(const Rgb& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

Vec3 oklab(const Rgb& colour) {
  const Vec3 cones = to_cones * Vec3(linear(colour.red), linear(colour.green), linear(colour.blue));
  return to_lab * Vec3(std::cbrt(cones(0)), std::cbrt(cones(1)), std::cbrt(cones(2)));
}

const ColourMap& sequential_map() {
  static const ColourMap map = made_sequential();
  return map;
}

const ColourMap& diverging_map() {
  static const ColourMap map = made_diverging();
  return map;
}

const ColourMap& utilisation_map() {
  static const ColourMap map = made_utilisation();
  return map;
}

}  // namespace dda
