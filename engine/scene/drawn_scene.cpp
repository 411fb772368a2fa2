#include "engine/scene/drawn_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/drawing/layers.h"
#include "engine/drawing/read_drawing.h"
#include "engine/geometry/box.h"
#include "engine/geometry/box_pairs.h"
#include "engine/geometry/diameter.h"
#include "engine/geometry/segment.h"
#include "engine/scene/read_drawn_plan.h"
#include "engine/scene/run_data_scene.h"

namespace dda {
namespace {

using nlohmann::json;

constexpr double share_of_diameter = 1e-6;  // within which points lie on outlines, as when cutting
constexpr double level = 1e-2;              // of that: what lies so near the bottom is found by its name

const std::string& word(LayerRole role) { return role_names()[static_cast<std::size_t>(role)]; }

json position(const Vec2& point) { return {point.x(), point.y()}; }

// Appends what of `segment` does not run along `other`.
void append_rest(const Segment& segment, const Segment& other, double tolerance, std::vector<Segment>& rest) {
  const auto common = collinear_overlap(segment, other, tolerance);
  if (!common) {
    rest.push_back(segment);
    return;
  }
  if ((common->first - segment.start).norm() > tolerance) rest.push_back({segment.start, common->first});
  if ((segment.end - common->second).norm() > tolerance) rest.push_back({common->second, segment.end});
}

class MarkedPlaces {
 public:
  MarkedPlaces(const Rock& rock, const std::vector<Block>& blocks, const std::optional<RunData>& data, json& scene)
      : plan_(rock.plan), blocks_(blocks), data_(data), scene_(scene), index_(boxes_of(blocks)) {
    std::vector<Vec2> corners;
    for (const Block& block : blocks) corners.insert(corners.end(), block.shape.outer.begin(), block.shape.outer.end());
    bottom_ = bounding_box(corners).lower.y();
    tolerance_ = share_of_diameter * diameter(std::move(corners));
  }

  void add() {
    for (const PlanPoint& point : plan_.points) {
      if (point.layer == word(LayerRole::fix_point)) hold(point, next_table());
      if (point.layer == word(LayerRole::load_point)) load(point, next_table());
      if (point.layer == word(LayerRole::measure_point)) measure(point);
    }
    for (const PlanMark& mark : plan_.marks) absorb(mark);
    if (data_)
      describe_data();
    else
      hold_and_describe();
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

  // Fixed points of the drawing come before load points, as their tables do.
  PointTable next_table() {
    if (!data_ || data_->points.empty()) return {};
    return data_->points.at(tables_taken_++);
  }

  void hold(const PlanPoint& point, const PointTable& table) {
    for (const std::string& block : blocks_at(point)) {
      const json place = {{"point", position(point.at)}, {"block", block}};
      if (table.rows.empty())
        scene_["supports"].push_back(place);
      else
        add_moved_supports(table, place, scene_);
    }
  }

  // One block has the load: each of several would have all of it.
  void load(const PlanPoint& point, const PointTable& table) {
    if (!table.rows.empty())
      add_loads(table, {{"point", position(point.at)}, {"block", blocks_at(point).front()}}, scene_);
  }

  void measure(const PlanPoint& point) {
    const std::string block = blocks_at(point).front();
    for (const char* axis : {"x", "y"})
      scene_["measurements"].push_back({{"name", fmt::format("{} {}", point.name, axis)},
                                        {"quantity", fmt::format("displacement_{}", axis)},
                                        {"point", position(point.at)},
                                        {"block", block}});
  }

  // Lines drawn twice count once: an edge that absorbs twice sends waves back.
  void absorb(const PlanMark& mark) {
    for (std::size_t i = 1; i < mark.points.size(); ++i)
      for (const Segment& part : not_absorbing_yet({mark.points[i - 1], mark.points[i]})) {
        scene_["viscous_boundaries"].push_back(
            {{"edge", {{"from", position(part.start)}, {"to", position(part.end)}}}});
        absorbing_.push_back(part);
      }
  }

  [[nodiscard]] std::vector<Segment> not_absorbing_yet(const Segment& segment) const {
    std::vector<Segment> parts{segment};
    for (const Segment& other : absorbing_) {
      std::vector<Segment> rest;
      for (const Segment& part : parts) append_rest(part, other, tolerance_, rest);
      parts = std::move(rest);
    }
    return parts;
  }

  void hold_and_describe() {
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

  void describe_data() {
    take_steps_and_state(*data_, blocks_, scene_);
    scene_["description"] = fmt::format(
        "Cut from a drawing, with {} of df: numbers in the units that the file has, steps as long as df begins with, "
        "plane stress; contacts and integrator as in df (scheme thesis).{}",
        data_->name, data_->points.empty() ? loads() : "");
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
  const std::optional<RunData>& data_;
  json& scene_;
  BoxIndex index_;
  double bottom_ = 0;
  double tolerance_ = 0;
  std::size_t tables_taken_ = 0;
  std::vector<Segment> absorbing_;
  std::string held_;
};

json assumed_rock() { return {{"density", "2.6 t/m3"}, {"young", "20 GPa"}, {"poisson", 0.25}}; }

json assumed_joint() { return {{"friction_angle", "35 deg"}}; }

}  // namespace

std::optional<RunData> run_data_for(const std::filesystem::path& drawing, const DrawingWords& words) {
  if (words.run_data.empty()) return std::nullopt;
  return read_run_data(words.run_data, fixed_and_loaded(read_drawing(drawing, drawing.string())));
}

json scene_around(const std::filesystem::path& drawing, const DrawingWords& words, const std::optional<RunData>& data) {
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
  json scene = {{"dda", 1},
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
  if (data) take_materials_and_joints(*data, read_drawing(drawing, drawing.string()), scene);
  return scene;
}

void add_marked_places(const Rock& rock, const std::vector<Block>& blocks, const std::optional<RunData>& data,
                       json& scene) {
  MarkedPlaces(rock, blocks, data, scene).add();
}

}  // namespace dda
