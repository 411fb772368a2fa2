#include "engine/scene/schema_check.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

#include "engine/core/parallel.h"
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

bool follows_schema(const json& scene) {
  return valijson::Validator(valijson::Validator::kStrongTypes).validate(schema().compiled, Adapter(scene), nullptr);
}

const json::json_pointer& place_of_lines() {
  static const json::json_pointer place("/blocks/rock/lines");
  return place;
}

// Nothing is known of the scene yet.
bool has_many_lines(const json& scene) {
  constexpr std::size_t many = 10'000;
  if (!scene.contains(place_of_lines())) return false;
  const json& lines = scene[place_of_lines()];
  return lines.is_array() && lines.size() >= many;
}

// Scenes with a part of the lines each and all else: where these follow the schema, the whole does.
class Parts {
 public:
  explicit Parts(json& scene) : lines_(scene[place_of_lines()]), scenes_(parts) {
    json::array_t all = std::exchange(lines_, json::array()).get_ref<json::array_t&>();
    for (json& each : scenes_) each = scene;
    size_ = all.size();
    for (std::size_t i = 0; i < size_; ++i) lines_of(i * parts / size_).push_back(std::move(all[i]));
  }

  [[nodiscard]] bool follow_schema() const {
    std::array<bool, parts> follows{};
    parallel_for_each(parts, 1, [&](std::size_t i) { follows[i] = follows_schema(scenes_[i]); });
    return std::ranges::all_of(follows, [](bool each) { return each; });
  }

  void put_back() {
    lines_.get_ref<json::array_t&>().reserve(size_);
    for (std::size_t i = 0; i < parts; ++i)
      for (json& line : lines_of(i)) lines_.push_back(std::move(line));
  }

 private:
  static constexpr std::size_t parts = 8;
  [[nodiscard]] json::array_t& lines_of(std::size_t i) {
    return scenes_[i][place_of_lines()].get_ref<json::array_t&>();
  }

  json& lines_;
  std::vector<json> scenes_;
  std::size_t size_ = 0;
};

}  // namespace

void check_schema(const json& scene) {
  if (follows_schema(scene)) return;
  throw schema_violation(schema().text, scene, place_of(scene, deepest_error(scene)).to_string());
}

void check_schema_of_many(json& scene) {
  if (!has_many_lines(scene)) {
    check_schema(scene);
    return;
  }
  schema();  // made once, before threads ask for it
  Parts parts(scene);
  const bool all_follow = parts.follow_schema();
  parts.put_back();
  if (!all_follow) check_schema(scene);
}

}  // namespace dda
