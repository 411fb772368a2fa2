// Files that appear complete or not at all: written as NAME.tmp and renamed when done.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dda {

// What a committed file outlasts. Waiting for the disk costs about 10 ms, too much for every frame.
enum class Survives {
  crash,      // of the program
  power_cut,  // and of the machine
};

// A file being written. Whatever stood under its name stays there, whole, until commit(). All errors are
// std::runtime_error naming the path and the reason.
class AtomicFile {
 public:
  // Opens NAME.tmp in the same folder, which must exist; a left-over NAME.tmp is overwritten.
  explicit AtomicFile(std::filesystem::path path);

  // Without commit(): NAME.tmp is removed.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  // Appends all of `text` or, when that fails (full disk), nothing of it: the file is cut back before the error is
  // thrown, and may still be committed.
  void write(std::string_view text);

  // Puts the complete file in its place.
  void commit(Survives survives = Survives::crash);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error) const;
  void close();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // bytes of whole writes
};

// One write and commit.
void write_file(const std::filesystem::path& path, std::string_view text, Survives survives = Survives::crash);

// All bytes of a file; std::runtime_error naming path and reason when it cannot be read.
std::string read_file(const std::filesystem::path& path);

}  // namespace dda
