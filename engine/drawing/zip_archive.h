// Files in a ZIP archive that is held in memory (PKWARE APPNOTE 6.3): stored or deflated ones, without encryption and
// without the extensions for archives beyond 4 GB.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dda {

class ZipArchive {
 public:
  // `bytes` must outlive the archive. Throws InputError whose field is `name` for what is no such archive.
  ZipArchive(std::string_view bytes, std::string name);

  // The unpacked file; nothing when there is none of this path. Throws InputError when it cannot be unpacked.
  [[nodiscard]] std::optional<std::string> file(const std::string& path) const;

 private:
  struct Entry {
    std::uint32_t flags = 0, method = 0, checksum = 0, packed = 0, unpacked = 0, offset = 0;
  };

  [[noreturn]] void refuse(const std::string& why) const;
  [[nodiscard]] std::uint32_t number(std::size_t at, int bytes) const;
  void read_directory(std::size_t at, std::uint32_t count);
  [[nodiscard]] std::string_view packed_bytes(const Entry& entry) const;

  std::string_view bytes_;
  std::string name_;
  std::map<std::string, Entry> entries_;  // by path
};

}  // namespace dda
