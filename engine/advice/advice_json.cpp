#include <nlohmann/json.hpp>

#include "engine/advice/advice.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json to_json(const ErrorTerms& terms) {
  return {{"total", terms.total()}, {"blocks", terms.blocks},   {"interfaces", terms.interfaces},
          {"time", terms.time},     {"damping", terms.damping}, {"sides", terms.sides}};
}

Json to_json(const HistoryErrors& history) {
  return {{"place_m", history.place},
          {"with_end", history.with_end},
          {"speed", to_json(history.speed)},
          {"amplitude", to_json(history.amplitude)},
          {"peak", history.arrival.has_peak ? Json(history.arrival.peak) : Json(nullptr)},
          {"largest", history.arrival.largest},
          {"peak_speed", history.arrival.has_peak ? Json(history.arrival.peak_speed) : Json(nullptr)},
          {"onset_speed", history.arrival.onset_speed},
          {"likeness", history.arrival.likeness}};
}

Json sliding_of(const StageCost& cost) {
  return cost.sliding ? Json{{"least", cost.sliding->least}, {"most", cost.sliding->most}} : Json(nullptr);
}

Json limits_of(const WaveAdvice& wave) {
  if (!wave.limits) return nullptr;
  const auto blocks = [&](const std::optional<double>& scale) {
    return scale ? Json(*scale * wave.block_size) : Json(nullptr);
  };
  return {{"dt_s", or_null(wave.limits->dt)},
          {"block_m", blocks(wave.limits->scale)},
          {"both_dt_s", or_null(wave.limits->both_dt)},
          {"both_block_m", blocks(wave.limits->both_scale)},
          {"finest_dt_tried_s", wave.limits->finest.dt},
          {"finest_block_tried_m", blocks(wave.limits->finest.scale)},
          {"coarsest_dt_tried_s", wave.limits->coarsest.dt},
          {"coarsest_block_tried_m", blocks(wave.limits->coarsest.scale)}};
}

Json to_json(const WaveAdvice& wave) {
  return {{"kind", wave.kind},
          {"material", wave.material},
          {"direction", Json::array({wave.direction.x(), wave.direction.y()})},
          {"direction_name", wave.direction_name},
          {"mesh", wave.mesh},
          {"own_layers", wave.own_layers},
          {"speed_m_per_s", wave.speed},
          {"wavelength_m", wave.wavelength},
          {"block_m", wave.block_size},
          {"distance_m", wave.distance},
          {"steady", wave.steady
                         ? Json{{"speed", to_json(wave.steady->speed)}, {"amplitude", to_json(wave.steady->amplitude)}}
                         : Json(nullptr)},
          {"history", wave.history ? to_json(*wave.history) : Json(nullptr)},
          {"not_foretold", wave.not_foretold.empty() ? Json(nullptr) : Json(wave.not_foretold)},
          {"cause", wave.cause()},
          {"limits", limits_of(wave)}};
}

Json offer_of(const std::optional<ExplicitOffer>& offer) {
  return offer ? Json{{"dt_s", offer->dt}, {"rough_cpu_s", offer->seconds}} : Json(nullptr);
}

Json to_json(const StageAdvice& stage) {
  Json waves = Json::array();
  for (const WaveAdvice& wave : stage.waves) waves.push_back(to_json(wave));
  return {{"name", stage.name},
          {"integrator", stage.integrator},
          {"why_integrator", stage.why_integrator},
          {"first_dt_s", stage.first_dt},
          {"dt_s", stage.dt},
          {"chi", stage.chi.largest},
          {"chi_of_most", stage.chi.of_most},
          {"solver", stage.solver},
          {"steps", stage.cost.steps},
          {"factorizations", stage.cost.factorizations},
          {"factorizations_at_least", stage.cost.at_least},
          {"solver_iterations", stage.cost.iterations},
          {"rough_cpu_s", stage.cost.seconds},
          {"sliding_cpu_s", sliding_of(stage.cost)},
          {"stable_dt_s", stage.stable_dt > 0 ? Json(stage.stable_dt) : Json(nullptr)},
          {"explicit_instead", offer_of(stage.explicit_instead)},
          {"damping_ratio", stage.damping_ratio},
          {"waves", waves}};
}

}  // namespace

std::string to_json_text(const Advice& advice) {
  Json stages = Json::array();
  for (const StageAdvice& stage : advice.stages) stages.push_back(to_json(stage));
  const Json json = {{"frequency_hz", or_null(advice.frequency)},
                     {"load", advice.load.empty() ? Json(nullptr) : Json(advice.load)},
                     {"wanted_error", advice.wanted_error},
                     {"blocks", advice.size.blocks},
                     {"interfaces", advice.size.interfaces},
                     {"coupled_pairs", advice.size.coupled_pairs},
                     {"factor_nonzeros", advice.size.factor.nonzeros},
                     {"joints_may_open", advice.joints_may_open},
                     {"damped", advice.damped},
                     {"unseen_loads", advice.unseen},
                     {"sudden_loads", advice.sudden},
                     {"springs", advice.springs.empty() ? Json(nullptr) : Json(advice.springs)},
                     {"stages", stages}};
  return json.dump(2) + "\n";
}

}  // namespace dda
