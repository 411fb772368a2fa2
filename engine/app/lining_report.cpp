#include "engine/app/lining_report.h"

#include <cmath>
#include <cstddef>

#include "engine/model/lining_chord.h"
#include "engine/simulation/run_so_far.h"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

LiningValues values_of(const Simulation& simulation, std::size_t lining, std::size_t element) {
  const SectionForces forces = linings_of(simulation).forces(simulation.model(), lining, element);
  const LiningElement& state = linings_of(simulation).element(lining, element);
  LiningValues values{forces.thrust, forces.moment(), forces.shear, forces.utilisation, LiningCondition::elastic};
  if (state.has_yielded()) values.condition = LiningCondition::yielded;
  if (state.waits) values.condition = LiningCondition::waiting;
  return values;
}

// Says between which blocks an element is, and where its middle was drawn.
Json place_of(const Model& model, const Lining& lining, std::size_t element) {
  const auto name = [&](const LiningNode& node) { return model.blocks[static_cast<std::size_t>(node.block)].name; };
  const Vec2 middle = middle_of(lining, element);
  return {{"between", {name(lining.start_of(element)), name(lining.end_of(element))}},
          {"place_m", {middle.x(), middle.y()}}};
}

// Returns `value` of the element in which it is largest in magnitude, and where that element is.
template <typename Value>
Json largest(const Simulation& simulation, std::size_t index, const char* unit, const Value& value) {
  const Lining& lining = simulation.model().linings[index];
  std::size_t where = 0;
  double most = 0;
  for (std::size_t i = 0; i < lining.elements(); ++i) {
    const double own = value(values_of(simulation, index, i));
    if (std::abs(own) <= std::abs(most)) continue;
    most = own;
    where = i;
  }
  Json json = {{"value", most}, {"unit", unit}};
  json.update(place_of(simulation.model(), lining, where));
  return json;
}

Json yielded(const Simulation& simulation, std::size_t index) {
  const Lining& lining = simulation.model().linings[index];
  Json places = Json::array();
  for (std::size_t i = 0; i < lining.elements(); ++i)
    if (linings_of(simulation).element(index, i).has_yielded())
      places.push_back(place_of(simulation.model(), lining, i));
  return places;
}

}  // namespace

std::vector<LiningValues> lining_values_of(const Simulation& simulation) {
  std::vector<LiningValues> values;
  const std::vector<Lining>& linings = simulation.model().linings;
  for (std::size_t i = 0; i < linings.size(); ++i)
    for (std::size_t j = 0; j < linings[i].elements(); ++j) values.push_back(values_of(simulation, i, j));
  return values;
}

Json linings_json(const Simulation& simulation) {
  Json json = Json::array();
  const std::vector<Lining>& linings = simulation.model().linings;
  for (std::size_t i = 0; i < linings.size(); ++i) {
    const auto of = [&](const char* unit, auto value) { return largest(simulation, i, unit, value); };
    Json entry = {{"name", linings[i].name}, {"elements", linings[i].elements()}};
    entry["sprayed"] = !linings_of(simulation).element(i, 0).waits;
    entry["thrust"] = of("N", [](const LiningValues& values) { return values.thrust; });
    entry["moment"] = of("N m", [](const LiningValues& values) { return values.moment; });
    entry["shear"] = of("N", [](const LiningValues& values) { return values.shear; });
    if (linings[i].yields()) {
      entry["utilisation"] = of("-", [](const LiningValues& values) { return values.utilisation; });
      entry["yielded"] = yielded(simulation, i);
    }
    json.push_back(entry);
  }
  return json;
}

}  // namespace dda
