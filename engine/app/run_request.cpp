#include "engine/app/run_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/atomic_file.h"
#include "engine/record/run_folder.h"
#include "engine/scene/json_path.h"
#include "engine/scene/json_text.h"

namespace dda {
namespace {

using Json = nlohmann::json;

constexpr auto for_resume = "what dda run writes; begin anew without --resume";

struct Difference {
  std::string field;
  std::string then;
  std::string now;
};

// The first member or item that differs; the whole value where there is no such, for instance of numbers.
std::optional<Difference> first_difference(const Json& then, const Json& now, const std::string& field);

std::optional<Difference> first_member(const Json& then, const Json& now, const std::string& field) {
  Json all = then;
  all.update(now);
  for (const auto& [key, value] : all.items()) {
    const std::string path = member_path(field, key);
    if (!then.contains(key)) return Difference{path, "missing", shown_value(value)};
    if (!now.contains(key)) return Difference{path, shown_value(value), "missing"};
    if (auto difference = first_difference(then[key], now[key], path)) return difference;
  }
  return std::nullopt;
}

std::optional<Difference> first_item(const Json& then, const Json& now, const std::string& field) {
  for (std::size_t i = 0; i < std::max(then.size(), now.size()); ++i) {
    const std::string path = item_path(field, i);
    if (i >= then.size()) return Difference{path, "missing", shown_value(now[i])};
    if (i >= now.size()) return Difference{path, shown_value(then[i]), "missing"};
    if (auto difference = first_difference(then[i], now[i], path)) return difference;
  }
  return std::nullopt;
}

std::optional<Difference> first_difference(const Json& then, const Json& now, const std::string& field) {
  if (then == now) return std::nullopt;
  if (then.is_object() && now.is_object()) return first_member(then, now, field);
  if (then.is_array() && now.is_array()) return first_item(then, now, field);
  return Difference{field, shown_value(then), shown_value(now)};
}

}  // namespace

std::string this_program() { return "dda " DDA_VERSION; }

Json read_request(const std::filesystem::path& folder, const std::string& expected) {
  const std::filesystem::path path = folder / request_name;
  const auto refuse = [&](const std::string& value) {
    throw InputError(path.string(), "what the run was asked for", value, expected);
  };
  Json request;
  try {
    request = Json::parse(read_file(path), nullptr, false);
  } catch (const UnreadableFile& error) {
    refuse(error.why());
  }
  for (const char* part : {"program", "options", "scene"})
    if (!request.is_object() || !request.contains(part)) refuse("damaged");
  return request;
}

Json run_request(const RunOptions& options, std::string_view scene_text, std::size_t stages_done) {
  const auto given = [](const auto& value) { return value ? Json(*value) : Json("not given"); };
  return {{"program", this_program()},
          {"options",
           {{"--every", options.rows_every},
            {"--frames", given(options.frames)},
            {"--frame-interval", given(options.frame_interval)},
            {"--from", given(options.from)}}},
          {"stages_before", stages_done},
          {"scene", parse_json(scene_text)}};
}

std::size_t stages_before(const std::filesystem::path& folder) {
  return read_request(folder, for_resume).value("stages_before", std::size_t{0});
}

void write_request(const std::filesystem::path& folder, const Json& request) {
  write_file(folder / request_name, request.dump(1, ' ', false, Json::error_handler_t::replace) + '\n');
}

void expect_same_request(const RunOptions& options, const Json& request) {
  const Json then = read_request(options.folder, for_resume);
  const auto compare = [&](const std::string& file, const Json& before, const Json& now, const std::string& field) {
    if (const auto difference = first_difference(before, now, field))
      throw InputError(file, difference->field, difference->now,
                       fmt::format("{}, with which the run in {} began", difference->then, options.folder.string()));
  };
  compare("", then["program"], request["program"], "the program");
  for (const auto& [name, value] : request["options"].items())
    compare("", then["options"].value(name, Json("unknown")), value, name);
  compare(options.scene.string(), then["scene"], request["scene"], "");
}

}  // namespace dda
