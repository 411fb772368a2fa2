#include "engine/app/branch_origin.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/app/run_position.h"
#include "engine/app/run_request.h"
#include "engine/core/error.h"
#include "engine/core/read_file.h"
#include "engine/record/run_folder.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

using Json = nlohmann::json;

Model scene_of(const std::filesystem::path& folder, const std::filesystem::path& files) {
  const Json request = read_request(folder, "what dda run writes, in the folder of a run");
  if (request["program"] != this_program())
    throw InputError((folder / request_name).string(), "program", request["program"].dump(),
                     fmt::format("\"{}\": run that scene again", this_program()));
  return parse_scene(request["scene"].dump(), (folder / request_name).string(), files);
}

std::size_t index_of(const std::string& stage, const Model& model) {
  if (stage.empty()) return model.stages.size() - 1;
  const auto found = std::ranges::find(model.stages, stage, &Stage::name);
  if (found != model.stages.end()) return static_cast<std::size_t>(found - model.stages.begin());
  std::vector<std::string> names;
  for (const Stage& each : model.stages) names.push_back('"' + each.name + '"');
  throw InputError("", "--from", "stage \"" + stage + "\"", fmt::format("one of {}", fmt::join(names, ", ")));
}

// The end of the last stage is the end of the run, which must have gone well.
void expect_done(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / summary_name;
  const Json summary = std::filesystem::exists(path) ? Json::parse(read_file(path), nullptr, false) : Json();
  const std::string status = summary.is_object() ? summary.value("status", "no status") : "no summary";
  if (status != "ok")
    throw InputError("", "--from", fmt::format("{}, whose run ended with: {}", folder.string(), status),
                     "a run that is done with status ok, or one of its earlier stages");
}

std::filesystem::path file_of(std::size_t stage, const Model& model, const std::filesystem::path& folder) {
  if (stage + 1 == model.stages.size()) {
    expect_done(folder);
    return folder / checkpoint_name;
  }
  std::filesystem::path file = folder / stage_file_name(stage);
  if (!std::filesystem::exists(file))
    throw InputError("", "--from",
                     fmt::format("stage \"{}\", of which {} has no end", model.stages[stage].name, folder.string()),
                     "a stage that the run has come to the end of");
  return file;
}

}  // namespace

BranchOrigin parse_origin(const std::string& from) {
  const std::size_t colon = from.rfind(':');
  BranchOrigin origin{from, ""};
  if (!std::filesystem::is_directory(from) && colon != std::string::npos)
    origin = {from.substr(0, colon), from.substr(colon + 1)};
  if (!std::filesystem::is_directory(origin.folder))
    throw InputError("", "--from", from, "the folder of a run, or DIR:STAGE");
  return origin;
}

Simulation load_origin(const BranchOrigin& origin, const std::filesystem::path& files) {
  const Model model = scene_of(origin.folder, files);
  const std::filesystem::path file = file_of(index_of(origin.stage, model), model, origin.folder);
  Simulation settled(model);
  load_run(file, settled);
  return settled;
}

}  // namespace dda
