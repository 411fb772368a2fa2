#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "engine/core/error.h"
#include "engine/scene/places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

const std::vector<std::string>& quantity_names() {  // in the order of Quantity
  static const std::vector<std::string> names = {"stress_xx",      "stress_yy",  "stress_xy",       "displacement_x",
                                                 "displacement_y", "velocity_x", "velocity_y",      "acceleration_x",
                                                 "acceleration_y", "rotation",   "traction_normal", "traction_shear",
                                                 "bolt_force",     "bolt_shear", "bolt_elongation"};
  return names;
}

bool is_traction(Quantity quantity) {
  return quantity == Quantity::traction_normal || quantity == Quantity::traction_shear;
}

// Ways from a point into the block meant: straight to that side, leaning up first where two blocks lie there.
std::vector<Vec2> directions_to(const std::string& side) {
  if (side == "right") return {{1, 0.1}, {1, -0.1}, {1, 0}};
  if (side == "left") return {{-1, 0.1}, {-1, -0.1}, {-1, 0}};
  if (side == "above") return {{0.1, 1}, {-0.1, 1}, {0, 1}};
  if (side == "below") return {{0.1, -1}, {-0.1, -1}, {0, -1}};
  return {{1, 1}, {1, 0}, {0, 1}, {1, -1}, {-1, 1}, {-1, 0}, {0, -1}, {-1, -1}};
}

int block_on_side(const Field& field, const PlacedPoint& at, const std::vector<int>& blocks, const GroundPlan& plan,
                  const Model& model) {
  const std::string side = value_or(field, "side", std::string(), [](const Field& f) { return f.text(); });
  if (const auto block = plan.block_towards(blocks, at.point, directions_to(side))) return *block;
  if (side.empty()) return blocks.front();
  field.at("side").fail(fmt::format("a side of the point on which one of its blocks lies: {}", listed(blocks, model)));
}

void place_at_centroid(const Field& field, const GroundPlan& plan, const Model& model, Measurement& measurement) {
  measurement.block = plan.names().choice(field.at("block"));
  measurement.point = model.blocks[static_cast<std::size_t>(measurement.block)].moments.centroid;
}

void place_in_block(const Field& field, const GroundPlan& plan, const Model& model, Measurement& measurement) {
  if (!field.has("point") && field.has("block")) {
    place_at_centroid(field, plan, model, measurement);
    return;
  }
  measurement.point = field.at("point").vector(Dimension::length);
  const std::vector<int> blocks = plan.blocks_at(measurement.point);
  const bool on_a_joint = blocks.size() > 1 && !field.has("block");
  measurement.block = on_a_joint ? block_on_side(field, {0, measurement.point}, blocks, plan, model)
                                 : read_point(field, plan, model).block;
}

void place_on_joint(const Field& field, const GroundPlan& plan, const Model& model, Measurement& measurement) {
  for (const char* key : {"block", "side"}) {
    if (const auto given = field.find(key)) given->fail("to be left out for a traction, which two blocks share");
  }
  const Field point = field.at("point");
  measurement.point = point.vector(Dimension::length);
  const std::vector<int> blocks = plan.blocks_at(measurement.point);
  if (blocks.size() != 2) {
    point.fail(fmt::format("a point on the joint between two blocks (at this one: {})",
                           blocks.empty() ? "none" : listed(blocks, model)));
  }
  measurement.block = blocks[0];
  measurement.other_block = blocks[1];
}

// The link nearest to the point, where one is given.
void place_on_bolt(const Field& field, const Names& bolts, const Model& model, Measurement& measurement) {
  refuse(field, {"block", "side"}, "for a bolt");
  if (model.bolts.empty()) field.at("bolt").fail("the name of a bolt, of which there is none");
  measurement.bolt = bolts.choice(field.at("bolt"));
  const auto point = field.find("point");
  if (!point) return;
  measurement.point = point->vector(Dimension::length);
  const std::vector<BoltLink>& links = model.bolts[static_cast<std::size_t>(measurement.bolt)].links;
  const auto away = [&](const BoltLink& link) {
    return distance(Segment{link.point_a, link.point_b}, measurement.point);
  };
  const auto nearest = std::min_element(links.begin(), links.end(),
                                        [&](const BoltLink& a, const BoltLink& b) { return away(a) < away(b); });
  measurement.link = static_cast<int>(nearest - links.begin());
}

// What measurements are called: by their names, and those without by the quantity, counted where it is taken.
class MeasurementNames {
 public:
  std::string read(const Field& field) {
    const auto name = field.find("name");
    if (!name) return free_name(field.at("quantity").text());
    std::string given = name->name();
    if (given == "time") name->fail("another name: the first column of the histories is called that");
    if (!taken_.insert(given).second) name->fail("a name that no other measurement has");
    return given;
  }

 private:
  std::string free_name(const std::string& quantity) {
    int& last = last_number_[quantity];
    while (true) {
      std::string name = ++last == 1 ? quantity : fmt::format("{}_{}", quantity, last);
      if (taken_.insert(name).second) return name;
    }
  }

  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> last_number_;  // tried for each quantity: lower ones stay taken
};

void read_measurement(const Field& field, const GroundPlan& plan, const Names& bolts, MeasurementNames& names,
                      Model& model) {
  Measurement measurement;
  measurement.quantity = static_cast<Quantity>(field.at("quantity").choice(quantity_names()));
  measurement.name = names.read(field);
  const bool of_bolt = measurement.quantity == Quantity::bolt_force || measurement.quantity == Quantity::bolt_shear ||
                       measurement.quantity == Quantity::bolt_elongation;
  if (!of_bolt) refuse(field, {"bolt"}, "for a quantity that is not of a bolt");
  if (of_bolt) {
    place_on_bolt(field, bolts, model, measurement);
  } else if (is_traction(measurement.quantity)) {
    place_on_joint(field, plan, model, measurement);
  } else {
    place_in_block(field, plan, model, measurement);
  }
  model.measurements.push_back(std::move(measurement));
}

}  // namespace

void read_measurements(const Field& scene, const GroundPlan& plan, Model& model) {
  const auto measurements = scene.find("measurements");
  if (!measurements) return;
  const Names bolts(model.bolts);
  MeasurementNames names;
  for (const Field& measurement : measurements->items()) read_measurement(measurement, plan, bolts, names, model);
}

}  // namespace dda
