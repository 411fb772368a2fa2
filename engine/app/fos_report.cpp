#include "engine/app/fos_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/app/block_sheet.h"
#include "engine/app/unseen_by_fos.h"
#include "engine/core/status.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

double direction_deg(const Vec2& way) { return std::atan2(way.y(), way.x()) * 180 / std::numbers::pi; }

std::string headline(const SafetyReport& report, const SafetyQuestion& question) {
  if (report.is_bracketed())
    return fmt::format("factor of safety {:.4g}: stands at {:.4g}, fails at {:.4g} ({})", report.factor(),
                       report.stands, report.fails, report.failure.reason);
  if (report.stands > 0)
    return fmt::format("factor of safety above {:g}: it stands at all that were tried", question.most);
  if (!report.failure.is_loaded)
    return fmt::format("no factor of safety: it does not stand even when closed joints cannot slide ({})",
                       report.failure.reason);
  return fmt::format("factor of safety below {:g} ({})", 1 / question.most, report.failure.reason);
}

// What joints lose by being brittle.
std::string said_of_lost_strength(const SafetyReport& kept, const SafetyReport& report) {
  if (kept.stands == 0) return "";
  const std::string factor =
      kept.is_bracketed() ? fmt::format("{:.4g}", kept.factor()) : fmt::format("above {:.4g}", kept.stands);
  const double share = (kept.is_bracketed() ? kept.factor() : kept.stands) / report.factor() - 1;
  return fmt::format(
      "joints that keep cohesion and friction as they slide have {} ({:+.1f} %; limit equilibrium takes them so): here "
      "they lose them before all of it acts\n  (\"residual_cohesion\" of a joint equal to its \"cohesion\" keeps it)\n",
      factor, 100 * share);
}

Json number_or_null(double value) { return value > 0 ? Json(value) : Json(); }

Json kept_json(const SafetyReport& kept) {
  if (kept.stands == 0) return {};
  return {{"factor_of_safety", number_or_null(kept.factor())},
          {"stands_at", kept.stands},
          {"fails_at", number_or_null(kept.fails)}};
}

Json trial_json(const SafetyTrial& trial) {
  return {{"factor", trial.factor},
          {"stands", trial.stands},
          {"status", to_string(trial.status)},
          {"reason", trial.reason},
          {"largest_movement", trial.largest_movement}};
}

Json block_json(const MovingBlock& moving, const Model& model) {
  const Block& block = model.blocks[static_cast<std::size_t>(moving.block)];
  return {{"block", block.name},
          {"centroid", {block.moments.centroid.x(), block.moments.centroid.y()}},
          {"movement", {moving.movement.x(), moving.movement.y()}},
          {"direction_deg", direction_deg(moving.movement)},
          {"share_of_size", moving.share}};
}

enum Kind : std::size_t { moves, stays, held, kinds };
struct Look {
  std::string_view fill, text;
};
constexpr std::array<Look, kinds> looks{
    {{"#e2725b", "moves when the rock fails"}, {"#e9e9e6", "moves by less than a tenth of that"}, {"#b9cbe0", "held"}}};

void draw_arrow(const MovingBlock& moving, const Model& model, BlockSheet& sheet) {
  const AreaMoments& moments = model.blocks[static_cast<std::size_t>(moving.block)].moments;
  const double length = std::clamp(sheet.scale() * std::sqrt(moments.area) / 2, 8.0, 40.0);  // px
  sheet.draw_arrow(moments.centroid, moving.movement.normalized(), length);
}

}  // namespace

std::vector<MovingBlock> moving_blocks(const Standing& failure, const Model& model) {
  constexpr double least_share = 0.1;  // of the largest
  std::vector<MovingBlock> moving;
  for (std::size_t i = 0; i < failure.movement.size(); ++i) {
    const double share = failure.movement[i].norm() / std::sqrt(model.blocks[i].moments.area);
    if (share > 0 && share >= least_share * failure.largest_movement)
      moving.push_back({static_cast<int>(i), failure.movement[i], share});
  }
  std::ranges::stable_sort(moving, std::greater{}, &MovingBlock::share);
  return moving;
}

std::string fos_text(const SafetyReport& report, const SafetyReport& kept, const SafetyQuestion& question,
                     const Model& model) {
  constexpr std::size_t most = 8;
  std::string text = headline(report, question) + "\n";
  const std::vector<MovingBlock> moving = moving_blocks(report.failure, model);
  for (std::size_t i = 0; i < std::min(most, moving.size()); ++i) {
    const Block& block = model.blocks[static_cast<std::size_t>(moving[i].block)];
    text += fmt::format("  {} moves towards {:.1f} deg\n", block.name, direction_deg(moving[i].movement));
  }
  if (moving.size() > most) text += fmt::format("  and {} more\n", moving.size() - most);
  return text + said_of_lost_strength(kept, report) +
         said_of_unseen(unseen_by_fos(model, question.time), question.time);
}

std::string fos_json(const SafetyReport& report, const SafetyReport& kept, const SafetyQuestion& question,
                     const Model& model) {
  Json json{{"factor_of_safety", number_or_null(report.factor())},
            {"stands_at", number_or_null(report.stands)},
            {"fails_at", number_or_null(report.fails)},
            {"reason", report.failure.reason},
            {"strength_kept", kept_json(kept)},
            {"most", question.most},
            {"time", question.time},
            {"not_seen", unseen_by_fos(model, question.time)},
            {"trials", Json::array()},
            {"moving_blocks", Json::array()}};
  for (const SafetyTrial& trial : report.trials) json["trials"].push_back(trial_json(trial));
  for (const MovingBlock& moving : moving_blocks(report.failure, model))
    json["moving_blocks"].push_back(block_json(moving, model));
  return json.dump(1) + "\n";
}

std::string fos_picture(const SafetyReport& report, const Model& model) {
  BlockSheet sheet(model);
  const std::vector<MovingBlock> moving = moving_blocks(report.failure, model);
  std::vector<Kind> kind_of(model.blocks.size(), stays);
  for (const HeldBlock& block : model.held_blocks) kind_of[static_cast<std::size_t>(block.block)] = held;
  for (const MovingBlock& block : moving) kind_of[static_cast<std::size_t>(block.block)] = moves;
  std::array<SvgPath, kinds> paths;
  for (std::size_t i = 0; i < kind_of.size(); ++i) sheet.append_block(model.blocks[i].shape, paths[kind_of[i]]);
  for (std::size_t kind = 0; kind < kinds; ++kind) sheet.draw_blocks(paths[kind], looks[kind].fill);
  for (const MovingBlock& block : moving) draw_arrow(block, model, sheet);
  for (const Look& look : looks) sheet.add_area_to_key(look.fill, look.text);
  return sheet.text(320);
}

}  // namespace dda
