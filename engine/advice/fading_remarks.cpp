#include "engine/advice/fading_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

#include "engine/advice/block_named.h"
#include "engine/model/stage_times.h"

namespace dda {
namespace {

constexpr double negligible = 1e-6;  // of what was exerted: sums of durations are off by less

// A fade that the run does not see the end of.
struct CutFade {
  double end = 0;       // s, of the run
  double fades_to = 0;  // s, after which nothing changes any more
  double left = 0;      // share that acts at the end of the run
  double at_last = 0;   // share that would act after the fade
};

std::optional<CutFade> cut_fade(const std::optional<TimeFunction>& relaxation, std::size_t stage, const Model& model) {
  const auto* table = relaxation ? std::get_if<PiecewiseLinear>(&*relaxation) : nullptr;
  if (table == nullptr || stage >= model.stages.size()) return std::nullopt;
  std::size_t last = table->values.size() - 1;
  while (last > 0 && table->values[last - 1] == table->values.back()) --last;
  const double start = begin_of_stage(model, stage), end = end_of_run(model);
  const CutFade fade{end, start + table->times[last], evaluate(*relaxation, end - start), table->values.back()};
  if (fade.fades_to <= end || std::abs(fade.left - fade.at_last) <= negligible) return std::nullopt;
  return fade;
}

std::string sentence(const std::string& what, const CutFade& fade) {
  return fmt::format(
      "{} fades until {:.6g} s, and the run ends at {:.6g} s: {:.3g} % of it still acts then, and {:.3g} % would in "
      "the end; stages that last longer, or a fade that is over sooner, get there",
      what, fade.fades_to, fade.end, 100 * fade.left, 100 * fade.at_last);
}

bool go_alike(const Withdrawal& a, const Withdrawal& b) {
  const auto* first = a.relaxation ? std::get_if<PiecewiseLinear>(&*a.relaxation) : nullptr;
  const auto* second = b.relaxation ? std::get_if<PiecewiseLinear>(&*b.relaxation) : nullptr;
  return a.last_stage == b.last_stage && first != nullptr && second != nullptr && first->times == second->times &&
         first->values == second->values;
}

// Bolts come in patterns, and those that go alike have one sentence.
template <typename Item>
void remark_on_withdrawals(const std::vector<Item>& items, const char* kind, const Model& model,
                           std::vector<std::string>& remarks) {
  for (auto item = items.begin(); item != items.end(); ++item) {
    const auto is_like_it = [&](const Item& other) { return go_alike(item->withdrawal, other.withdrawal); };
    if (item->withdrawal.last_stage < 0 || std::any_of(items.begin(), item, is_like_it)) continue;
    const auto next = static_cast<std::size_t>(item->withdrawal.last_stage) + 1;
    const std::optional<CutFade> fade = cut_fade(item->withdrawal.relaxation, next, model);
    if (!fade) continue;
    const auto more = std::count_if(item + 1, items.end(), is_like_it);
    const std::string others = and_more(static_cast<std::size_t>(more));
    remarks.push_back(sentence(fmt::format("stage \"{}\": what {} \"{}\"{}, taken out when it begins, exerted",
                                           model.stages[next].name, kind, item->name, others),
                               *fade));
  }
}

}  // namespace

std::vector<std::string> fading_remarks(const Model& model) {
  std::vector<std::string> remarks;
  for (std::size_t i = 0; i < model.stages.size(); ++i) {
    const Stage& stage = model.stages[i];
    if (stage.removal.blocks.empty()) continue;
    if (const auto fade = cut_fade(stage.removal.relaxation, i, model))
      remarks.push_back(
          sentence(fmt::format("stage \"{}\": what the blocks that it removes exerted", stage.name), *fade));
  }
  remark_on_withdrawals(model.bolts, "bolt", model, remarks);
  remark_on_withdrawals(model.linings, "lining", model, remarks);
  return remarks;
}

}  // namespace dda
