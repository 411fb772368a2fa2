// The folder of a run: the names of what is in it, and making it ready for another run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace dda {

inline constexpr auto histories_name = "histories.csv";
inline constexpr auto energies_name = "energies.csv";
inline constexpr auto peaks_name = "peaks.csv";
inline constexpr auto frames_name = "frames.pvd";
inline constexpr auto contacts_name = "contacts.pvd";
inline constexpr auto bolts_name = "bolts.pvd";
inline constexpr auto linings_name = "linings.pvd";
inline constexpr auto checkpoint_name = "checkpoint.bin";
inline constexpr auto summary_name = "summary.json";
inline constexpr auto request_name = "run.json";       // what the run was asked for
inline constexpr auto profile_name = "profile.json";   // where the time went, of dda run --profile
inline constexpr auto page_name = "view.html";         // what dda view makes of it
inline constexpr auto report_name = "report.html";     // what dda report makes of it
inline constexpr auto spectrum_name = "spectrum.csv";  // what dda spectrum makes of it

// Names the file of the state at the end of a stage, counted from 0, where a run keeps it.
std::string stage_file_name(std::size_t stage);

// Throws InputError naming what stands in the folder, under one of these names, where a run could not write: a folder
// in place of a file, a file in place of a folder, a link, a device.
void check_run_folder(const std::filesystem::path& folder);

// Takes away all that runs before have left under these names, complete or not, so that nothing in the folder comes
// from two runs; other files stay. To be called after check_run_folder. A kill half-way leaves a part of one run.
void clear_run_folder(const std::filesystem::path& folder);

}  // namespace dda
