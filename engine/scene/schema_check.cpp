#include "engine/scene/schema_check.h"

#include <nlohmann/json.hpp>
#include <string>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "engine/scene/scene_schema.h"
#include "engine/scene/schema_advice.h"

namespace dda {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;
using Context = std::vector<std::string>;

struct CompiledSchema {
  CompiledSchema() : text(json::parse(scene_schema())) {
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(text), compiled);
  }
  json text;
  valijson::Schema compiled;
};

const CompiledSchema& schema() {
  static const CompiledSchema instance;
  return instance;
}

// The validator writes steps as [3], [key] or ["key"].
std::string member_name(const json& object, const std::string& step) {
  const std::string bare = step.substr(1, step.size() - 2);
  const bool quoted = bare.size() >= 2 && bare.front() == '"' && bare.back() == '"';
  return quoted && !object.contains(bare) ? bare.substr(1, bare.size() - 2) : bare;
}

json::json_pointer place_of(const json& scene, const Context& context) {
  json::json_pointer place;
  const json* node = &scene;
  for (std::size_t i = 1; i < context.size(); ++i) {  // the first step is the root
    const std::string name =
        node->is_array() ? context[i].substr(1, context[i].size() - 2) : member_name(*node, context[i]);
    place /= name;
    if (!scene.contains(place)) return place.parent_pointer();
    node = &scene[place];
  }
  return place;
}

// The error deepest in the document says most; those above it only say that something below is wrong.
Context deepest_error(const json& scene) {
  valijson::ValidationResults results;
  valijson::Validator(valijson::Validator::kStrongTypes).validate(schema().compiled, Adapter(scene), &results);
  Context deepest;
  for (const auto& error : results) {
    if (error.context.size() > deepest.size()) deepest = error.context;
  }
  return deepest;
}

}  // namespace

void check_schema(const json& scene) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  if (validator.validate(schema().compiled, Adapter(scene), nullptr)) return;
  throw schema_violation(schema().text, scene, place_of(scene, deepest_error(scene)).to_string());
}

}  // namespace dda
