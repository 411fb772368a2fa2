// Random stressed rock with an opening between held walls, which populations of excavation share.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <random>
#include <string>

namespace dda {

// Draws rock by lot: the same for the same seed on every machine, as distributions of the standard library are not.
class RockByLot {
 public:
  explicit RockByLot(int seed) : random_(static_cast<unsigned>(seed)) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
  }

  // A joint set whose dip lies between these, degrees.
  nlohmann::json joint_set(double low, double high) {
    return {{"dip", {{"mean", fmt::format("{:.3f} deg", between(low, high))}, {"deviation", "4 deg"}}},
            {"spacing", {{"mean", between(0.9, 1.4)}, {"deviation", 0.2}}},
            {"joint", "default"}};
  }

 private:
  std::mt19937_64 random_;
};

inline nlohmann::json held_wall(const std::string& name, double left, double bottom, double right, double top) {
  return {{"polygon",
           {{"name", name},
            {"group", "walls"},
            {"vertices", {{left, bottom}, {right, bottom}, {right, top}, {left, top}}}}}};
}

// What joints are and how blocks move.
struct RockKind {
  const char* name;
  nlohmann::json joint;
  const char* kinematics;
};

// NOLINTNEXTLINE(readability-identifier-naming): gtest's
inline void PrintTo(const RockKind& kind, std::ostream* out) { *out << kind.name; }

// A dynamic stage of so many steps.
inline nlohmann::json motion_of(const RockKind& kind, const char* name, int steps) {
  return {{"name", name},
          {"integrator", {{"generalized_alpha", 0.5}}},
          {"dt", 1e-4},
          {"duration", steps * 1e-4},
          {"kinematics", kind.kinematics},
          {"solver", "cholesky"}};
}

// 6 m by 6 m in two joint sets around a circle, the group "opening".
inline nlohmann::json rock_with_opening(int seed, bool left_out) {
  RockByLot lot(seed);
  const nlohmann::json opening = {
      {"name", "opening"},
      {"left_out", left_out},
      {"circle", {{"centre", {lot.between(2.6, 3.4), lot.between(2.6, 3.4)}}, {"radius", lot.between(0.8, 1.3)}}}};
  return {{"boundary", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}},
          {"joint_sets", {lot.joint_set(20, 80), lot.joint_set(-60, 10)}},
          {"openings", {opening}},
          {"seed", seed},
          {"merge", {{"area", 0.02}, {"angle", "8 deg"}}}};
}

inline const nlohmann::json uniform_field = {{"xx", "-3 MPa"}, {"yy", "-4 MPa"}, {"xy", "0.2 MPa"}};

// That rock under that stress between held walls, without gravity.
inline nlohmann::json scene_with_opening(int seed, const RockKind& kind, bool left_out, const nlohmann::json& steps) {
  return {{"dda", 1},
          {"materials", {{"rock", {{"density", 2600}, {"young", 20e9}, {"poisson", 0.2}}}}},
          {"joints", {{"default", kind.joint}}},
          {"blocks",
           {{{"rock", rock_with_opening(seed, left_out)}},
            held_wall("wall -1 -1", -1, -1, 7, 0),
            held_wall("wall -1 6", -1, 6, 7, 7),
            held_wall("wall -1 0", -1, 0, 0, 6),
            held_wall("wall 6 0", 6, 0, 7, 6)}},
          {"stress_field", uniform_field},
          {"fixed", nlohmann::json::array({"walls"})},
          {"steps", steps}};
}

}  // namespace dda
