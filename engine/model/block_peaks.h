// The strongest motion of every block in a stage, and what follows from it: blocks that are ejected, and how peak
// velocities fade with the distance from a source.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "engine/model/model.h"

namespace dda {

// What one block did over the stage; speeds are those of its centroid.
struct BlockPeaks {
  Vec2 place = Vec2::Zero();  // m, of the centroid when the stage began
  double speed = 0;           // m/s, the largest
  double speed_time = 0;      // s
  double acceleration = 0;    // m/s2, the largest
  double acceleration_time = 0;
  double kinetic = 0;  // J per m of thickness, with spin and strain rates, at the last moment
  double moved = 0;    // m, relative to the rest, at the last moment
  double thrown = 0;   // m/s, the largest speed relative to the rest until it has gone the distance of ejection
  double gone_at = std::numeric_limits<double>::infinity();     // s, when it had gone that distance
  double ejected_at = std::numeric_limits<double>::infinity();  // s, when it had gone so far or was so fast
  bool takes_part = true;                                       // false: held as a whole, or removed before the stage

  [[nodiscard]] bool is_ejected() const { return ejected_at < std::numeric_limits<double>::infinity(); }

  template <typename Self, typename Archive>
  static void visit(Self& self, Archive& archive) {
    auto& [place, speed, speed_time, acceleration, acceleration_time, kinetic, moved, thrown, gone_at, ejected_at,
           takes_part] = self;
    archive(place, speed, speed_time, acceleration, acceleration_time, kinetic, moved, thrown, gone_at, ejected_at,
            takes_part);
  }
};

// Blocks by their mass and energy, per m of thickness.
struct ThrownBlocks {
  double from = 0, to = 0;  // m/s, ejection velocities from here to below there; of the last class up to there
  std::size_t blocks = 0;
  double mass = 0;     // kg
  double kinetic = 0;  // J, of translation at the ejection velocity: m v^2/2
};

struct Ejection {
  ThrownBlocks all;                   // from the least to the largest ejection velocity; 0 to 0 where there are none
  double kinetic_at_end = 0;          // J per m of thickness, what these blocks have at the last moment
  double mean_velocity = 0;           // m/s, of equal kinetic energy: sqrt(2 kinetic/mass)
  std::vector<ThrownBlocks> classes;  // of equal width, a round number, from 0 on
};

// `peaks`: of every block of the model.
Ejection ejection_of(const Model& model, std::span<const BlockPeaks> peaks);

// v = K (R/sqrt(W))^-n, by least squares of ln v over ln(R/sqrt(W)).
struct ScaledDistanceLaw {
  double k = 0;            // m/s, at the scaled distance of 1
  double exponent = 0;     // n
  double correlation = 0;  // of the logarithms: -1 where v falls exactly by the law; NaN where v is the same everywhere
  std::size_t points = 0;
};

struct SpeedAtDistance {
  double scaled_distance = 0;  // R/sqrt(W), m/sqrt(kg/m)
  double speed = 0;            // m/s
};

// None where there are not two different distances. All numbers must be positive.
std::optional<ScaledDistanceLaw> fit_scaled_distance(std::span<const SpeedAtDistance> points);

double scaled_distance(const AttenuationRequest& attenuation, const Vec2& place);

// Whether a block counts for the fit: it takes part, moves, is not ejected, and lies in the asked range of distances.
bool counts_for_fit(const AttenuationRequest& attenuation, const BlockPeaks& peaks);

std::optional<ScaledDistanceLaw> attenuation_of(const AttenuationRequest& attenuation,
                                                std::span<const BlockPeaks> peaks);

}  // namespace dda
