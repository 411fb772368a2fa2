#include "engine/drawing/zip_archive.h"

#include <zlib.h>

#include <algorithm>
#include <utility>

#include "engine/core/error.h"

namespace dda {
namespace {

constexpr std::uint32_t end_mark = 0x06054b50;
constexpr std::uint32_t directory_mark = 0x02014b50;
constexpr std::uint32_t file_mark = 0x04034b50;
constexpr std::size_t end_size = 22;
constexpr std::size_t directory_entry_size = 46;
constexpr std::size_t file_header_size = 30;
constexpr std::uint32_t most_unpacked = std::uint32_t{1}
                                        << 28U;  // bytes of one file, against archives made to fill memory

// Raw deflated data; false unless it is whole and gives just as many bytes as `unpacked` has.
bool inflate_into(std::string& unpacked, std::string_view packed) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
  std::string input(packed);  // zlib takes no const bytes
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(unpacked.data());
  stream.avail_out = static_cast<uInt>(unpacked.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool whole = result == Z_STREAM_END && stream.total_out == unpacked.size();
  inflateEnd(&stream);
  return whole;
}

}  // namespace

ZipArchive::ZipArchive(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {
  constexpr std::size_t longest_comment = 65535;
  if (bytes.size() < end_size) refuse("no archive, or cut off");
  const std::size_t last = bytes.size() - end_size;
  for (std::size_t back = 0; back <= std::min(last, longest_comment); ++back) {
    if (number(last - back, 4) != end_mark) continue;
    read_directory(number(last - back + 16, 4), number(last - back + 10, 2));
    return;
  }
  refuse("no archive, or cut off");
}

void ZipArchive::refuse(const std::string& why) const { throw InputError("", name_, why, "an .xlsx file"); }

std::uint32_t ZipArchive::number(std::size_t at, int bytes) const {
  if (at + static_cast<std::size_t>(bytes) > bytes_.size()) refuse("cut off");
  std::uint32_t value = 0;
  for (int i = bytes; i-- > 0;)
    value = (value << 8U) | static_cast<unsigned char>(bytes_[at + static_cast<std::size_t>(i)]);
  return value;
}

void ZipArchive::read_directory(std::size_t at, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (number(at, 4) != directory_mark) refuse("an archive with a broken directory");
    const Entry entry{number(at + 8, 2),  number(at + 10, 2), number(at + 16, 4),
                      number(at + 20, 4), number(at + 24, 4), number(at + 42, 4)};
    const std::size_t length = number(at + 28, 2);
    if (at + directory_entry_size + length > bytes_.size()) refuse("cut off");
    entries_[std::string(bytes_.substr(at + directory_entry_size, length))] = entry;
    at += directory_entry_size + length + number(at + 30, 2) + number(at + 32, 2);
  }
}

std::string_view ZipArchive::packed_bytes(const Entry& entry) const {
  if (number(entry.offset, 4) != file_mark) refuse("an archive with a broken file");
  const std::size_t at = entry.offset + file_header_size + number(entry.offset + 26, 2) + number(entry.offset + 28, 2);
  if (at > bytes_.size() || entry.packed > bytes_.size() - at) refuse("cut off");
  return bytes_.substr(at, entry.packed);
}

std::optional<std::string> ZipArchive::file(const std::string& path) const {
  constexpr std::uint32_t stored = 0;
  constexpr std::uint32_t deflated = 8;
  const auto found = entries_.find(path);
  if (found == entries_.end()) return std::nullopt;
  const Entry& entry = found->second;
  if ((entry.flags & 1U) != 0) refuse("an archive with a password");
  if (entry.unpacked > most_unpacked) refuse("an archive of a file of more than 256 MB");
  const std::string_view packed = packed_bytes(entry);
  constexpr std::uint32_t most_ratio = 1032;  // that deflating can reach
  if (entry.unpacked / most_ratio > packed.size()) refuse("an archive whose " + path + " is broken");
  std::string unpacked(entry.unpacked, '\0');
  bool whole = false;
  if (entry.method == stored && packed.size() == unpacked.size()) {
    unpacked = packed;
    whole = true;
  }
  if (entry.method == deflated) whole = inflate_into(unpacked, packed);
  const auto* bytes = reinterpret_cast<const Bytef*>(unpacked.data());
  if (!whole || crc32(0, bytes, static_cast<uInt>(unpacked.size())) != entry.checksum)
    refuse("an archive whose " + path + " is broken");
  return unpacked;
}

}  // namespace dda
