// A folder for results that come later: made and held before anything is computed, so that a place where nothing can be
// written is found out then.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/record/folder_lock.h"

namespace dda {

class ReservedFolder {
 public:
  // Creates the folder if need be and holds it (FolderLock), unless `folder` is empty. InputError of "--out" when it
  // cannot be written to or another run holds it, or when something other than a file has the name of one of `files`.
  ReservedFolder(const std::filesystem::path& folder, const std::vector<const char*>& files);

  // Takes away the folders that it has made and that are still empty.
  ~ReservedFolder();
  ReservedFolder(const ReservedFolder&) = delete;
  ReservedFolder& operator=(const ReservedFolder&) = delete;

 private:
  void make(const std::filesystem::path& folder);
  void remove_empty() const;

  std::vector<std::filesystem::path> made_;  // the innermost last
  std::optional<FolderLock> lock_;
};

}  // namespace dda
