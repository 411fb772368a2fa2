#include "engine/app/cut_command.h"

#include <fmt/format.h>

#include <chrono>
#include <future>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/cut_picture.h"
#include "engine/app/cut_report.h"
#include "engine/app/exported_blocks.h"
#include "engine/app/statistics_picture.h"
#include "engine/core/error.h"
#include "engine/core/parallel.h"
#include "engine/drawing/write_blocks.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "engine/record/reserved_folder.h"
#include "engine/scene/cut_scene.h"

namespace dda {
namespace {

constexpr double worth_telling = 1;  // s, before what is being done is shown

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code missing;
  return std::filesystem::equivalent(a, b, missing);
}

// What is read may be all that somebody has of it.
void expect_source_kept(const CutRequest& request) {
  const std::filesystem::path scene = request.folder / "scene.json";
  if (is_same_file(request.scene, scene))
    throw InputError("", "--out", request.folder.string() + ", whose scene.json is the scene to cut", "another folder");
  if (!request.exported.empty() && is_same_file(request.scene, request.exported))
    throw InputError("", "--export", request.exported.string() + ", which is the drawing to cut", "another name");
}

// Nothing is cut that could not be written.
void check_outputs(const CutRequest& request) {
  const std::filesystem::path& folder = request.folder;
  if (folder.empty()) throw InputError("", "--out", "empty", "a folder");
  expect_source_kept(request);
  if (request.exported.empty()) return;
  if (!is_block_format(request.exported))
    throw InputError("", "--export", request.exported.string(), "a name that ends in .dxf, .geojson or .dc");
  const std::filesystem::path holder = std::filesystem::absolute(request.exported).parent_path();
  if (!std::filesystem::is_directory(holder))
    throw InputError("", "--export", request.exported.string(), "a name in a folder that exists");
  if (const std::string kind = why_unwritable(request.exported); !kind.empty())
    throw InputError("", "--export", request.exported.string() + ", which is " + kind,
                     "a file, or a name that is free");
}

struct Output {
  std::filesystem::path file;
  std::string text;
  std::string remark;  // on what has no place in it
};

Output exported(const CutScene& cut, const std::filesystem::path& file) {
  const BlockDrawing drawing = drawing_of_blocks(cut);
  return {file, block_file(file, drawing), names_left_out(file, drawing)};
}

// Pictures of rock in many blocks take as long as its report.
std::vector<Output> outputs_of(const CutScene& cut, const CutFigures& figures, const CutRequest& request) {
  std::future<std::string> picture = std::async(std::launch::async, [&] { return cut_picture(cut); });
  std::future<std::string> statistics =
      std::async(std::launch::async, [&] { return statistics_picture(cut, figures); });
  std::vector<Output> outputs;
  outputs.push_back({request.folder / "cut.json", report_json(cut, figures), ""});
  outputs.push_back({request.folder / "cut.svg", picture.get(), ""});
  outputs.push_back({request.folder / "statistics.svg", statistics.get(), ""});
  if (!request.exported.empty()) outputs.push_back(exported(cut, request.exported));
  return outputs;
}

}  // namespace

void cut_into_folder(const CutRequest& request, std::ostream& out) {
  check_outputs(request);
  const ReservedFolder folder(request.folder, {"scene.json", "cut.json", "cut.svg", "statistics.svg"});
  const ThreadsInUse threads(request.threads > 0 ? request.threads : cores());
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  std::ostream* const screen = terminal();
  const DrawingWords words = words_of(request.drawing, request.scene);
  const auto tell = [&](std::string_view what) {
    if (screen != nullptr && seconds() > worth_telling) *screen << fmt::format("{:6.1f} s  {}\n", seconds(), what);
  };
  CutFigures figures;
  std::vector<Output> outputs;
  CutScene cut = cut_scene(request.scene, request.folder, words, tell, [&](const CutScene& unchecked) {
    figures = figures_of(unchecked, seconds());
    outputs = outputs_of(unchecked, figures, request);
  });
  Output scene{request.folder / "scene.json", std::exchange(cut.text, {}), ""};
  outputs.insert(outputs.begin(), std::move(scene));
  for (const Output& output : outputs) write_file(output.file, output.text);
  out << report_text(cut, figures);
  for (const Output& output : outputs)
    out << fmt::format("written: {}{}{}\n", output.file.string(), output.remark.empty() ? "" : "; ", output.remark);
}

}  // namespace dda
