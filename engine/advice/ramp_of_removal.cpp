#include "engine/advice/ramp_of_removal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "engine/core/disjoint_sets.h"
#include "engine/model/rock_change.h"

namespace dda {
namespace {

constexpr int terms = 14;

double factorial(int n) { return std::tgamma(n + 1.0); }

// Stehfest's weights, Communications of the ACM 13, 47.
std::array<double, terms> stehfest_weights() {
  std::array<double, terms> weights{};
  constexpr int half = terms / 2;
  for (int k = 1; k <= terms; ++k) {
    double sum = 0;
    for (int j = (k + 1) / 2; j <= std::min(k, half); ++j)
      sum += std::pow(j, half) * factorial(2 * j) /
             (factorial(half - j) * factorial(j) * factorial(j - 1) * factorial(k - j) * factorial(2 * j - k));
    weights[static_cast<std::size_t>(k - 1)] = (k + half) % 2 == 0 ? sum : -sum;
  }
  return weights;
}

// K0/K1, by its limits where both functions are near the smallest numbers there are, and where K1 is so large that the
// library's own series take for ever. To 1e-9.
double bessel_ratio(double z) {
  constexpr double near = 1e-5, far = 300;
  if (z < near) return -z * (std::log(z / 2) + std::numbers::egamma);
  return z > far ? 1 - 1 / (2 * z) : std::cyl_bessel_k(0, z) / std::cyl_bessel_k(1, z);
}

double ratio_at(double modulus_ratio, double z) { return modulus_ratio * z * bessel_ratio(z); }

// The inverse of a Laplace transform at `time`.
template <typename Transform>
double inverse(const Transform& transform, double time) {
  if (time <= 0) return 0;
  static const std::array<double, terms> weights = stehfest_weights();
  const double rate = std::numbers::ln2 / time;
  double sum = 0;
  for (int k = 1; k <= terms; ++k) sum += weights[static_cast<std::size_t>(k - 1)] * transform(k * rate);
  return rate * sum;
}

// The wall's displacement after a sudden removal, over what it settles to, at t c_p/a.
double after_sudden(double modulus_ratio, double time) {
  return inverse([=](double z) { return 1 / (z * (1 + ratio_at(modulus_ratio, z))); }, time);
}

// The integral over time of the same less 1, which stays near 1 however long it goes on.
double beyond_rest(double modulus_ratio, double time) {
  const auto transform = [=](double z) {
    const double ratio = ratio_at(modulus_ratio, z);
    return -ratio / (z * z * (1 + ratio));
  };
  return inverse(transform, time);
}

// The mean of what a sudden removal does over the last `ramp` before `time`. Differences of integrals lose digits where
// the ramp is short; there it is summed up by Simpson's rule.
double after_ramp(double modulus_ratio, double ramp, double time) {
  constexpr double short_ramp = 2;
  if (ramp >= short_ramp)
    return 1 + (beyond_rest(modulus_ratio, time) - beyond_rest(modulus_ratio, time - ramp)) / ramp;
  constexpr int parts = 4;
  double sum = 0;
  for (int i = 0; i <= parts; ++i) {
    const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * after_sudden(modulus_ratio, time - ramp * i / parts);
  }
  return sum / (3 * parts);
}

// The first block that stays beside the opening is of its rock.
int material_beside(const Model& model, const ContactSet& contacts, const std::vector<char>& removed) {
  for (const Interface& each : contacts.interfaces) {
    const bool a = removed[static_cast<std::size_t>(each.block_a)] != 0;
    const bool b = removed[static_cast<std::size_t>(each.block_b)] != 0;
    if (a != b) return model.blocks[static_cast<std::size_t>(a ? each.block_b : each.block_a)].material;
  }
  return 0;
}

// Removed blocks that touch are one opening. Its area, m2, of the largest.
double largest_opening(const Model& model, const ContactSet& contacts, const std::vector<char>& removed) {
  DisjointSets openings(model.blocks.size());
  for (const Interface& each : contacts.interfaces) {
    const auto a = static_cast<std::size_t>(each.block_a), b = static_cast<std::size_t>(each.block_b);
    if (removed[a] != 0 && removed[b] != 0) openings.join(each.block_a, each.block_b);
  }
  std::vector<double> area(model.blocks.size(), 0);
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (removed[i] != 0)
      area[static_cast<std::size_t>(openings.root(static_cast<int>(i)))] += model.blocks[i].moments.area;
  return *std::ranges::max_element(area);
}

// s, over which a straight line takes what the blocks exerted to nothing; none where it takes another course.
std::optional<double> straight_ramp(const Stage& stage) {
  if (!stage.removal.relaxation) return 0;
  const auto* table = std::get_if<PiecewiseLinear>(&*stage.removal.relaxation);
  const bool is_straight = table != nullptr && table->times.size() == 2 && table->values.back() == 0;
  return is_straight ? std::optional(table->times.back()) : std::nullopt;
}

}  // namespace

double wall_overshoot(double modulus_ratio, double ramp) {
  constexpr double swing = 10;  // within which after the end of the ramp the wall has come farthest
  constexpr int looks = 50;
  double most = 0;
  for (int i = 1; i <= looks; ++i) most = std::max(most, after_ramp(modulus_ratio, ramp, ramp + swing * i / looks) - 1);
  return most;
}

double least_ramp(double modulus_ratio, double overshoot) {
  if (wall_overshoot(modulus_ratio, 0) <= overshoot) return 0;
  double low = 0.01, high = 0.1;  // the shorter one is as good as none
  constexpr double longest = 1e5;
  while (wall_overshoot(modulus_ratio, high) > overshoot && high < longest) {
    low = high;
    high *= 2;
  }
  constexpr double precision = 1.01;
  while (high > precision * low) {
    const double middle = std::sqrt(low * high);
    (wall_overshoot(modulus_ratio, middle) > overshoot ? low : high) = middle;
  }
  return high;
}

std::string ramp_of_removal(const Model& model, const ContactSet& contacts, std::size_t stage_index) {
  const Stage& stage = model.stages[stage_index];
  const std::optional<double> ramp = straight_ramp(stage);
  if (stage.removal.blocks.empty() || stage.integrator.is_static || !ramp) return "";
  std::vector<char> removed(model.blocks.size(), 0);
  for (const int block : stage.removal.blocks) removed[static_cast<std::size_t>(block)] = 1;
  const auto beside = static_cast<std::size_t>(material_beside(model, contacts, removed));
  const Material& rock = materials_in(model, stage_index)[beside];
  const Mat3 elasticity = elasticity_matrix(rock);
  const double modulus_ratio = elasticity(0, 0) / (2 * elasticity(2, 2));
  const double radius = std::sqrt(largest_opening(model, contacts, removed) / std::numbers::pi);
  const double unit = radius / p_wave_speed(rock);
  return fmt::format(
      "a round opening of that area in rock without joints overshoots by {:.2g} %; \"over\" {:.2g} s leaves 5 %, "
      "{:.2g} s 1 %",
      100 * wall_overshoot(modulus_ratio, *ramp / unit), unit * least_ramp(modulus_ratio, 0.05),
      unit * least_ramp(modulus_ratio, 0.01));
}

}  // namespace dda
