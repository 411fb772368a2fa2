// Reading a whole file, and only what is one: a pipe or a device may have no end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace dda {

// why() completes "the file is ...": "missing", "a directory", "a named pipe", "larger than 1024 MiB", ...
class UnreadableFile : public std::runtime_error {
 public:
  UnreadableFile(const std::filesystem::path& path, std::string why);
  [[nodiscard]] const std::string& why() const { return why_; }

 private:
  std::string why_;
};

// What people write, such as scenes, specs and records, is read up to here; 100,000 blocks take 15 MB.
inline constexpr std::uint64_t most_input_bytes = std::uint64_t{1} << 30;

// What the programs write may be longer; this bound only keeps a damaged file from filling the memory.
inline constexpr std::uint64_t most_result_bytes = std::uint64_t{1} << 36;

// All bytes of a regular file, also through links. UnreadableFile for anything else, and for a file of more than
// `most_bytes`; opening never waits, as it would for the writer of a pipe.
std::string read_file(const std::filesystem::path& path, std::uint64_t most_bytes = most_result_bytes);

// What read_file would say, as far as a look at the file without opening it tells; empty where it would read.
std::string why_unreadable(const std::filesystem::path& path, std::uint64_t most_bytes = most_result_bytes);

}  // namespace dda
