#include "engine/record/reserved_folder.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "engine/core/error.h"
#include "engine/record/atomic_file.h"

namespace dda {
namespace {

// The ones that are missing, the innermost last.
std::vector<std::filesystem::path> missing_folders(std::filesystem::path folder) {
  std::vector<std::filesystem::path> missing;
  std::error_code ignored;
  while (!folder.empty() && !std::filesystem::exists(folder, ignored)) {
    if (folder.has_filename()) missing.push_back(folder);
    if (folder == folder.parent_path()) break;
    folder = folder.parent_path();
  }
  std::ranges::reverse(missing);
  return missing;
}

}  // namespace

ReservedFolder::ReservedFolder(const std::filesystem::path& folder, const std::vector<const char*>& files) {
  if (folder.empty()) return;
  std::error_code unknown;  // what it is, making it tells
  if (std::filesystem::exists(folder, unknown) && !std::filesystem::is_directory(folder, unknown))
    throw InputError("", "--out", folder.string() + ", which is a file", "a folder");
  for (const char* file : files)
    if (const std::string kind = why_unwritable(folder / file); !kind.empty())
      refuse_place(folder, std::string("where ") + file + " is " + kind);
  try {
    make(folder);
  } catch (...) {
    remove_empty();
    throw;
  }
}

ReservedFolder::~ReservedFolder() {
  lock_.reset();
  remove_empty();
}

void ReservedFolder::make(const std::filesystem::path& folder) {
  for (const std::filesystem::path& each : missing_folders(folder)) {
    std::error_code error;
    if (std::filesystem::create_directory(each, error)) made_.push_back(each);
    if (error) refuse_place(folder, "which cannot be made (" + error.message() + ")");
  }
  lock_.emplace(folder);
}

// A folder that has something in it stays, and so do those around it.
void ReservedFolder::remove_empty() const {
  std::error_code ignored;
  std::for_each(made_.rbegin(), made_.rend(), [&](const auto& each) { std::filesystem::remove(each, ignored); });
}

}  // namespace dda
