#include "engine/scene/record_files.h"

#include <fmt/format.h>

#include "engine/scene/record_file.h"

namespace dda {
namespace {

std::string text_or_nothing(const Field& field, const char* key) {
  return value_or(field, key, std::string(), [](const Field& f) { return f.text(); });
}

std::string unit_or_nothing(const Field& field, const char* key, Dimension dimension) {
  std::string symbol = text_or_nothing(field, key);
  for (const Unit& unit : units(dimension))
    if (symbol == unit.symbol) return symbol;
  field.at(key).fail(expected_quantity(dimension));
}

// Or "-", for values that are plain factors whatever the header says: a velocity times an impedance is a traction.
std::string unit_of_values(const Field& field, Dimension dimension) {
  if (text_or_nothing(field, "unit") == no_unit) return no_unit;
  return unit_or_nothing(field, "unit", dimension);
}

RecordRequest read_request(const Field& field, Dimension dimension, const std::filesystem::path& folder) {
  RecordRequest request;
  request.file = folder / field.at("file").text();
  request.time = text_or_nothing(field, "time");
  request.value = text_or_nothing(field, "value");
  request.dimension = dimension;
  if (field.has("time_unit")) request.time_unit = unit_or_nothing(field, "time_unit", Dimension::time);
  if (field.has("unit")) request.value_unit = unit_of_values(field, dimension);
  request.scale = value_or(field, "scale", 1.0, [](const Field& f) { return f.quantity(Dimension::dimensionless); });
  if (const auto correct = field.find("baseline_correction")) {
    request.correct_baseline = correct->truth();
    if (request.correct_baseline && dimension != Dimension::acceleration)
      correct->fail("false where the record is no acceleration");
  }
  return request;
}

std::string key_of(const RecordRequest& request) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", request.file.string(), request.time, request.value,
                     request.time_unit, request.value_unit, static_cast<int>(request.dimension), request.scale,
                     request.correct_baseline, request.acts_from);
}

}  // namespace

Recorded RecordFiles::read(const Field& field, Dimension dimension) {
  RecordRequest request = read_request(field, dimension, folder_);
  const double start = value_or(field, "start", 0.0, [](const Field& f) { return f.quantity(Dimension::time); });
  if (request.correct_baseline) request.acts_from = -start;
  std::shared_ptr<const Recording>& recording = known_[key_of(request)];
  if (!recording) recording = std::make_shared<const Recording>(read_record(request, field.path() + ".file"));
  return {recording, start};
}

}  // namespace dda
