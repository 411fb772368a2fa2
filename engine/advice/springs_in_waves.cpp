#include "engine/advice/springs_in_waves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/advice/projected_offer.h"

namespace dda {
namespace {

bool could_have_the_law(const Model& model, const JointMaterial& joint) {
  return joint.normal_stiffness == 0 && could_be_projected(model, joint);
}

double largest_error(const Advice& advice) {
  double largest = 0;
  for (const StageAdvice& stage : advice.stages)
    for (const WaveAdvice& wave : stage.waves)
      if (const ErrorTerms* speed = wave.speed_error()) largest = std::max(largest, std::abs(speed->interfaces));
  return largest;
}

}  // namespace

std::string springs_in_waves(const Model& model, const Advice& advice) {
  const double error = largest_error(advice);
  const auto could = [&](const JointMaterial& joint) { return could_have_the_law(model, joint); };
  if (error <= advice.wanted_error || std::ranges::none_of(model.joints, could)) return "";
  return fmt::format(
      "springs at closed joints make the speed of waves up to {:.2g} % wrong: with \"law\": \"projected\" for the "
      "joint, closed joints carry waves as solid rock does",
      100 * error);
}

}  // namespace dda
