// One run a folder: two that write to the same files would leave a mixture that looks like one.
#pragma once

#include <filesystem>
#include <string>

namespace dda {

// InputError of "--out": this folder, and why nothing can be written there.
[[noreturn]] void refuse_place(const std::filesystem::path& folder, const std::string& why);

// Holds a folder while it lives, by a lock of the system on FOLDER/run.lock, which ends with the process however that
// ends. The file names the holder for whom it refuses, and goes with the lock; one that a killed run leaves is no lock.
class FolderLock {
 public:
  // Creates the folder if need be. InputError of "--out" when another run holds the folder, saying which, and when it
  // cannot be created or written to, saying why.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  [[noreturn]] void refuse(const std::filesystem::path& folder);
  [[nodiscard]] bool lock(const std::filesystem::path& folder);
  void name_holder() const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace dda
