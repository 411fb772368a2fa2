#include "verification/suite/row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "verification/study/values.h"

namespace verify {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const dda::Counters& counters) {
  Json json = Json::object();
  add_counters(counters, json);
  return json;
}

Json to_json(const Row& row) {
  const Assertion& asserted = row.assertion;
  Json json;
  json["id"] = row.id;
  json["title"] = row.title;
  json["catalogue"] = row.catalogue;
  json["quantity"] = asserted.quantity;
  json["unit"] = asserted.unit;
  json["value"] = asserted.value;
  json["reference"] = asserted.reference;
  json["source"] = asserted.source;
  json["error"] = asserted.error;
  json["tolerance"] = asserted.tolerance;
  json["tolerance_reason"] = asserted.tolerance_reason;
  json["order"] = asserted.order ? Json(asserted.order->observed) : Json(nullptr);
  json["order_expected"] = asserted.order ? Json(asserted.order->expected) : Json(nullptr);
  json["passed"] = row.passed;
  json["cpu_s"] = row.cpu_s;
  json["counters"] = to_json(row.counters);
  return json;
}

// Null stands for what is not finite.
double number(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

Assertion assertion_from(const Json& json) {
  Assertion asserted;
  asserted.quantity = json.at("quantity");
  asserted.unit = json.at("unit");
  asserted.value = number(json, "value");
  asserted.reference = number(json, "reference");
  asserted.source = json.at("source");
  asserted.error = number(json, "error");
  asserted.tolerance = number(json, "tolerance");
  asserted.tolerance_reason = json.at("tolerance_reason");
  if (!json.at("order_expected").is_null()) asserted.order = Order{number(json, "order"), json.at("order_expected")};
  return asserted;
}

Row row_from(const Json& json) {
  Row row;
  row.id = json.at("id");
  row.title = json.at("title");
  row.catalogue = json.at("catalogue").get<std::vector<int>>();
  row.assertion = assertion_from(json);
  row.passed = json.at("passed");
  row.cpu_s = number(json, "cpu_s");
  for (const dda::CounterField& field : dda::counter_fields)
    row.counters.*field.value = json.at("counters").at(field.name);
  return row;
}

}  // namespace

std::string describe(const Row& row) {
  const Assertion& asserted = row.assertion;
  const std::string unit = asserted.unit.empty() ? "" : " " + asserted.unit;
  std::string text = fmt::format(
      "{} (catalogue {}), {}: value {:.12g}{}, reference {:.12g}{} ({}), error {:.3g}, tolerance {:.3g} ({})", row.id,
      fmt::join(row.catalogue, ", "), asserted.quantity, asserted.value, unit, asserted.reference, unit,
      asserted.source, asserted.error, asserted.tolerance, asserted.tolerance_reason);
  if (const auto& order = asserted.order)
    text +=
        fmt::format(", order {:.4g}, expected {:.4g} +- {:.2g}", order->observed, order->expected, order->tolerance);
  return text;
}

std::string to_json(const std::vector<Row>& rows) {
  Json json;
  json["cases"] = Json::array();
  for (const Row& row : rows) json["cases"].push_back(to_json(row));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Row> rows_from_json(const std::string& text, const std::string& file) {
  try {
    std::vector<Row> rows;
    const Json all = Json::parse(text);
    for (const Json& json : all.at("cases")) rows.push_back(row_from(json));
    return rows;
  } catch (const Json::exception& error) {
    throw dda::InputError(file, "the text", error.what(), "what `dda-verify run` writes");
  }
}

}  // namespace verify
