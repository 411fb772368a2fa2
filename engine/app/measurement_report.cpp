#include "engine/app/measurement_report.h"

#include <fmt/format.h>

#include <cstddef>

#include "engine/model/quantity_names.h"

namespace dda {
namespace {

const std::string& name_of(const Model& model, int block) { return model.blocks[static_cast<std::size_t>(block)].name; }

std::string blocks(std::size_t number) { return fmt::format("{} block{}", number, number == 1 ? "" : "s"); }

std::string point(const Vec2& at) { return fmt::format("[{:.6g}, {:.6g}]", at.x(), at.y()); }

std::string line_of(const Measurement& measurement) {
  return fmt::format("from {} to {}", point(measurement.from), point(measurement.to));
}

std::string place_of_block(const Model& model, const Measurement& measurement) {
  if (!measurement.blocks.empty()) return "of " + blocks(measurement.blocks.size());
  return fmt::format("at {}, block \"{}\"", point(measurement.point), name_of(model, measurement.block));
}

std::string place_of_bolt(const Model& model, const Measurement& measurement) {
  const Bolt& bolt = model.bolts[static_cast<std::size_t>(measurement.bolt)];
  if (measurement.link < 0) return fmt::format("of \"{}\"", bolt.name);
  const BoltLink& link = bolt.links[static_cast<std::size_t>(measurement.link)];
  return fmt::format("of \"{}\" between \"{}\" and \"{}\"", bolt.name, name_of(model, link.block_a),
                     name_of(model, link.block_b));
}

std::string place_of_lining(const Model& model, const Measurement& measurement) {
  const Lining& lining = model.linings[static_cast<std::size_t>(measurement.lining)];
  if (measurement.element < 0) return fmt::format("of \"{}\", where it is largest", lining.name);
  const auto element = static_cast<std::size_t>(measurement.element);
  return fmt::format("of \"{}\" between \"{}\" and \"{}\"", lining.name, name_of(model, lining.start_of(element).block),
                     name_of(model, lining.end_of(element).block));
}

std::string place_of_excess_shear(const Model& model, const Measurement& measurement) {
  std::string text =
      measurement.joint < 0
          ? "of all joints"
          : fmt::format("of joint \"{}\"", model.joints[static_cast<std::size_t>(measurement.joint)].name);
  if (measurement.on_line) text += ", " + line_of(measurement);
  if (measurement.friction_angle || measurement.cohesion)
    text += fmt::format(", beyond {:g} Pa and a friction of tan {:.4g} rad", measurement.cohesion.value_or(0),
                        measurement.friction_angle.value_or(0));
  return text;
}

std::string place_of(const Model& model, const Measurement& measurement) {
  switch (subject_of(measurement.quantity)) {
    case Subject::block:
    case Subject::joint: return place_of_block(model, measurement);
    case Subject::bolt: return place_of_bolt(model, measurement);
    case Subject::lining: return place_of_lining(model, measurement);
    case Subject::reaction:
      return fmt::format("of {} point support{} and {} held as a whole, moment about {}", measurement.supports.size(),
                         measurement.supports.size() == 1 ? "" : "s", blocks(measurement.blocks.size()),
                         point(measurement.about));
    case Subject::contact_force:
      return fmt::format("on {} by {}{}", blocks(measurement.blocks.size()), measurement.others.size(),
                         measurement.on_line ? ", " + line_of(measurement) : "");
    case Subject::resultant:
      return fmt::format("on the left of the line {} by its right, moment about {}", line_of(measurement),
                         point(measurement.about));
    case Subject::excess_shear: return place_of_excess_shear(model, measurement);
    case Subject::contacts: return "of the whole scene";
  }
  return "";
}

// Names every history that the measurement has, with its unit.
std::string units_of(const Measurement& measurement) {
  std::string units;
  for (const HistoryFacts& history : histories_of(measurement.quantity))
    units += fmt::format("{}{} [{}]", units.empty() ? "" : ", ", measurement.name + std::string(history.suffix),
                         history.unit);
  return units;
}

}  // namespace

std::string describe(const Model& model, const Measurement& measurement) {
  return fmt::format("{}: {} {}", units_of(measurement), to_string(measurement.quantity), place_of(model, measurement));
}

}  // namespace dda
