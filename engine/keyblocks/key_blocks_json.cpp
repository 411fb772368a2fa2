#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/keyblocks/key_blocks.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degrees = 180 / std::numbers::pi;

Json point(const Vec2& place) { return Json::array({place.x(), place.y()}); }

Json angle_of(const Vec2& way) {
  return way == Vec2::Zero() ? Json(nullptr) : Json(degrees * std::atan2(way.y(), way.x()));
}

Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

const std::string& block_name(const Model& model, int block) {
  return model.blocks[static_cast<std::size_t>(block)].name;
}

Json face_entry(const JointFace& face, const Model& model) {
  return {{"from", point(face.from)},
          {"to", point(face.to)},
          {"block", block_name(model, face.block)},
          {"neighbour", block_name(model, face.neighbour)},
          {"joint", model.joints[static_cast<std::size_t>(face.joint)].name},
          {"friction_angle_deg", degrees * std::atan(face.tan_friction)},
          {"cohesion_force", face.cohesion_force}};
}

Json motion_entry(const FirstMotion& motion) {
  return {{"mode", to_string(motion.mode)},
          {"direction_deg", angle_of(motion.direction)},
          {"slides_on", motion.mode == Mode::slides ? Json(motion.pressed) : Json::array()},
          {"drive", motion.drive},
          {"resistance", motion.resistance}};
}

Json bolts_entry(const KeyBlock& block) {
  return {{"direction_deg", angle_of(block.bolt_direction)},
          {"force", block.bolt_force ? Json(*block.bolt_force) : Json(nullptr)},
          {"least_force", block.least_bolt_force.norm()},
          {"least_direction_deg", angle_of(block.least_bolt_force)}};
}

Json obstacles_entry(const KeyBlock& block, const Model& model) {
  Json obstacles = Json::array();
  for (const Obstacle& obstacle : block.obstacles)
    obstacles.push_back({{"block", block_name(model, obstacle.block)}, {"at", point(obstacle.at)}});
  return obstacles;
}

Json entry_of(const TypeCounts& counts) {
  return {{"I", counts[0]}, {"II", counts[1]}, {"III", counts[2]}, {"IV", counts[3]}};
}

Json entry_of(const KeyBlock& block, const Model& model) {
  Json blocks = Json::array();
  for (const int each : block.body.blocks) blocks.push_back(block_name(model, each));
  Json ways = Json::array();
  for (const Ways& way : block.ways) ways.push_back({degrees * way.from, degrees * way.to});
  Json faces = Json::array();
  for (const JointFace& face : block.body.joints) faces.push_back(face_entry(face, model));
  Json free = Json::array();
  for (const FreeFace& face : block.body.free_faces)
    free.push_back({{"from", point(face.from)}, {"to", point(face.to)}});
  return {{"blocks", blocks},
          {"type", numeral(block.type)},
          {"removable", block.motion.mode != Mode::keyed},
          {"area", block.body.area},
          {"mass", block.body.mass},
          {"centroid", point(block.body.centroid)},
          {"force", point(block.acting.force)},
          {"motion", motion_entry(block.motion)},
          {"factor_of_safety", finite_or_null(block.motion.factor_of_safety)},
          {"turns", block.turns},
          {"touches", obstacles_entry(block, model)},
          {"bolts", bolts_entry(block)},
          {"ways_deg", ways},
          {"joint_faces", faces},
          {"free_faces", free}};
}

}  // namespace

std::string report_json(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model) {
  Json blocks = Json::array();
  for (const KeyBlock& block : report.blocks) blocks.push_back(entry_of(block, model));
  const Json document = {
      {"bodies_at_free_faces", report.blocks.size()},
      {"other_bodies", report.buried},
      {"surroundings", report.surroundings},
      {"blocks_taken_out", report.taken_out},
      {"by_type", entry_of(count_types(report.blocks))},
      {"by_type_without_merging", report.without_merging ? entry_of(*report.without_merging) : Json(nullptr)},
      {"wanted_factor_of_safety", question.wanted_safety},
      {"acceleration", point(question.acceleration)},
      {"not_counted", report.left_out},
      {"blocks", blocks}};
  return document.dump(1) + "\n";
}

}  // namespace dda
