// Random bonded rock with all that a scene in which waves run can have, as scenes: for populations of what the engine
// chooses by itself. The same rock in finer blocks is the reference of what blocks of that size do.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/geometry/cut_pieces.h"

namespace dda {

// Blocks are about 1 m wide, `columns` by `rows` of them; (0, 0) is the lower left corner.
class BondedRockByLot {
 public:
  using Json = nlohmann::json;

  enum class Cut { stack, running_bond, triangles, halved_squares, parallelograms, voronoi, around_opening };

  explicit BondedRockByLot(std::uint64_t seed) : random_(seed) {
    constexpr std::array names = {"stack",          "running bond", "triangles",     "halved squares",
                                  "parallelograms", "voronoi",      "around opening"};
    const int cut = random_.integer(0, static_cast<int>(names.size()) - 1);
    cut_ = static_cast<Cut>(cut);
    traits_ = fmt::format("{},", names[static_cast<std::size_t>(cut)]);
    width_ = random_.integer(40, 52);
    height_ = random_.integer(30, 38);
    aspect_ = random_.chance(0.5) ? 1 : random_.number(0.7, 1.4);
    dip_ = random_.number(-25, 25), turn_ = random_.number(55, 125);
    spread_ = random_.chance(0.5) ? random_.number(0.05, 0.25) : 0;
    regular_ = random_.integer(0, 12);
    seed_ = random_.integer(1, 1000);
    opening_ = {random_.number(0.35, 0.65) * width_, random_.number(0.4, 0.6) * height_};
    radius_ = random_.number(2, 3.5);
    scene_ = {{"dda", 1}, {"plane", random_.chance(0.5) ? "strain" : "stress"}};
    scene_["joints"]["default"]["bonded"] = true;
    add_materials();
    add_history();
    add_loads();
    add_sides();
    add_start();
    add_measurements();
    add_stages();
  }

  [[nodiscard]] const std::string& traits() const { return traits_; }

  // Cuts the rock into blocks of a `parts`-th of the width.
  [[nodiscard]] Json scene(int parts) const {
    Json scene = scene_;
    scene["blocks"] = blocks(parts);
    return scene;
  }

 private:
  // Remembers in words what is drawn by lot.
  bool chance(double share, const char* trait) {
    if (!random_.chance(share)) return false;
    traits_ += fmt::format(" {},", trait);
    return true;
  }

  [[nodiscard]] double shear_speed() const { return std::sqrt(young_ / (2 * (1 + poisson_)) / density_); }
  [[nodiscard]] double transit() const { return width_ / shear_speed(); }

  void add_materials() {
    density_ = random_.number(2000, 3000), young_ = random_.magnitude(9.7, 10.9), poisson_ = random_.number(0.05, 0.35);
    scene_["materials"]["rock"] = {{"density", density_}, {"young", young_}, {"poisson", poisson_}};
    layers_ = chance(0.3, "layers") ? random_.integer(2, 4) : 1;
    if (layers_ == 1) return;
    scene_["materials"]["other"] = {{"density", density_ * random_.number(0.8, 1.2)},
                                    {"young", young_ * random_.magnitude(-0.7, 0.3)},
                                    {"poisson", random_.number(0.1, 0.35)}};
  }

  // Chooses a load whose S waves are 9 to 25 blocks long.
  void add_history() {
    frequency_ = shear_speed() / random_.number(9, 25);
    switch (random_.integer(0, 4)) {
      case 0: history_ = {{"sine", {{"frequency", frequency_}, {"cycles", random_.integer(1, 3)}}}}; break;
      case 1:
        history_ = {{"triangle", {{"rise", 0.4 / frequency_}, {"fall", random_.number(0.4, 1) / frequency_}}}};
        break;
      case 2: history_ = {{"decay", {{"decay_time", 0.6 / frequency_}, {"rise", 0.3 / frequency_}}}}; break;
      case 3: history_ = smooth_pulse(); break;
      default: history_ = {{"table", {{0, 0}, {1 / frequency_, 1}, {3 / frequency_, 0.3}}}};
    }
    traits_ += fmt::format(" {},", history_.begin().key());
  }

  [[nodiscard]] Json smooth_pulse() const {
    Json table = Json::array();
    constexpr int rows = 40;
    for (int i = 0; i <= rows; ++i)
      table.push_back({i / (rows * frequency_), std::pow(std::sin(3.14159265358979 * i / rows), 2)});
    return {{"table", table}};
  }

  [[nodiscard]] Json vector(double size) { return {size * random_.number(-1, 1), size * random_.number(-1, 1)}; }

  void add_loads() {
    const bool has_cavity = cut_ == Cut::around_opening;
    removes_ = has_cavity && chance(0.4, "removal");
    if (removes_) return;
    if (has_cavity && chance(0.7, "blast")) {
      scene_["loads"].push_back(
          {{"edge", {{"cavity", {opening_.x(), opening_.y()}}}}, {"pressure", 1e6}, {"history", history_}});
      return;
    }
    if (chance(0.25, "point load")) {
      scene_["loads"].push_back(
          {{"point", {0.3137 * width_, 0.6713 * height_}}, {"force", vector(1e6)}, {"history", history_}});
      return;
    }
    if (chance(0.15, "initial velocities")) return add_initial_velocities();
    if (chance(0.25, "driven edge")) {
      drives_ = true;
      return;
    }
    scene_["loads"].push_back(
        {{"edge", random_.chance(0.5) ? side(0) : Json("top")}, {"traction", vector(1e6)}, {"history", history_}});
  }

  // A vertical side of the rock, at `x` (m); the side of its base is no part of it.
  [[nodiscard]] Json side(double x) const { return {{"from", {x, 0}}, {"to", {x, height_}}}; }

  // Sets the middle of the rock in motion by a hump of velocities whose width goes by the S wave of `frequency_`.
  void add_initial_velocities() {
    Json x = Json::array(), y = Json::array(), rows_x = Json::array(), rows_y = Json::array();
    const double wide = 0.3 * shear_speed() / frequency_;
    constexpr int points = 60;
    for (int i = 0; i <= points; ++i) x.push_back(-5 + (width_ + 10) * i / points);
    for (int i = 0; i <= points; ++i) y.push_back(-5 + (height_ + 10) * i / points);
    const Json way = vector(0.1);
    for (const double b : y) {
      std::vector<double> row;
      for (const double a : x)
        row.push_back(std::exp(-(std::pow(a - width_ / 2, 2) + std::pow(b - height_ / 2, 2)) / (2 * wide * wide)));
      rows_x.push_back(scaled(row, way[0])), rows_y.push_back(scaled(row, way[1]));
    }
    scene_["initial_fields"] = {{{"x", x}, {"y", y}, {"velocity_x", rows_x}, {"velocity_y", rows_y}}};
  }

  static Json scaled(std::vector<double> row, double factor) {
    for (double& value : row) value *= factor;
    return row;
  }

  void add_sides() {
    if (drives_) {
      Json drive = {{"edge", "bottom"}, {"displacement", vector(1e-4)}, {"history", history_}};
      if (chance(0.85, "soft")) drive["stiffness"] = soft();
      scene_["supports"].push_back(drive);
    } else if (removes_ || chance(0.35, "supported")) {
      Json support = {{"edge", "bottom"}, {"hold", random_.chance(0.5) ? "normal" : "xy"}};
      if (chance(0.85, "soft")) support["stiffness"] = soft();
      scene_["supports"].push_back(support);
    } else if (!scene_.contains("initial_fields") && chance(0.3, "fixed base")) {
      based_ = true;
      scene_["fixed"] = {"base"};
    }
    if (chance(0.5, "viscous")) scene_["viscous_boundaries"].push_back({{"edge", side(width_)}});
    if (based_ && !scene_.contains("loads") && chance(0.5, "free field"))
      scene_["viscous_boundaries"].push_back({{"edge", side(0)}, {"free_field", true}});
  }
  double soft() { return young_ * random_.number(0.3, 10); }

  void add_start() {
    const bool held = drives_ || based_ || scene_.contains("supports");
    weighs_ = held && chance(removes_ ? 0 : 0.2, "gravity");
    if (weighs_) scene_["gravity"] = 9.81;
    if (removes_) scene_["stress_field"] = {{"xx", -random_.number(1e6, 5e6)}, {"yy", -random_.number(1e6, 5e6)}};
    if (removes_) scene_["loads"].push_back({{"edge", "outside"}, {"traction", "in-situ"}});
    if (removes_ && scene_.contains("supports")) scene_.erase("supports");
    const bool begins_in_motion = scene_.contains("initial_fields");  // which settling would end
    settles_ = removes_ || (held && !begins_in_motion && chance(weighs_ ? 0.7 : 0.1, "settles"));
  }

  void add_measurements() {
    for (const double a : {0.1931, 0.3877, 0.6113, 0.8379})
      for (const double b : {0.1873, 0.4127, 0.6481, 0.8693}) {
        const Vec2 at(a * width_, b * height_);
        if (cut_ == Cut::around_opening && (at - opening_).norm() < 1.3 * radius_) continue;
        for (const char* quantity : {"displacement_x", "displacement_y", "velocity_x", "velocity_y"})
          scene_["measurements"].push_back({{"name", fmt::format("{} at {:.3f} {:.3f}", quantity, at.x(), at.y())},
                                            {"quantity", quantity},
                                            {"point", {at.x(), at.y()}}});
      }
  }

  Json motion(const char* name, double share) {
    constexpr double most_steps = 900;
    double duration = share * transit();
    if (given_dt_ > 0) duration = std::min(duration, most_steps * given_dt_);
    Json stage = {{"name", name}, {"integrator", "auto"}, {"duration", duration}, {"kinematics", "small"}};
    if (given_dt_ > 0) stage["dt"] = given_dt_;
    if (damping_ == 1) stage["damping_rate"] = 1 / transit();
    if (damping_ == 2) stage["velocity_factor"] = 0.998;
    if (damping_ == 3) stage["damping"] = {{"ratio", 0.02}, {"frequencies", {frequency_ / 2, frequency_ * 2}}};
    return stage;
  }

  void add_stages() {
    // P waves cross that share of a block in a step; about 0.28 is the limit in squares.
    if (chance(0.5, "dt given")) given_dt_ = random_.magnitude(-1.5, -0.6) / (1.8 * shear_speed());
    if (chance(0.25, "damped")) damping_ = random_.integer(1, 3);
    Json& stages = scene_["steps"];
    if (settles_) stages.push_back({{"name", "settle"}, {"integrator", "static"}, {"kinematics", "small"}});
    stages.push_back(motion("motion", random_.number(1, 2.5)));
    if (removes_) stages.back()["remove"] = removal();
    if (chance(0.2, "two stages")) stages.push_back(motion("later", random_.number(0.7, 2)));
  }

  Json removal() {
    if (chance(0.3, "at once")) return Json::array({"opening"});
    return {{"blocks", Json::array({"opening"})}, {"over", random_.number(0.5, 2) / frequency_}};
  }

  [[nodiscard]] Json set(double dip, double spacing, double spread = 0) const {
    Json set = {{"joint", "default"}, {"dip", fmt::format("{} deg", dip)}, {"spacing", spacing}, {"start", {0, 0}}};
    if (spread > 0) set["spacing"] = {{"mean", spacing}, {"deviation", spread * spacing}};
    return set;
  }

  [[nodiscard]] Json blocks(int parts) const {
    Json all = Json::array();
    if (cut_ == Cut::running_bond) {
      // The rows of one rock are the courses of a layer.
      const int courses = static_cast<int>(height_) / layers_;
      for (int layer = 0; layer < layers_; ++layer) all.push_back(layer_of_bricks(layer, courses, parts));
    } else {
      all.push_back({{"rock", rock(parts)}});
    }
    if (based_)
      all.push_back({{"polygon",
                      {{"name", "base"},
                       {"material", "rock"},
                       {"vertices", {{-2, -2}, {width_ + 2, -2}, {width_ + 2, 0}, {-2, 0}}}}}});
    return all;
  }

  [[nodiscard]] Json layer_of_bricks(int layer, int courses, int parts) const {
    return {{"grid",
             {{"name", fmt::format("layer {}", layer)},
              {"origin", {0, layer * courses}},
              {"columns", static_cast<int>(width_) * parts},
              {"rows", courses * parts},
              {"block_width", 1.0 / parts},
              {"block_height", 1.0 / parts},
              {"pattern", "running_bond"},
              {"material", layer % 2 == 0 ? "rock" : "other"}}}};
  }

  [[nodiscard]] Json rock(int parts) const {
    const double size = 1.0 / parts;
    Json rock = {{"boundary", {{0, 0}, {width_, 0}, {width_, height_}, {0, height_}}},
                 {"seed", seed_},
                 {"material", "rock"},
                 {"merge", {{"area", 0.05 * size * size}, {"angle", "10 deg"}}}};
    if (cut_ == Cut::stack) rock["joint_sets"] = {set(0, size), set(90, size * aspect_)};
    if (cut_ == Cut::triangles) rock["joint_sets"] = {set(0, 1.6 * size), set(60, 1.6 * size), set(120, 1.6 * size)};
    if (cut_ == Cut::halved_squares)
      rock["joint_sets"] = {set(0, 1.7 * size), set(90, 1.7 * size), set(45, 1.7 * size / std::sqrt(2))};
    if (cut_ == Cut::parallelograms) rock["joint_sets"] = {set(dip_, size, spread_), set(dip_ + turn_, size, spread_)};
    Json cells = {{"size", size}, {"relax", regular_}};
    if (cut_ == Cut::around_opening) {
      cells["size"] = 1.4 * size;
      cells["graded"] = {{"size", 0.7 * size}, {"growth", 0.1}};
      rock["openings"] = {{{"name", "opening"},
                           {"left_out", !removes_},
                           {"circle", {{"centre", {opening_.x(), opening_.y()}}, {"radius", radius_}}}}};
    }
    if (cut_ == Cut::voronoi || cut_ == Cut::around_opening)
      rock["fill"] = {{{"voronoi", cells}, {"joint", "default"}}};
    for (int layer = 1; layer < layers_; ++layer) {
      const double level = std::round(height_ * layer / layers_);
      rock["lines"].push_back({{"joint", "default"}, {"points", {{-1, level}, {width_ + 1, level}}}});
      if (layer % 2 == 1) rock["regions"].push_back(region(layer));
    }
    return rock;
  }

  [[nodiscard]] Json region(int layer) const {
    const double low = std::round(height_ * layer / layers_), high = std::round(height_ * (layer + 1) / layers_);
    return {{"material", "other"}, {"outline", {{-1, low}, {width_ + 1, low}, {width_ + 1, high}, {-1, high}}}};
  }

  SeededNumbers random_;
  Json scene_, history_;
  std::string traits_;
  Cut cut_ = Cut::stack;
  double width_ = 0, height_ = 0, aspect_ = 1, dip_ = 0, turn_ = 90, spread_ = 0, radius_ = 0;
  double density_ = 0, young_ = 0, poisson_ = 0, frequency_ = 0, given_dt_ = 0;
  int regular_ = 0, seed_ = 1, layers_ = 1, damping_ = 0;
  bool removes_ = false, drives_ = false, based_ = false, weighs_ = false, settles_ = false;
  Vec2 opening_;
};

}  // namespace dda
