#include "engine/scene/drawn_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "engine/core/error.h"
#include "engine/drawing/layers.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/diameter.h"
#include "engine/geometry/segment.h"
#include "engine/scene/read_drawn_plan.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double share_of_diameter = 1e-6;  // within which points lie on outlines, as when cutting
constexpr double level = 1e-2;              // of that: what lies so near the bottom is found by its name

const std::string& word(LayerRole role) { return role_names()[static_cast<std::size_t>(role)]; }

json position(const Vec2& point) { return {point.x(), point.y()}; }

class MarkedPlaces {
 public:
  MarkedPlaces(const Rock& rock, const std::vector<Block>& blocks, json& scene)
      : plan_(rock.plan), blocks_(blocks), scene_(scene), index_(boxes_of(blocks)) {
    std::vector<Vec2> corners;
    for (const Block& block : blocks) corners.insert(corners.end(), block.shape.outer.begin(), block.shape.outer.end());
    bottom_ = bounding_box(corners).lower.y();
    tolerance_ = share_of_diameter * diameter(std::move(corners));
  }

  void add() {
    for (const PlanPoint& point : plan_.points) {
      if (point.layer == word(LayerRole::fix_point)) hold(point);
      if (point.layer == word(LayerRole::measure_point)) measure(point);
    }
    for (const PlanMark& mark : plan_.marks) absorb(mark);
    if (scene_.contains("supports"))
      held_ = "held at its fix points";
    else if (scene_.contains("viscous_boundaries"))
      leave_alone("without gravity, as nothing but edges that absorb waves holds it");
    else
      hold_bottom();
    scene_["description"] =
        "Cut from a drawing. Assumed, until what is known takes its place: rock of 2.6 t/m3 and 20 GPa, "
        "joints of 35 deg without cohesion, 1 s of motion; " +
        held_ + "." + loads();
  }

 private:
  static std::vector<Box> boxes_of(const std::vector<Block>& blocks) {
    std::vector<Box> boxes;
    for (const Block& block : blocks) boxes.push_back(bounding_box(block.shape));
    return boxes;
  }

  // Inside, or with the point on their outline.
  [[nodiscard]] std::vector<std::string> blocks_at(const PlanPoint& point) const {
    std::vector<std::string> names;
    for (const int i : index_.overlapping(expanded(Box{point.at, point.at}, tolerance_))) {
      const Block& block = blocks_[static_cast<std::size_t>(i)];
      if (locate(block.shape, point.at, tolerance_) != Location::outside) names.push_back(block.name);
    }
    if (names.empty())
      throw InputError("", point.origin, "at " + written(point.at) + ", in no block", "a place in the rock");
    return names;
  }

  void hold(const PlanPoint& point) {
    for (const std::string& block : blocks_at(point))
      scene_["supports"].push_back({{"point", position(point.at)}, {"block", block}});
  }

  void measure(const PlanPoint& point) {
    const std::string block = blocks_at(point).front();
    for (const char* axis : {"x", "y"})
      scene_["measurements"].push_back({{"name", fmt::format("{} {}", point.name, axis)},
                                        {"quantity", fmt::format("displacement_{}", axis)},
                                        {"point", position(point.at)},
                                        {"block", block}});
  }

  void absorb(const PlanMark& mark) {
    for (std::size_t i = 1; i < mark.points.size(); ++i)
      scene_["viscous_boundaries"].push_back(
          {{"edge", {{"from", position(mark.points[i - 1])}, {"to", position(mark.points[i])}}}});
  }

  // A bottom that is level but for the tolerance, as where a gap in it was closed, is no side of the box to the scene.
  void hold_bottom() {
    const std::vector<Segment> edges = bottom_edges();
    if (edges.empty())
      return leave_alone("without gravity, as nothing holds it: it has neither fix points nor a level bottom");
    const auto is_level = [this](const Segment& edge) {
      return std::max(edge.start.y(), edge.end.y()) <= bottom_ + level * tolerance_;
    };
    if (std::ranges::all_of(edges, is_level)) {
      scene_["supports"] = json::array({json{{"edge", "bottom"}}});
    } else {
      for (const Segment& edge : edges)
        scene_["supports"].push_back({{"edge", {{"from", position(edge.start)}, {"to", position(edge.end)}}}});
    }
    held_ = "held along its bottom";
  }

  [[nodiscard]] std::vector<Segment> bottom_edges() const {
    std::vector<Segment> edges;
    const auto low = [&](const Vec2& point) { return point.y() <= bottom_ + tolerance_; };
    for (const Block& block : blocks_) {
      const Ring& ring = block.shape.outer;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Segment edge{ring[i], ring[(i + 1) % ring.size()]};
        if (low(edge.start) && low(edge.end)) edges.push_back(edge);
      }
    }
    return edges;
  }

  [[nodiscard]] std::string loads() const {
    const auto count = std::ranges::count(plan_.points, word(LayerRole::load_point), &PlanPoint::layer);
    return count == 0 ? "" : fmt::format(" Load points: {}, to which the scene has yet to give loads.", count);
  }

  void leave_alone(const std::string& why) {
    held_ = why;
    scene_.erase("gravity");
    scene_["steps"].erase(0);
  }

  const RockPlan& plan_;
  const std::vector<Block>& blocks_;
  json& scene_;
  BoxIndex index_;
  double bottom_ = 0;
  double tolerance_ = 0;
  std::string held_;
};

json assumed_rock() { return {{"density", "2.6 t/m3"}, {"young", "20 GPa"}, {"poisson", 0.25}}; }

json assumed_joint() { return {{"friction_angle", "35 deg"}}; }

}  // namespace

json scene_around(const std::filesystem::path& drawing, const DrawingWords& words) {
  json file = {{"file", drawing.string()}, {"layers", words.layers}};
  if (!words.unit.empty()) file["unit"] = words.unit;
  json rock = {{"drawing", std::move(file)}};
  const DrawnNames names = drawn_names(drawing, drawing.string());
  json materials = json::object();
  for (const std::string& name : names.materials) materials[name] = assumed_rock();
  if (materials.empty()) materials["rock"] = assumed_rock();
  if (materials.size() > 1) rock["material"] = materials.begin().key();
  json joints = {{"default", assumed_joint()}};
  for (const std::string& name : names.joints) joints[name] = assumed_joint();
  return {{"dda", 1},
          {"title", readable(drawing.stem().string())},
          {"gravity", "9.81 m/s2"},
          {"materials", std::move(materials)},
          {"joints", std::move(joints)},
          {"blocks", {{"rock", std::move(rock)}}},
          {"steps",
           {{{"name", "gravity"},
             {"integrator", "static"},
             {"strength", "unlimited"},
             {"dt", "0.1 s"},
             {"duration", "4 s"}},
            {{"name", "motion"}, {"dt", "1 ms"}, {"duration", "1 s"}}}}};
}

void add_marked_places(const Rock& rock, const std::vector<Block>& blocks, json& scene) {
  MarkedPlaces(rock, blocks, scene).add();
}

}  // namespace dda
