#include "engine/app/stage_end_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/reaction/release_rate.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

// A stage that fails early may have all of its blocks out of balance; the worst ones say where.
constexpr std::size_t most_listed = 1000;
constexpr std::size_t most_lines = 10;

// Forces that miss each other by more than this share of the largest are wrong in the third digit, which is what people
// read. Stages that had steps enough are at 1e-6 and below, so nothing hangs on the figure.
constexpr double far_from_balance = 1e-3;

const std::string& name_of(int block, const Model& model) { return model.blocks[static_cast<std::size_t>(block)].name; }

const std::string& stage_name(int stage, const Model& model) {
  return model.stages[static_cast<std::size_t>(stage)].name;
}

Json vector_json(const Vec2& vector) { return {vector.x(), vector.y()}; }

Json faces_json(const std::vector<HoldingFace>& faces, const Model& model) {
  Json list = Json::array();
  for (const HoldingFace& face : faces)
    list.push_back({{"block", name_of(face.neighbour, model)},
                    {"place_m", vector_json(face.place)},
                    {"force_N_per_m", vector_json(face.force)},
                    {"slides", face.slides}});
  return list;
}

void append_lines(const std::vector<UnbalancedBlock>& blocks, const char* what, const Model& model, std::string& text) {
  for (std::size_t i = 0; i < std::min(most_lines, blocks.size()); ++i)
    text +=
        fmt::format("{} in stage \"{}\": {}\n", what, stage_name(blocks[i].stage, model), described(model, blocks[i]));
  if (blocks.size() > most_lines)
    text += fmt::format("{}: {} more, see summary.json\n", what, blocks.size() - most_lines);
}

}  // namespace

Json unbalanced_json(const std::vector<UnbalancedBlock>& blocks, const Model& model) {
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(most_listed, blocks.size()); ++i)
    list.push_back({{"stage", stage_name(blocks[i].stage, model)},
                    {"block", name_of(blocks[i].block, model)},
                    {"number", blocks[i].block},
                    {"place_m", vector_json(blocks[i].place)},
                    {"mass_kg_per_m", model.mass_of(blocks[i].block)},
                    {"held_by", faces_json(blocks[i].faces, model)}});
  return list;
}

std::string unbalanced_lines(const Simulation& simulation) {
  std::string text;
  append_lines(simulation.results().loose, "loose", simulation.model(), text);
  append_lines(simulation.results().unbalanced, "out of balance", simulation.model(), text);
  return text;
}

std::string unasked_balance_remark(const Simulation& simulation) {
  const std::vector<Stage>& stages = simulation.model().stages;
  const std::vector<double>& shares = simulation.results().out_of_balance;
  std::size_t worst = 0, count = 0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (stages[i].equilibrium > 0 || !(shares[i] > far_from_balance)) continue;  // nor where it is no number
    if (count == 0 || shares[i] > shares[worst]) worst = i;
    ++count;
  }
  if (count == 0) return "";
  const std::string others = count > 1 ? fmt::format(" ({} other{} by less)", count - 1, count > 2 ? "s" : "") : "";
  return fmt::format(
      "static stage \"{}\"{} ended with forces out of balance by {:.2g} of the largest force, and was not asked for "
      "equilibrium: its rock was still on the way; longer steps, or \"equilibrium\", bring it to rest",
      stages[worst].name, others, shares[worst]);
}

Json excess_shear_json(const Simulation& simulation) {
  const Model& model = simulation.model();
  Json list = Json::array();
  for (const ExcessShear& each : simulation.results().excess)
    list.push_back({{"stage", stage_name(each.stage, model)},
                    {"joint", model.joints[static_cast<std::size_t>(each.joint)].name},
                    {"largest_Pa", each.largest},
                    {"between", {name_of(each.block_a, model), name_of(each.block_b, model)}},
                    {"place_m", vector_json(each.place)},
                    {"normal_Pa", each.normal},
                    {"shear_Pa", each.shear},
                    {"length_m", each.length},
                    {"positive_m", each.positive}});
  return list;
}

Json energy_release_rates_json(const Simulation& simulation) {
  Json list = Json::array();
  for (const ReleaseRate& rate : release_rates(simulation)) {
    const std::optional<double> per_wall = rate.per_wall();
    list.push_back({{"stage", simulation.model().stages[rate.stage].name},
                    {"released_J_per_m", rate.released},
                    {"area_m2", rate.area},
                    {"wall_m", rate.wall},
                    {"per_volume_J_per_m3", rate.per_volume()},
                    {"per_wall_J_per_m2", per_wall ? Json(*per_wall) : Json()}});
  }
  return list;
}

}  // namespace dda
