#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>

#include "engine/core/place_in_words.h"
#include "engine/keyblocks/key_blocks.h"

namespace dda {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

double angle_of(const Vec2& way) {
  const double angle = degrees * std::atan2(way.y(), way.x());
  return std::abs(angle) < 5e-10 ? 0.0 : angle;  // no "-0"
}

std::string joints_pressed(const KeyBlock& block, const Model& model) {
  std::set<std::string> names;
  for (const int index : block.motion.pressed) {
    const JointFace& face = block.body.joints[static_cast<std::size_t>(index)];
    names.insert(model.joints[static_cast<std::size_t>(face.joint)].name);
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? " on " : ", ") + name;
  return text;
}

std::string motion_of(const KeyBlock& block, const Model& model) {
  if (block.motion.mode == Mode::keyed) return "";
  if (block.motion.mode == Mode::stable) return ", pressed onto its neighbours";
  const bool up = block.motion.mode == Mode::falls && block.motion.direction.y() > 0;
  return fmt::format(", {} towards {:.1f} deg{}, factor of safety {:.4g}", up ? "lifts" : to_string(block.motion.mode),
                     angle_of(block.motion.direction), joints_pressed(block, model), block.motion.factor_of_safety);
}

std::string bolts_of(const KeyBlock& block) {
  const double least = block.least_bolt_force.norm();
  if (least == 0) return "";
  const std::string square =
      block.bolt_force ? fmt::format("{:.4g} N/m towards {:.1f} deg", *block.bolt_force, angle_of(block.bolt_direction))
                       : fmt::format("no force towards {:.1f} deg is enough", angle_of(block.bolt_direction));
  return fmt::format("    bolts: {}; least {:.4g} N/m towards {:.1f} deg\n", square, least,
                     angle_of(block.least_bolt_force));
}

std::string obstacles_of(const KeyBlock& block, const Model& model) {
  std::string text;
  for (const Obstacle& obstacle : block.obstacles)
    text += fmt::format("    its way out touches {} at {}; a run may find it held there\n",
                        model.blocks[static_cast<std::size_t>(obstacle.block)].name, place_in_words(obstacle.at));
  return text;
}

std::string merging_of(const KeyBlockReport& report) {
  if (!report.without_merging) return "";
  const TypeCounts now = count_types(report.blocks);
  const TypeCounts before = *report.without_merging;
  return fmt::format(
      "merging small or sharp blocks left {} of type I (of {} without it), {} of II ({}), {} of III ({}), {} of IV "
      "({})\n",
      now[0], before[0], now[1], before[1], now[2], before[2], now[3], before[3]);
}

}  // namespace

std::string report_text(const KeyBlockReport& report, const KeyBlockQuestion& question, const Model& model) {
  std::string text = fmt::format("{} bodies at free faces, {} others, {} of the surroundings; {} blocks taken out\n",
                                 report.blocks.size(), report.buried, report.surroundings, report.taken_out);
  for (const KeyBlock& block : report.blocks) {
    text += fmt::format("{:>3}  {}, {:.4g} m2: {}{}{}\n", numeral(block.type), name_of(block.body, model),
                        block.body.area, description(block.type), motion_of(block, model),
                        block.turns ? "; it also turns, which is not counted" : "");
    text += obstacles_of(block, model) + bolts_of(block);
  }
  if (report.blocks.empty()) text += "no body has a free face that was asked for\n";
  text += merging_of(report);
  for (const std::string& what : report.left_out) text += "not counted: " + what + "\n";
  if (model.gravity == Vec2::Zero() && question.acceleration == Vec2::Zero())
    text += "the scene has no gravity: only loads act\n";
  return text;
}

}  // namespace dda
