#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "engine/app/run_verdict.h"
#include "engine/core/place_in_words.h"
#include "engine/simulation/block_system.h"

namespace dda {
namespace {

std::string sentence(const SmallMotionError& each, const Model& model) {
  const auto name = [&](int block) { return model.blocks[static_cast<std::size_t>(block)].name; };
  const std::string block = fmt::format("block \"{}\" at {}", name(each.block), place_in_words(each.place));
  switch (each.fault) {
    case SmallMotionFault::turned:
      return fmt::format("{} has turned by {:.3g} deg, by which its lengths are wrong by {:.2g} %", block,
                         each.amount * 180 / std::numbers::pi, 100 * each.error);
    case SmallMotionFault::leaned:
      return fmt::format(
          "{} leans by {:.3g} m over its contact, {:.2g} % of the length of that, where its weight "
          "still acts as drawn",
          block, each.amount, 100 * each.error);
    case SmallMotionFault::slid:
      return each.error >= ruinous_error(each.fault)
                 ? fmt::format("{} has slid by {:.3g} m along \"{}\", beyond the end of their common face", block,
                               each.amount, name(each.other))
                 : fmt::format(
                       "{} has slid by {:.3g} m along \"{}\", {:.2g} % of a face on which forces stay where "
                       "they were",
                       block, each.amount, name(each.other), 100 * each.error);
    case SmallMotionFault::passed:
      return fmt::format(
          "{} is or was deeper than {:.2g} m in \"{}\", {:.2g} % of the thinner one, where no contact acts", block,
          each.amount, name(each.other), 100 * each.error);
    case SmallMotionFault::may_have_passed:
      return fmt::format(
          "{} may have been deeper than {:.2g} m in \"{}\", {:.2g} % of the thinner one, where no contact acts: it was "
          "on "
          "the straight way there",
          block, each.amount, name(each.other), 100 * each.error);
  }
  return "";
}

}  // namespace

RunVerdict judge_motion(const Simulation& simulation) {
  const std::vector<SmallMotionError> errors = simulation.system().audit.small_motion.errors();
  if (errors.empty()) return {};
  const auto share_of_ruin = [](const SmallMotionError& each) { return each.error / ruinous_error(each.fault); };
  const SmallMotionError worst = *std::ranges::max_element(errors, {}, share_of_ruin);
  const bool is_ruined = share_of_ruin(worst) >= 1;
  return {is_ruined ? Status::inaccurate : Status::ok,
          fmt::format("{}kinematics are small, but {}; take \"kinematics\": \"finite\"",
                      is_ruined ? "" : "warning: ", sentence(worst, simulation.model()))};
}

}  // namespace dda
