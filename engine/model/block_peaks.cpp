#include "engine/model/block_peaks.h"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

constexpr double classes_wanted = 10;

// 1, 2 or 5 times a power of ten, the first that is not below `width`.
double round_up(double width) {
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= width) return digit * power;
  return 10 * power;
}

void add(double mass, double velocity, ThrownBlocks& sum) {
  ++sum.blocks;
  sum.mass += mass;
  sum.kinetic += mass * velocity * velocity / 2;
}

std::vector<ThrownBlocks> empty_classes(double fastest) {
  if (!(fastest > 0)) return {};
  const double width = round_up(fastest / classes_wanted);
  std::vector<ThrownBlocks> classes(static_cast<std::size_t>(std::ceil(fastest / width)));
  for (std::size_t i = 0; i < classes.size(); ++i) {
    classes[i].from = static_cast<double>(i) * width;
    classes[i].to = static_cast<double>(i + 1) * width;
  }
  return classes;
}

// The limits as they are written decide, not what rounding makes of a quotient.
ThrownBlocks& class_of(double velocity, std::vector<ThrownBlocks>& classes) {
  const auto above = [velocity](const ThrownBlocks& each) { return velocity < each.to; };
  const auto found = std::ranges::find_if(classes, above);
  return found == classes.end() ? classes.back() : *found;
}

}  // namespace

Ejection ejection_of(const Model& model, std::span<const BlockPeaks> peaks) {
  Ejection ejection;
  ThrownBlocks& all = ejection.all;
  all.from = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    if (!peaks[i].is_ejected()) continue;
    add(model.mass_of(static_cast<int>(i)), peaks[i].thrown, all);
    all.from = std::min(all.from, peaks[i].thrown);
    all.to = std::max(all.to, peaks[i].thrown);
    ejection.kinetic_at_end += peaks[i].kinetic;
  }
  if (all.blocks == 0) return {};
  ejection.mean_velocity = std::sqrt(2 * all.kinetic / all.mass);
  ejection.classes = empty_classes(all.to);
  for (std::size_t i = 0; i < peaks.size() && !ejection.classes.empty(); ++i)
    if (peaks[i].is_ejected())
      add(model.mass_of(static_cast<int>(i)), peaks[i].thrown, class_of(peaks[i].thrown, ejection.classes));
  return ejection;
}

std::optional<ScaledDistanceLaw> fit_scaled_distance(std::span<const SpeedAtDistance> points) {
  const auto count = static_cast<double>(points.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const SpeedAtDistance& point : points) {
    mean_x += std::log(point.scaled_distance) / count;
    mean_y += std::log(point.speed) / count;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (const SpeedAtDistance& point : points) {
    const double x = std::log(point.scaled_distance) - mean_x;
    const double y = std::log(point.speed) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  constexpr double round_off = 1e-24;  // of logarithms, squared: distances that differ by less are one
  if (!(xx > round_off * count)) return std::nullopt;
  return ScaledDistanceLaw{std::exp(mean_y - xy / xx * mean_x), -xy / xx, xy / std::sqrt(xx * yy), points.size()};
}

double scaled_distance(const AttenuationRequest& attenuation, const Vec2& place) {
  return (place - attenuation.source).norm() / std::sqrt(attenuation.charge);
}

bool counts_for_fit(const AttenuationRequest& attenuation, const BlockPeaks& peaks) {
  const double distance = (peaks.place - attenuation.source).norm();
  return peaks.takes_part && !peaks.is_ejected() && peaks.speed > 0 && distance > 0 &&
         distance >= attenuation.nearest && distance <= attenuation.farthest;
}

std::optional<ScaledDistanceLaw> attenuation_of(const AttenuationRequest& attenuation,
                                                std::span<const BlockPeaks> peaks) {
  std::vector<SpeedAtDistance> points;
  for (const BlockPeaks& block : peaks)
    if (counts_for_fit(attenuation, block)) points.push_back({scaled_distance(attenuation, block.place), block.speed});
  return fit_scaled_distance(points);
}

}  // namespace dda
