#include "engine/app/fos_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <ostream>
#include <string>
#include <utility>

#include "engine/app/fos_report.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/record/atomic_file.h"
#include "engine/record/reserved_folder.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

constexpr auto details =
    "Divides the strength of all joints by a factor until the rock no longer stands: friction (its tangent), cohesion\n"
    "and tensile strength. The scene is loaded statically while joints stick, then it must find an equilibrium with\n"
    "that strength. Its own steps are not run; loads and motions are those at the end of its static stages. DIR gets\n"
    "fos.json and fos.svg, a picture of what moves.\n\n"
    "Examples:\n"
    "  dda fos slope.json\n"
    "  dda fos slope.json --width 0.001 --out fos\n"
    "  dda fos slope.json --jobs 1                  one run after the other, as beside other work\n";

constexpr double least_width = 1e-6;
constexpr double most_width = 0.5;
constexpr double least_most = 1.1;
constexpr double most_most = 1e4;
constexpr int most_jobs = 1024;  // more than any machine has would only be a slip

void check_number(double value, double least, double most, const char* option) {
  if (!(value >= least && value <= most))  // nor is what is no number
    throw InputError("", option, fmt::format("{:g}", value), fmt::format("a number from {:g} to {:g}", least, most));
}

// Where its first stages are static, those bring on the loads; a scene without has those of its beginning.
double time_of_loads(const Model& model) {
  double time = 0;
  for (const Stage& stage : model.stages) {
    if (!stage.integrator.is_static) break;
    time += stage.duration;
  }
  return time;
}

int jobs_of(const FosRequest& request) {
  if (!request.jobs) return cores();
  if (*request.jobs < 1 || *request.jobs > most_jobs)
    throw InputError("", "--jobs", std::to_string(*request.jobs),
                     fmt::format("a whole number from 1 to {}", most_jobs));
  return *request.jobs;
}

SafetyQuestion question_of(const FosRequest& request, const Model& model) {
  check_number(request.most, least_most, most_most, "--most");
  check_number(request.width, least_width, most_width, "--width");
  return {time_of_loads(model), request.most, request.width, jobs_of(request)};
}

struct Answer {
  SafetyReport report, kept;
};

// Says of each run what came out.
std::function<void(const SafetyTrial&)> told(std::ostream& progress, const char* joints) {
  return [&progress, joints](const SafetyTrial& trial) {
    progress << fmt::format("strength over {:.4g}{}: {}\n", trial.factor, joints, trial.stands ? "stands" : "fails");
    progress.flush();
  };
}

Answer answer(const FosRequest& request, const SafetyQuestion& question, const Model& model, std::ostream& progress) {
  try {
    SafetyReport report = factor_of_safety(model, question, told(progress, ""));
    SafetyReport kept = factor_of_kept_strength(model, question, report, told(progress, ", kept as joints slide"));
    return {std::move(report), std::move(kept)};
  } catch (const InputError& error) {  // of stages that the scene does not have
    throw InputError(request.scene.string(), "in the static stages of dda fos, " + error.field(), error.value(),
                     error.expected());
  }
}

}  // namespace

void add_fos(CLI::App& app, FosRequest& request) {
  CLI::App* command = app.add_subcommand("fos", "Find the factor of safety by reducing the strength of joints");
  command->footer(details);
  const auto add = [command](const char* name, auto& value, const char* help, const char* type) {
    return command->add_option(name, value, help)->type_name(type);
  };
  add("scene", request.scene, "scene file (JSON)", "SCENE.json")->required();
  add("--out", request.folder, "folder for the results; made if need be", "DIR");
  add("--most", request.most, "greatest factor tried, and one over the least; default 64", "FACTOR");
  add("--width", request.width, "of the interval in which the factor lies, as a share of it; default 0.005", "SHARE");
  add("--jobs", request.jobs, "factors tried at once; default: as many as there are cores", "N");
}

void find_factor_of_safety(const FosRequest& request, std::ostream& out, std::ostream& progress) {
  const Model model = read_scene(request.scene);
  const SafetyQuestion question = question_of(request, model);
  const ReservedFolder folder(request.folder, {"fos.json", "fos.svg"});
  const auto [report, kept] = answer(request, question, model, progress);
  std::string text = fos_text(report, kept, question, model);
  if (!request.folder.empty()) {
    write_file(request.folder / "fos.json", fos_json(report, kept, question, model));
    write_file(request.folder / "fos.svg", fos_picture(report, model));
    text += fmt::format("written: {}\n", (request.folder / "fos.json").string());
  }
  out << text;
}

}  // namespace dda
