#include "engine/scene/fading_faces.h"

#include <algorithm>
#include <variant>

#include "engine/geometry/segment.h"

namespace dda {
namespace {

constexpr double negligible = 1e-9;  // of what was exerted: sums of durations have round-off

// Whether something of what was exerted is left at some time from `from` to `to`, s after the blocks went.
bool acts_between(const TimeFunction& relaxation, double from, double to) {
  if (std::max(evaluate(relaxation, from), evaluate(relaxation, to)) > negligible) return true;
  const auto* table = std::get_if<PiecewiseLinear>(&relaxation);
  if (table == nullptr) return false;
  for (std::size_t i = 0; i < table->times.size(); ++i)
    if (table->times[i] > from && table->times[i] < to && table->values[i] > negligible) return true;
  return false;
}

StageSpan stages_of_fade(std::size_t removing, const Model& model) {
  StageSpan stages{static_cast<int>(removing), static_cast<int>(removing)};
  double from = 0;
  for (std::size_t i = removing; i < model.stages.size(); ++i) {
    const double to = from + model.stages[i].duration;
    if (acts_between(*model.stages[removing].removal.relaxation, from, to)) stages.last = static_cast<int>(i);
    from = to;
  }
  return stages;
}

void append_faces_of(std::size_t removing, const GroundPlan& plan, const Model& model, std::vector<FadingFace>& faces) {
  const std::vector<bool> absent = model.absent_in(removing);
  const StageSpan stages = stages_of_fade(removing, model);
  for (const int block : model.stages[removing].removal.blocks)
    for (const Segment& edge : edges_of(model.blocks[static_cast<std::size_t>(block)].shape))
      for (const Stretch& face : plan.stretches_along(edge))
        if (!absent[static_cast<std::size_t>(face.block)]) faces.push_back({face, stages, removing});
}

}  // namespace

std::vector<FadingFace> fading_faces(const GroundPlan& plan, const Model& model) {
  std::vector<FadingFace> faces;
  for (std::size_t i = 0; i < model.stages.size(); ++i)
    if (model.stages[i].removal.relaxation && !model.stages[i].removal.blocks.empty())
      append_faces_of(i, plan, model, faces);
  return faces;
}

}  // namespace dda
