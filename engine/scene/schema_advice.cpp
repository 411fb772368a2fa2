#include "engine/scene/schema_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/json_path.h"
#include "engine/scene/nearest_word.h"

namespace dda {
namespace {

using nlohmann::json;
using Rules = std::vector<const json*>;  // the schema objects that apply to one node together

const json& resolved(const json& schema, const json& rule) {
  const json* current = &rule;
  while (current->contains("$ref")) {
    current = &schema.at(json::json_pointer(current->at("$ref").get<std::string>().substr(1)));
  }
  return *current;
}

// `rule`, what it refers to and what its allOf lists.
void collect(const json& schema, const json& rule, Rules& rules) {
  const json& own = resolved(schema, rule);
  rules.push_back(&own);
  if (!own.contains("allOf")) return;
  for (const json& part : own["allOf"]) collect(schema, part, rules);
}

Rules rules_of_child(const json& schema, const Rules& parents, const json& parent_value, const std::string& step) {
  Rules rules;
  for (const json* parent : parents) {
    if (parent_value.is_array()) {
      if (parent->contains("items")) collect(schema, (*parent)["items"], rules);
    } else if (parent->contains("properties") && (*parent)["properties"].contains(step)) {
      collect(schema, (*parent)["properties"][step], rules);
    } else if (parent->contains("additionalProperties") && (*parent)["additionalProperties"].is_object()) {
      collect(schema, (*parent)["additionalProperties"], rules);
    }
  }
  return rules;
}

struct Node {
  std::string path;
  const json* value;
  Rules rules;
};

// Walks from the root to `place`.
Node find_node(const json& schema, const json& scene, json::json_pointer place) {
  std::vector<std::string> steps;
  for (; !place.empty(); place.pop_back()) steps.push_back(place.back());
  std::reverse(steps.begin(), steps.end());
  Node node{"", &scene, {}};
  collect(schema, schema, node.rules);
  for (const std::string& step : steps) {
    Rules rules = rules_of_child(schema, node.rules, *node.value, step);
    const bool in_array = node.value->is_array();
    node = {in_array ? item_path(node.path, std::stoul(step)) : member_path(node.path, step),
            in_array ? &node.value->at(std::stoul(step)) : &node.value->at(step), std::move(rules)};
  }
  return node;
}

std::string path_or_root(const Node& node) { return node.path.empty() ? "the scene" : node.path; }

std::vector<std::string> known_keys(const Node& node) {
  std::vector<std::string> keys;
  for (const json* rule : node.rules) {
    if (!rule->contains("properties")) continue;
    for (const auto& [key, unused] : (*rule)["properties"].items()) keys.push_back(key);
  }
  return keys;
}

std::string joined(const std::vector<std::string>& words, std::string_view last_separator) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? last_separator : ", ";
    list += words[i];
  }
  return list;
}

// What is wanted in words of the schema: the description nearest to the node.
std::string description(const Node& node) {
  for (const json* rule : node.rules) {
    if (rule->contains("description")) return (*rule)["description"].get<std::string>();
  }
  return "";
}

std::string with_description(const std::string& expected, const Node& node) {
  const std::string words = description(node);
  return words.empty() || words == expected ? expected : fmt::format("{} ({})", expected, words);
}

using Advice = std::optional<InputError>;

Advice unknown_key(const Node& node) {
  const bool closed = std::any_of(node.rules.begin(), node.rules.end(), [](const json* rule) {
    return rule->contains("additionalProperties") && (*rule)["additionalProperties"] == false;
  });
  if (!closed || !node.value->is_object()) return {};
  const std::vector<std::string> known = known_keys(node);
  for (const auto& [key, unused] : node.value->items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string meant = nearest_word(key, known);
    return InputError(
        "", member_path(node.path, key), "no key of the format",
        meant.empty() ? "one of " + joined(known, " or ") : fmt::format("a known key, perhaps \"{}\"", meant));
  }
  return {};
}

Advice missing_key(const json& schema, const Node& node, const json& rule) {
  if (!rule.contains("required") || !node.value->is_object()) return {};
  for (const json& key : rule["required"]) {
    const auto name = key.get<std::string>();
    if (node.value->contains(name)) continue;
    const Node missing{member_path(node.path, name), nullptr, rules_of_child(schema, node.rules, *node.value, name)};
    return InputError("", missing.path, "missing", description(missing));
  }
  return {};
}

// oneOf is used in the schema only as "exactly one of these keys".
Advice not_one_key(const Node& node, const json& rule) {
  if (!rule.contains("oneOf") || !node.value->is_object()) return {};
  std::vector<std::string> keys;
  for (const json& branch : rule["oneOf"]) keys.push_back(branch["required"][0].get<std::string>());
  const auto given =
      std::count_if(keys.begin(), keys.end(), [&](const auto& key) { return node.value->contains(key); });
  if (given == 1) return {};
  return InputError("", path_or_root(node), fmt::format("given with {} of {}", given, joined(keys, " and ")),
                    "exactly one of them");
}

bool is_type(const json& value, const std::string& type) {
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  return (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
         (type == "array" && value.is_array()) || (type == "object" && value.is_object());
}

std::string type_in_words(const std::string& type) {
  if (type == "string") return "text";
  if (type == "boolean") return "true or false";
  return type == "integer" ? "a whole number" : type == "number" ? "a number" : "an " + type;
}

Advice wrong_type(const Node& node, const json& rule) {
  if (!rule.contains("type")) return {};
  const json types = rule["type"].is_array() ? rule["type"] : json::array({rule["type"]});
  std::vector<std::string> words;
  for (const json& type : types) {
    if (is_type(*node.value, type.get<std::string>())) return {};
    words.push_back(type_in_words(type.get<std::string>()));
  }
  return InputError("", path_or_root(node), shown_value(*node.value), with_description(joined(words, " or "), node));
}

Advice wrong_word(const Node& node, const json& rule) {
  const json& value = *node.value;
  if (rule.contains("const") && value != rule["const"]) {
    return InputError("", path_or_root(node), shown_value(value), with_description(rule["const"].dump(), node));
  }
  if (!rule.contains("enum")) return {};
  std::vector<std::string> words;
  for (const json& word : rule["enum"]) {
    if (word == value) return {};
    words.push_back(word.get<std::string>());
  }
  const std::string meant = value.is_string() ? nearest_word(value.get_ref<const std::string&>(), words) : "";
  const std::string hint = meant.empty() ? "" : fmt::format(", perhaps \"{}\"", meant);
  return InputError("", path_or_root(node), shown_value(value), joined(words, " or ") + hint);
}

std::string bound(const json& rule, const char* key, const char* before, const char* behind) {
  return rule.contains(key) ? before + rule[key].dump() + behind : "";
}

// The numbers that a rule allows, in words; empty where it has no bounds.
std::string allowed_numbers(const json& rule) {
  const std::string least =
      bound(rule, "exclusiveMinimum", "a number above ", "") + bound(rule, "minimum", "", " or more");
  const std::string most = bound(rule, "exclusiveMaximum", "below ", "") + bound(rule, "maximum", "at most ", "");
  if (least.empty() || most.empty()) return least + most;
  return least + " and " + most;
}

Advice wrong_number(const Node& node, const json& rule) {
  if (!node.value->is_number()) return {};
  const double value = node.value->get<double>();
  const bool is_allowed = !(rule.contains("exclusiveMinimum") && !(value > rule["exclusiveMinimum"])) &&
                          !(rule.contains("minimum") && value < rule["minimum"]) &&
                          !(rule.contains("exclusiveMaximum") && !(value < rule["exclusiveMaximum"])) &&
                          !(rule.contains("maximum") && value > rule["maximum"]);
  if (is_allowed) return {};
  return InputError("", path_or_root(node), shown_value(*node.value), with_description(allowed_numbers(rule), node));
}

struct Count {
  const char* least;
  const char* most;
  std::size_t size;
  const char* thing;
};

std::optional<Count> count_of(const json& value) {
  if (value.is_array()) return Count{"minItems", "maxItems", value.size(), "item"};
  if (value.is_object()) return Count{"minProperties", "maxProperties", value.size(), "key"};
  if (value.is_string())
    return Count{"minLength", "maxLength", value.get_ref<const std::string&>().size(), "character"};
  return {};
}

Advice wrong_count(const Node& node, const json& rule) {
  const auto count = count_of(*node.value);
  if (!count) return {};
  const std::size_t least = rule.value(count->least, std::size_t{0});
  const std::size_t most = rule.value(count->most, count->size);
  if (count->size >= least && count->size <= most) return {};
  const std::size_t wanted = count->size < least ? least : most;
  const char* how = least == most ? "exactly" : count->size < least ? "at least" : "at most";
  return InputError(
      "", path_or_root(node), shown_value(*node.value),
      with_description(fmt::format("{} {} {}{}", how, wanted, count->thing, wanted == 1 ? "" : "s"), node));
}

// The rules in the order in which their advice helps most.
Advice first_advice(const json& schema, const Node& node) {
  for (const json* rule : node.rules) {
    if (Advice advice = wrong_type(node, *rule)) return advice;
  }
  if (Advice advice = unknown_key(node)) return advice;
  for (const json* rule : node.rules) {
    if (Advice advice = missing_key(schema, node, *rule)) return advice;
    for (const auto check : {not_one_key, wrong_word, wrong_number, wrong_count}) {
      if (Advice advice = check(node, *rule)) return advice;
    }
  }
  return {};
}

}  // namespace

InputError schema_violation(const json& schema, const json& scene, const std::string& place) {
  const Node node = find_node(schema, scene, json::json_pointer(place));
  const Advice advice = first_advice(schema, node);
  if (advice) return *advice;
  const std::string words = description(node);
  return {"", path_or_root(node), shown_value(*node.value), words.empty() ? "what the format allows there" : words};
}

}  // namespace dda
