// A folder on disk that lives as long as an object: for tests, and for cases that read their input from files.
#pragma once

#include <filesystem>
#include <string>

namespace dda {

class TemporaryFolder {
 public:
  // Makes an empty folder of its own below the system's temporary folder; throws std::system_error where it cannot.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace dda
