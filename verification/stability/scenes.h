// The problems of the chart as scenes of the public format, and the numbers that their answers need.
#pragma once

#include <nlohmann/json.hpp>

#include "verification/stability/setting.h"

namespace verify {

inline constexpr double rock_density = 2600;  // kg/m3, of heavy blocks
inline constexpr double rock_young = 20e9;    // Pa
inline constexpr double weight_pull = 9.81;   // m/s2

// A push on the left end of six columns of two blocks, 1 m wide.
inline constexpr int pulse_columns = 6;
inline constexpr int pulse_rows = 2;
inline constexpr double pulse_peak = 1e6;   // Pa
inline constexpr double pulse_rise = 1e-3;  // s, as long as its fall

inline constexpr double incline_angle = 30;     // degrees; the plane is level and gravity turned
inline constexpr double incline_friction = 15;  // degrees

inline constexpr int wall_rows = 4;      // of three bricks, half of the rows light
inline constexpr double wall_width = 3;  // m

inline constexpr double pile_gap = 0.01;  // m, under the pile at first
inline constexpr double pile_box = 1.6;   // m, half of the box's width over that of the pile

[[nodiscard]] double row_height(const Setting& setting);  // m, of blocks in the pulse and the wall
struct Extent {
  double width = 1, height = 1;  // m
};
[[nodiscard]] Extent slider_extent(
    const Setting& setting);  // each of the two blocks on the incline, 1 m2; they do not topple
[[nodiscard]] Extent pile_scale(const Setting& setting);  // of pieces of a circle of 1 m

[[nodiscard]] nlohmann::ordered_json scene_of(const Setting& setting);

}  // namespace verify
