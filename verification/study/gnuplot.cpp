#include "verification/study/gnuplot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "engine/record/atomic_file.h"
#include "verification/study/process_pool.h"

namespace verify {
namespace {

constexpr std::array<std::string_view, 6> palette = {"#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9"};

}  // namespace

bool gnuplot_is_installed() {
  const char* path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const std::filesystem::path program = std::filesystem::path(folders.substr(0, end)) / "gnuplot";
    if (::access(program.c_str(), X_OK) == 0) return true;
    folders = end == std::string_view::npos ? "" : folders.substr(end + 1);
  }
  return false;
}

void run_gnuplot(const std::filesystem::path& script) {
  const std::string failure = failure_of({"gnuplot", script.filename().string()}, script.parent_path());
  if (!failure.empty()) throw std::runtime_error(fmt::format("gnuplot: {} on {}", failure, script.string()));
}

void draw(const std::filesystem::path& folder, const PlotFiles& plot) {
  const std::filesystem::path script = folder / (plot.name + ".gp");
  dda::write_file(folder / (plot.name + ".dat"), plot.data);
  dda::write_file(script, plot.script);
  run_gnuplot(script);
}

std::string gnuplot_style(int width, int height) {
  std::string text = fmt::format(
      "set terminal svg size {},{} dynamic enhanced font 'Source Sans 3,Segoe UI,Helvetica,Arial,sans-serif,13' "
      "background 'white' linewidth 1\n"
      "set encoding utf8\nset minussign\n"
      "set border 3 linewidth 0.8 linecolor rgb '#555555'\nset tics nomirror out scale 0.6 textcolor rgb '#333333'\n"
      "set grid linewidth 0.5 linetype 1 linecolor rgb '#e4e4e4', linewidth 0 linecolor rgb '#ffffff00'\n"
      "set key textcolor rgb '#222222' samplen 2.2 spacing 1.15\n",
      width, height);
  for (std::size_t i = 0; i < palette.size(); ++i)
    text += fmt::format("set style line {} linewidth 1.8 linecolor rgb '{}' pointtype 7 pointsize 0.7\n", i + 1,
                        palette[i]);
  return text + "set style line 9 linewidth 1.6 dashtype (6,4) linecolor rgb '#000000'\n";
}

}  // namespace verify
