// The 64-bit FNV-1a hash (Fowler, Noll & Vo): finds accidental damage, not forgery.
#pragma once

#include <cstdint>
#include <string_view>

namespace dda {

class FnvHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }

  // The bytes of a number.
  template <typename Number>
  void add_number(const Number& number) {
    add({reinterpret_cast<const char*>(&number), sizeof number});
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

}  // namespace dda
