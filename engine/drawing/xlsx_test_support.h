// Spreadsheets for tests.
#pragma once

#include <cstdint>
#include <string>

namespace dda {

// Puts a file into an archive that stores, with the checksum computed here, bit by bit (CRC-32 of ISO 3309).
class ZipFile {
 public:
  void add(const std::string& path, const std::string& text) {
    const std::uint32_t offset = static_cast<std::uint32_t>(bytes_.size());
    const std::string common = number(0, 2) + number(0, 2) + number(0, 4) + number(checksum(text), 4) +
                               number(text.size(), 4) + number(text.size(), 4) + number(path.size(), 2) + number(0, 2);
    bytes_ += number(0x04034b50, 4) + number(20, 2) + common + path + text;
    directory_ += number(0x02014b50, 4) + number(20, 2) + number(20, 2) + common + number(0, 2) + number(0, 2) +
                  number(0, 2) + number(0, 4) + number(offset, 4) + path;
    ++count_;
  }

  [[nodiscard]] std::string bytes() const {
    return bytes_ + directory_ + number(0x06054b50, 4) + number(0, 4) + number(count_, 2) + number(count_, 2) +
           number(directory_.size(), 4) + number(bytes_.size(), 4) + number(0, 2);
  }

 private:
  static std::string number(std::size_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>((value >> (8U * static_cast<unsigned>(i))) & 255U);
    return text;
  }

  static std::uint32_t checksum(const std::string& text) {
    std::uint32_t sum = 0xFFFFFFFFU;
    for (const char c : text) {
      sum ^= static_cast<unsigned char>(c);
      for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~sum;
  }

  std::string bytes_, directory_;
  std::size_t count_ = 0;
};

// A workbook of one sheet with these rows.
inline std::string workbook(const std::string& rows) {
  ZipFile archive;
  archive.add("xl/workbook.xml",
              R"(<x:workbook xmlns:x="a" xmlns:r="b"><x:sheets><x:sheet name="S" r:id="i"/></x:sheets></x:workbook>)");
  archive.add("xl/_rels/workbook.xml.rels", R"(<Relationships><Relationship Id="i" Target="s.xml"/></Relationships>)");
  archive.add("xl/s.xml", "<x:worksheet xmlns:x='a'><x:sheetData>" + rows + "</x:sheetData></x:worksheet>");
  return archive.bytes();
}

}  // namespace dda
