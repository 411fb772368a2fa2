#include <fmt/format.h>

#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "engine/model/quantity_names.h"
#include "engine/scene/measured_places.h"
#include "engine/scene/sections.h"

namespace dda {
namespace {

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const QuantityFacts& quantity : all_quantities) names.emplace_back(quantity.name);
  return names;
}

// What measurements are called: by their names, and those without by the quantity, counted where it is taken. No two
// histories have the same name.
class MeasurementNames {
 public:
  std::string read(const Field& field, Quantity quantity) {
    const auto name = field.find("name");
    if (!name) return free_name(quantity);
    std::string given = name->name();
    if (given == "time") name->fail("another name: the first column of the histories is called that");
    if (!take(given, quantity)) name->fail("a name that no other measurement has");
    return given;
  }

 private:
  std::string free_name(Quantity quantity) {
    const std::string first(to_string(quantity));
    int& last = last_number_[first];
    while (true) {
      std::string name = ++last == 1 ? first : fmt::format("{}_{}", first, last);
      if (take(name, quantity)) return name;
    }
  }

  // False when one of the histories has the name of another.
  bool take(const std::string& name, Quantity quantity) {
    for (const HistoryFacts& history : histories_of(quantity))
      if (!taken_.insert(name + std::string(history.suffix)).second) return false;
    return true;
  }

  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, int> last_number_;  // tried for each quantity: lower ones stay taken
};

}  // namespace

void read_measurements(const Field& scene, const GroundPlan& plan, const std::vector<std::string>& groups,
                       Model& model) {
  const auto measurements = scene.find("measurements");
  if (!measurements) return;
  const std::vector<std::string> quantities = quantity_names();
  const BlockSets sets(model, groups);
  const MeasuredPlaces places(plan, sets, model);
  MeasurementNames names;
  for (const Field& field : measurements->items()) {
    Measurement measurement;
    measurement.quantity = static_cast<Quantity>(field.at("quantity").choice(quantities));
    measurement.name = names.read(field, measurement.quantity);
    places.read(field, measurement);
    model.measurements.push_back(std::move(measurement));
  }
}

}  // namespace dda
