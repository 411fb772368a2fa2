// The figures of the calibration report, made by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/thesis/calibration.h"

namespace verify {

// The thesis' figure of the histories at a time step: "3.2" or "3.3".
[[nodiscard]] std::string figure_number(double dt);
// File name (without folder) of the histories' figure, and of the others.
[[nodiscard]] std::string history_figure(double dt);
inline constexpr auto amplitude_figure = "fig_3_4_amplitude.svg";
inline constexpr auto velocity_figure = "fig_3_5_velocity.svg";
inline constexpr auto cost_figure = "fig_run_time.svg";

// Writes NAME.dat, NAME.gp and NAME.svg of every figure into `folder`. Throws std::runtime_error if gnuplot or a file
// fails.
void plot_calibration(const Calibration& calibration, const std::filesystem::path& folder);

}  // namespace verify
