#include "engine/advice/idle_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "engine/advice/block_named.h"
#include "engine/advice/history_span.h"
#include "engine/advice/load_history.h"
#include "engine/model/held_motion.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

// s on the scene's clock, in which stages of the run lie.
HistorySpan time_of(const StageSpan& stages, const Model& model) {
  const auto past_last = stages.last < 0 ? model.stages.size() : static_cast<std::size_t>(stages.last) + 1;
  return {begin_of_stage(model, static_cast<std::size_t>(stages.first)), begin_of_stage(model, past_last)};
}

bool is_idle(const TimeFunction& history, const HistorySpan& changes, const HistorySpan& acts) {
  if (std::holds_alternative<Constant>(history)) return false;
  const bool meets = changes.from < acts.to && changes.to > acts.from;
  return !meets && evaluate(history, acts.from) == 0 && evaluate(history, acts.to) == 0;
}

bool all_zero(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return value == 0; });
}

// A table or a recording may have nothing but zeros.
bool is_nothing(const TimeFunction& history) {
  if (const auto* table = std::get_if<PiecewiseLinear>(&history)) return all_zero(table->values);
  if (const auto* recorded = std::get_if<Recorded>(&history)) return all_zero(recorded->recording->values());
  return false;
}

class Findings {
 public:
  explicit Findings(const Model& model) : model_(model) {}

  void look_at(const char* what, int block, const TimeFunction& history, const StageSpan& stages) {
    const HistorySpan acts = time_of(stages, model_), changes = changing(history);
    if (is_nothing(history)) return say_nothing(what, block, history);
    if (!is_idle(history, changes, acts)) return;
    if (!said_.insert({changes.from, changes.to, acts.from, acts.to}).second) return;
    remarks_.push_back(fmt::format(
        "the {} of {}, {}, does nothing: it is zero but from {:g} to {:g} s on the scene's clock, "
        "and its stages run from {:g} to {:g} s",
        what, block_named(model_, block), words_for(history), changes.from, changes.to, acts.from, acts.to));
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(remarks_); }

 private:
  // Once for all with a history in the same words: an edge has many blocks.
  void say_nothing(const char* what, int block, const TimeFunction& history) {
    if (!nothings_.insert(what + words_for(history)).second) return;
    remarks_.push_back(fmt::format("the {} of {}, {}, does nothing: it is zero all the time", what,
                                   block_named(model_, block), words_for(history)));
  }

  const Model& model_;
  std::set<std::string> nothings_;
  std::set<std::tuple<double, double, double, double>> said_;
  std::vector<std::string> remarks_;
};

}  // namespace

std::vector<std::string> idle_loads(const Model& model) {
  Findings findings(model);
  for (const EdgeLoad& load : model.edge_loads) findings.look_at("load", load.block, load.history, load.stages);
  for (const PointLoad& load : model.point_loads) findings.look_at("load", load.block, load.history, load.stages);
  for (const PointSupport& support : model.supports)
    if (!support.amplitude.isZero(0))
      findings.look_at("motion", support.block, support.history, {0, support.last_stage});
  for (const HeldBlock& held : model.held_blocks)
    if (moves(held)) findings.look_at("motion", held.block, held.history, {});
  return findings.take();
}

}  // namespace dda
