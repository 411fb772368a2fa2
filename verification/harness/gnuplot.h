// Plots by the program gnuplot, which runs as a process of its own.
#pragma once

#include <filesystem>
#include <string>

namespace verify {

[[nodiscard]] bool gnuplot_is_installed();

// Runs `gnuplot SCRIPT` in the script's folder, so that its file names are relative to it. Throws std::runtime_error if
// it cannot be started or reports an error.
void run_gnuplot(const std::filesystem::path& script);

// Lines for the start of a script: SVG of that size (px at 96 dpi), thin axes, light grid, the line and point styles
// 1-6 of a palette that colour-blind readers can tell apart (Okabe & Ito 2008), and 9 for a reference, black and
// dashed.
[[nodiscard]] std::string gnuplot_style(int width, int height);

}  // namespace verify
