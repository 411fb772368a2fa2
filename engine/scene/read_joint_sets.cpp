#include "engine/scene/read_joint_sets.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "engine/scene/block_group.h"
#include "engine/scene/places.h"
#include "engine/scene/rock_values.h"

namespace dda {
namespace {

constexpr Spread spreads[] = {Spread::normal, Spread::uniform, Spread::exponential, Spread::lognormal, Spread::fisher};

Spread read_spread(const Field& field) {
  return spreads[field.choice({"normal", "uniform", "exponential", "lognormal", "fisher"})];
}

// `read` gives what a mean and a deviation may be.
template <typename Read>
RandomQuantity read_random(const Field& field, Read read) {
  RandomQuantity quantity;
  if (!field.is_object()) {
    quantity.mean = read(field);
    return quantity;
  }
  quantity.mean = read(field.at("mean"));
  quantity.spread = value_or(field, "distribution", Spread::normal, read_spread);
  const bool has_deviation = quantity.spread != Spread::exponential && quantity.spread != Spread::fisher;
  if (has_deviation) {
    quantity.deviation = read(field.at("deviation"));
    if (quantity.deviation < 0) field.at("deviation").fail("zero or more");
  }
  if (quantity.spread == Spread::fisher)
    quantity.concentration = field.at("concentration").not_negative(Dimension::dimensionless);
  return quantity;
}

// The mean of what is left of a normal or uniform distribution where only values above 0 count.
double mean_above_zero(const RandomQuantity& quantity) {
  if (quantity.spread == Spread::uniform) return (quantity.mean + quantity.deviation) / 2;
  const double share = quantity.mean / quantity.deviation;
  const double density = std::exp(-share * share / 2) / std::sqrt(2 * std::numbers::pi);
  return quantity.mean + quantity.deviation * density / (std::erfc(-share / std::numbers::sqrt2) / 2);
}

// Draws of 0 and less are drawn anew, which of such a spread leaves nothing like its mean.
void refuse_wide_spread(const Field& field, const RandomQuantity& quantity) {
  const bool is_cut_off = quantity.spread == Spread::normal || quantity.spread == Spread::uniform;
  if (!is_cut_off || quantity.deviation <= quantity.mean) return;
  field.at("deviation")
      .fail(fmt::format("at most the mean: what is drawn and not above 0 is drawn again, so that the mean would be "
                        "{:.3g} in place of {:.3g}; \"lognormal\" keeps its mean",
                        mean_above_zero(quantity), quantity.mean));
}

RandomQuantity read_positive_random(const Field& field, Dimension dimension) {
  const RandomQuantity quantity = read_random(field, [&](const Field& f) { return f.quantity(dimension); });
  const Field mean = field.is_object() ? field.at("mean") : field;
  if (!(quantity.mean > 0)) mean.fail(fmt::format("a {} above 0", to_string(dimension)));
  if (quantity.spread == Spread::fisher)
    field.at("distribution").fail("a distribution of lengths; fisher is one of angles");
  refuse_wide_spread(field, quantity);
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
  set.dip = read_random(field.at("dip"), read_direction);
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
