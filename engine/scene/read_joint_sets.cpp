#include "engine/scene/read_joint_sets.h"

#include <fmt/format.h>

#include "engine/scene/block_group.h"
#include "engine/scene/places.h"

namespace dda {
namespace {

constexpr Spread spreads[] = {Spread::normal, Spread::uniform, Spread::exponential, Spread::lognormal, Spread::fisher};

Spread read_spread(const Field& field) {
  return spreads[field.choice({"normal", "uniform", "exponential", "lognormal", "fisher"})];
}

RandomQuantity read_random(const Field& field, Dimension dimension) {
  RandomQuantity quantity;
  if (!field.is_object()) {
    quantity.mean = field.quantity(dimension);
    return quantity;
  }
  quantity.mean = field.at("mean").quantity(dimension);
  quantity.spread = value_or(field, "distribution", Spread::normal, read_spread);
  const bool has_deviation = quantity.spread != Spread::exponential && quantity.spread != Spread::fisher;
  if (has_deviation) quantity.deviation = field.at("deviation").not_negative(dimension);
  if (quantity.spread == Spread::fisher)
    quantity.concentration = field.at("concentration").not_negative(Dimension::dimensionless);
  return quantity;
}

RandomQuantity read_positive_random(const Field& field, Dimension dimension) {
  const RandomQuantity quantity = read_random(field, dimension);
  const Field mean = field.is_object() ? field.at("mean") : field;
  if (!(quantity.mean > 0)) mean.fail(fmt::format("a {} above 0", to_string(dimension)));
  if (quantity.spread == Spread::fisher)
    field.at("distribution").fail("a distribution of lengths; fisher is one of angles");
  return quantity;
}

RandomQuantity scaled(RandomQuantity quantity, double factor) {
  quantity.mean *= factor;
  quantity.deviation *= factor;
  return quantity;
}

void read_traces(const Field& field, JointSet& set) {
  const auto length = field.find("trace_length");
  const auto persistence = field.find("persistence");
  const auto bridge = field.find("bridge");
  if (!length) {
    if (persistence) persistence->fail("together with a trace_length");
    if (bridge) bridge->fail("together with a trace_length");
    return;
  }
  set.length = read_positive_random(*length, Dimension::length);
  if (bridge && persistence) persistence->fail("either persistence or bridge, not both");
  if (bridge) set.bridge = read_positive_random(*bridge, Dimension::length);
  if (!persistence) return;
  const double share = persistence->within(0, 1);
  if (share == 0) persistence->fail("a share above 0");
  set.bridge = scaled(*set.length, 1 / share - 1);
}

JointSet read_joint_set(const Field& field, std::size_t number, const Model& model) {
  JointSet set;
  set.origin = field.path();
  set.name = value_or(field, "name", fmt::format("set {}", number), [](const Field& f) { return f.name(); });
  set.joint = model.joints[static_cast<std::size_t>(read_joint_reference(field.at("joint"), model))].name;
  set.dip = read_random(field.at("dip"), Dimension::angle);
  set.spacing = read_positive_random(field.at("spacing"), Dimension::length);
  read_traces(field, set);
  if (const auto start = field.find("start")) set.start = start->vector(Dimension::length);
  if (const auto region = field.find("region")) {
    set.region = read_ring(*region);
    if (const auto why = defect({set.region, {}})) region->fail(*why, "a closed line that does not meet itself");
  }
  if (const auto ends = field.find("ends_at")) {
    for (const Field& name : ends->items()) set.ends_at.push_back(name.text());
  }
  return set;
}

}  // namespace

std::vector<JointSet> read_joint_sets(const Field& sets, const Model& model) {
  std::vector<JointSet> read;
  for (const Field& set : sets.items()) read.push_back(read_joint_set(set, read.size() + 1, model));
  return read;
}

}  // namespace dda
