#include "engine/record/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"

namespace dda {
namespace {

constexpr std::array files = {summary_name, checkpoint_name, request_name,  histories_name, energies_name,
                              peaks_name,   frames_name,     contacts_name, bolts_name,     linings_name,
                              page_name,    report_name,     profile_name,  spectrum_name};
constexpr std::array series = {frames_name, contacts_name, bolts_name, linings_name};  // each with a folder of frames

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) {
  path += suffix;
  return path;
}

std::filesystem::path folder_of_frames(const std::filesystem::path& folder, const char* index) {
  return folder / std::filesystem::path(index).stem();
}

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::filesystem::path& path,
                         const std::string& kind, const char* expected) {
  throw InputError("", "--out", fmt::format("{}, where {} is {}", folder.string(), path.filename().string(), kind),
                   expected);
}

// NUMBER.vtp, or what is left of writing one.
bool is_frame(const std::filesystem::directory_entry& entry) {
  std::filesystem::path name = entry.path().filename();
  if (name.extension() == ".tmp") name = name.stem();
  const std::string number = name.stem().string();
  return name.extension() == ".vtp" && number.size() >= 6 &&
         std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; });
}

void remove_frames(const std::filesystem::path& frames) {
  if (!std::filesystem::is_directory(frames)) return;
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(frames))
    if (is_frame(entry)) found.push_back(entry.path());
  for (const auto& path : found) std::filesystem::remove(path);
  if (std::filesystem::is_empty(frames)) std::filesystem::remove(frames);
}

// stage_N.bin, or what is left of writing one.
bool is_end_of_stage(const std::filesystem::directory_entry& entry) {
  std::filesystem::path name = entry.path().filename();
  if (name.extension() == ".tmp") name = name.stem();
  const std::string stem = name.stem().string();
  constexpr std::string_view prefix = "stage_";
  return name.extension() == ".bin" && stem.size() > prefix.size() && stem.starts_with(prefix) &&
         std::all_of(stem.begin() + prefix.size(), stem.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::filesystem::path> ends_of_stages(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code unknown;
  if (!std::filesystem::is_directory(folder, unknown)) return found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (is_end_of_stage(entry)) found.push_back(entry.path());
  return found;
}

}  // namespace

std::string stage_file_name(std::size_t stage) { return fmt::format("stage_{}.bin", stage + 1); }

void check_run_folder(const std::filesystem::path& folder) {
  for (const char* name : files)
    for (const char* suffix : {"", ".tmp"})
      if (const auto kind = why_unwritable(with_suffix(folder / name, suffix)); !kind.empty())
        refuse(folder, with_suffix(folder / name, suffix), kind, "a folder where that name is free, or a file");
  for (const auto& path : ends_of_stages(folder))
    if (const auto kind = why_unwritable(path); !kind.empty())
      refuse(folder, path, kind, "a folder where that name is free, or a file");
  for (const char* name : series) {
    const auto frames = folder_of_frames(folder, name);
    std::error_code unknown;  // nothing is where a name is too long to be one
    const auto status = std::filesystem::symlink_status(frames, unknown);
    if (std::filesystem::exists(status) && !std::filesystem::is_directory(status))
      refuse(folder, frames, "not a folder", "a folder where that name is free, or a folder");
  }
}

void clear_run_folder(const std::filesystem::path& folder) {
  for (const char* name : files)
    for (const char* suffix : {"", ".tmp"}) std::filesystem::remove(with_suffix(folder / name, suffix));
  for (const auto& path : ends_of_stages(folder)) std::filesystem::remove(path);
  for (const char* name : series) remove_frames(folder_of_frames(folder, name));
}

}  // namespace dda
