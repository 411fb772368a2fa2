#include "engine/keyblocks/key_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "engine/keyblocks/bolt_force.h"
#include "engine/keyblocks/resultants.h"

namespace dda {
namespace {

BlockType type_of(const FirstMotion& motion) {
  if (motion.mode == Mode::keyed) return BlockType::tapered;
  if (motion.mode == Mode::stable) return BlockType::stable;
  return motion.factor_of_safety >= 1 ? BlockType::friction_held : BlockType::key;
}

// Just beyond the middle of a face there is the opening that it belongs to.
bool faces_opening(const FreeFace& face, const std::vector<Polygon>& opening) {
  constexpr double beyond = 1e-3;  // of the face's length: off its ends, still inside a narrow opening
  const Vec2 place = (face.from + face.to) / 2 + beyond * face.length() * face.outward;
  return opening.empty() ||
         std::any_of(opening.begin(), opening.end(), [&](const Polygon& part) { return contains(part, place); });
}

bool is_asked_for(const RockBody& body, const std::vector<Polygon>& opening) {
  return std::any_of(body.free_faces.begin(), body.free_faces.end(),
                     [&](const FreeFace& face) { return faces_opening(face, opening); });
}

// Against the mean of what looks out of the free faces; upwards where they look all around.
Vec2 square_into(const std::vector<FreeFace>& faces) {
  Vec2 out = Vec2::Zero();
  double length = 0;
  for (const FreeFace& face : faces) {
    out += face.length() * face.outward;
    length += face.length();
  }
  return out.norm() > 1e-9 * length ? Vec2(-out.normalized()) : Vec2(Vec2::UnitY());
}

KeyBlock judged(RockBody body, const Resultant& acting, const Obstacles& obstacles, const KeyBlockQuestion& question) {
  KeyBlock block;
  block.acting = acting;
  block.motion = first_motion(body.joints, acting.force);
  block.type = type_of(block.motion);
  block.turns = turns(body, acting, block.motion);
  block.ways = permitted_ways(body.joints);
  if (block.motion.direction != Vec2::Zero()) block.obstacles = obstacles.in_way_of(body, block.motion.direction);
  block.bolt_direction = question.bolt_direction
                             ? Vec2(std::cos(*question.bolt_direction), std::sin(*question.bolt_direction))
                             : square_into(body.free_faces);
  block.bolt_force = bolt_force(body.joints, acting.force, block.bolt_direction, question.wanted_safety);
  block.least_bolt_force = least_bolt_force(body.joints, acting.force, question.wanted_safety);
  block.body = std::move(body);
  return block;
}

auto order(const KeyBlock& block) {
  return std::tuple(block.type, block.motion.factor_of_safety, block.body.blocks.front());
}

}  // namespace

std::string_view numeral(BlockType type) {
  constexpr std::array<std::string_view, 4> names{"I", "II", "III", "IV"};
  return names[static_cast<std::size_t>(type)];
}

std::string_view description(BlockType type) {
  constexpr std::array<std::string_view, 4> names{"key block", "held by friction", "stable", "cannot be removed"};
  return names[static_cast<std::size_t>(type)];
}

std::string name_of(const RockBody& body, const Model& model) {
  std::string name;
  for (const int block : body.blocks)
    name += (name.empty() ? "" : " + ") + model.blocks[static_cast<std::size_t>(block)].name;
  return name;
}

TypeCounts count_types(const std::vector<KeyBlock>& blocks) {
  TypeCounts counts{};
  for (const KeyBlock& block : blocks) ++counts[static_cast<std::size_t>(block.type)];
  return counts;
}

KeyBlockReport key_blocks(const Model& model, const KeyBlockQuestion& question) {
  std::vector<RockBody> bodies = rock_bodies(model, question.is_void);
  Resultants acting = resultants_on(bodies, model, question.acceleration);
  const Obstacles obstacles(model, question.is_void);
  KeyBlockReport report;
  report.taken_out = static_cast<int>(std::count(question.is_void.begin(), question.is_void.end(), true));
  report.left_out = std::move(acting.left_out);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].surroundings)
      ++report.surroundings;
    else if (is_asked_for(bodies[i], question.opening))
      report.blocks.push_back(judged(std::move(bodies[i]), acting.of[i], obstacles, question));
    else
      ++report.buried;
  }
  std::sort(report.blocks.begin(), report.blocks.end(),
            [](const KeyBlock& a, const KeyBlock& b) { return order(a) < order(b); });
  return report;
}

}  // namespace dda
