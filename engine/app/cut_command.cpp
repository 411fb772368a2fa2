#include "engine/app/cut_command.h"

#include <fmt/format.h>

#include <chrono>
#include <ostream>
#include <string>
#include <system_error>

#include "engine/app/cut_picture.h"
#include "engine/app/cut_report.h"
#include "engine/core/error.h"
#include "engine/record/atomic_file.h"
#include "engine/record/progress.h"
#include "engine/scene/cut_scene.h"

namespace dda {
namespace {

constexpr double worth_telling = 1;  // s, before what is being done is shown

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw InputError("", "--out", folder.string(), "a folder that can be made or written to");
}

}  // namespace

void cut_into_folder(const std::filesystem::path& scene, const std::filesystem::path& folder, std::ostream& out) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
  std::ostream* const screen = terminal();
  const CutScene cut = cut_scene(scene, folder, [&](std::string_view what) {
    if (screen != nullptr && seconds() > worth_telling) *screen << fmt::format("{:6.1f} s  {}\n", seconds(), what);
  });
  const CutFigures figures = figures_of(cut, seconds());
  const std::string report = report_json(cut, figures);
  const std::string picture = cut_picture(cut);
  make_folder(folder);
  write_file(folder / "scene.json", cut.text);
  write_file(folder / "cut.json", report);
  write_file(folder / "cut.svg", picture);
  out << report_text(cut, figures) << fmt::format("written: {}\n", (folder / "scene.json").string());
}

}  // namespace dda
