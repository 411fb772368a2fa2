// Plots by the program gnuplot, which runs as a process of its own.
#pragma once

#include <filesystem>
#include <string>

namespace verify {

[[nodiscard]] bool gnuplot_is_installed();

// Runs `gnuplot SCRIPT` in the script's folder, so that its file names are relative to it. Throws std::runtime_error if
// it cannot be started or reports an error.
void run_gnuplot(const std::filesystem::path& script);

// A figure as gnuplot makes it: the script reads NAME.dat and writes NAME.svg.
struct PlotFiles {
  std::string name;
  std::string data;
  std::string script;
};

// Writes NAME.dat and NAME.gp into the folder and runs the script, which leaves NAME.svg there.
void draw(const std::filesystem::path& folder, const PlotFiles& plot);

// Lines for the start of a script: SVG of that size (px at 96 dpi), thin axes, light grid, the line and point styles
// 1-6 of a palette that colour-blind readers can tell apart (Okabe & Ito 2008), and 9 for a reference, black and
// dashed.
[[nodiscard]] std::string gnuplot_style(int width, int height);

}  // namespace verify
