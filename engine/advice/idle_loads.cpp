#include "engine/advice/idle_loads.h"

#include <fmt/format.h>

#include <set>
#include <tuple>
#include <variant>

#include "engine/advice/history_span.h"
#include "engine/advice/load_history.h"

namespace dda {
namespace {

// s on the scene's clock, in which stages of the run lie.
HistorySpan time_of(const StageSpan& stages, const Model& model) {
  HistorySpan span;
  double begin = 0;
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const double end = begin + model.stages[i].duration;
    if (i == static_cast<std::size_t>(stages.first)) span.from = begin;
    if (stages.has(i)) span.to = end;
    begin = end;
  }
  return span;
}

bool is_idle(const TimeFunction& history, const HistorySpan& acts) {
  if (std::holds_alternative<Constant>(history)) return false;
  const HistorySpan changes = changing(history);
  const bool meets = changes.from < acts.to && changes.to > acts.from;
  return !meets && evaluate(history, acts.from) == 0 && evaluate(history, acts.to) == 0;
}

class Findings {
 public:
  explicit Findings(const Model& model) : model_(model) {}

  void look_at(const char* what, int block, const TimeFunction& history, const StageSpan& stages) {
    const HistorySpan acts = time_of(stages, model_);
    if (!is_idle(history, acts)) return;
    const HistorySpan changes = changing(history);
    if (!said_.insert({changes.from, changes.to, acts.from, acts.to}).second) return;
    remarks_.push_back(fmt::format(
        "the {} of block \"{}\", {}, does nothing: it is zero but from {:g} to {:g} s on the scene's clock, "
        "and its stages run from {:g} to {:g} s",
        what, model_.blocks[static_cast<std::size_t>(block)].name, words_for(history), changes.from, changes.to,
        acts.from, acts.to));
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(remarks_); }

 private:
  const Model& model_;
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
    if (!held.amplitude.isZero(0) || held.turn != 0) findings.look_at("motion", held.block, held.history, {});
  return findings.take();
}

}  // namespace dda
