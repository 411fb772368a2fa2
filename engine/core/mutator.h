// Damages files in the ways that files are damaged, and in ways that only somebody who means harm would think of. For
// tests: fuzz_support.h.
#pragma once

#include <cctype>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dda {

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15ULL + 1) {}

  [[nodiscard]] std::size_t below(std::size_t count) { return count < 2 ? 0 : random_() % count; }
  [[nodiscard]] bool one_in(std::size_t count) { return below(count) == 0; }
  template <typename List>
  [[nodiscard]] const auto& one_of(const List& list) {
    return list[below(list.size())];
  }

  // Returns the text with one to four changes behind `from`: of bytes, words, lines and bracketed parts.
  [[nodiscard]] std::string text(std::string text, std::size_t from = 0) {
    for (std::size_t i = 1 + below(4); i > 0 && text.size() > from + 1; --i) {
      switch (below(8)) {
        case 0: change_bytes(text, from); break;
        case 1: insert_splice(text, from); break;
        case 2: change_line(text, from); break;
        case 3: change_brackets(text, from); break;
        case 4: exchange_words(text, from); break;
        default: change_number(text, from);
      }
    }
    return text;
  }

  // Returns the bytes with one to four changes behind `from`: of lengths and indices, doubles, bits, and of the end.
  [[nodiscard]] std::string memory(std::string bytes, std::size_t from = 0) {
    for (std::size_t i = 1 + below(4); i > 0 && bytes.size() > from + 8; --i) {
      const std::size_t at =
          from + (one_in(4) ? below(bytes.size() - from - 8) : 4 * below((bytes.size() - from - 8) / 4));
      switch (below(8)) {
        case 0: bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8))); break;
        case 1: put(bytes, at, one_of(doubles())); break;
        case 2: put(bytes, at, static_cast<std::int32_t>(one_of(integers()))); break;
        case 3: bytes.replace(at, 8, bytes, from + below(bytes.size() - from - 8), 8); break;
        case 4: add(bytes, at); break;
        case 5:
          if (one_in(4)) change_bytes(bytes, from);
          break;
        default: put(bytes, at, one_of(integers()));
      }
    }
    return bytes;
  }

 private:
  static const std::vector<std::int64_t>& integers() {
    static const std::vector<std::int64_t> list{0,
                                                1,
                                                2,
                                                3,
                                                -1,
                                                255,
                                                1 << 16,
                                                1 << 30,
                                                (1LL << 31) - 1,
                                                1LL << 32,
                                                1LL << 40,
                                                1LL << 60,
                                                1LL << 61,
                                                std::numeric_limits<std::int64_t>::max(),
                                                std::numeric_limits<std::int64_t>::min(),
                                                -(1LL << 31)};
    return list;
  }
  static const std::vector<double>& doubles() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    static const std::vector<double> list{std::numeric_limits<double>::quiet_NaN(),
                                          infinity,
                                          -infinity,
                                          0.0,
                                          -0.0,
                                          1e308,
                                          -1e308,
                                          1e-320,
                                          1e150,
                                          -1,
                                          1e12,
                                          1e-12};
    return list;
  }

  template <typename Number>
  static void put(std::string& bytes, std::size_t at, Number number) {
    std::memcpy(bytes.data() + at, &number, sizeof number);
  }

  // A small number more or less: lengths and indices that just do not fit.
  void add(std::string& bytes, std::size_t at) {
    std::int32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof number);
    number = static_cast<std::int32_t>(static_cast<std::uint32_t>(number) + static_cast<std::uint32_t>(below(5)) - 2U);
    put(bytes, at, number);
  }

  void change_bytes(std::string& text, std::size_t from) {
    const std::size_t at = from + below(text.size() - from);
    const std::size_t length = std::min(text.size() - at, 1 + below(40));
    switch (below(5)) {
      case 0: text[at] = static_cast<char>(below(256)); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(from + below(text.size() - from), text.substr(at, length)); break;
      case 3: text.insert(at, 1, static_cast<char>(below(256))); break;
      default:
        if (one_in(4)) text.resize(at);
    }
  }

  void insert_splice(std::string& text, std::size_t from) {
    static const std::vector<std::string> splices{
        "nan",     "-",  "1e308", "0",    "\n", "\r", "\n0\n", "\xFF",  "\xEF\xBB\xBF", "\"",
        ",",       ";",  "\t",    "[",    "]",  "{",  "}",     "1e12",  "-1",           "null",
        "true",    "{}", "[]",    "\"\"", "<",  ">",  "/>",    "&amp;", "%s%n",         std::string(1, '\0'),
        "\\u0000", ":",  "#"};
    const std::size_t at = from + below(text.size() - from);
    text.insert(at, one_in(60) ? std::string(100'000, one_in(2) ? '[' : '<') : one_of(splices));
  }

  // Takes a line out, moves it, or repeats it elsewhere.
  void change_line(std::string& text, std::size_t from) {
    const auto line_at = [&](std::size_t at) {
      const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
      const std::size_t begin = std::max(from, before == std::string::npos ? 0 : before + 1);
      const std::size_t end = text.find('\n', begin);
      return std::pair(begin, (end == std::string::npos ? text.size() : end + 1) - begin);
    };
    const auto [begin, length] = line_at(from + below(text.size() - from));
    const std::string line = text.substr(begin, length);
    if (!one_in(3)) text.erase(begin, length);
    if (one_in(2) && text.size() > from) text.insert(line_at(from + below(text.size() - from)).first, line);
  }

  // Puts one {...} or [...] in place of another, or something smaller in place of it.
  void change_brackets(std::string& text, std::size_t from) {
    const auto [at, length] = brackets(text, from);
    if (length == 0) return change_number(text, from);
    static const std::vector<std::string> smaller{"{}", "[]", "null", "0", "\"text\"", "[[]]", "true"};
    const auto [other, other_length] = brackets(text, from);
    const std::string part = one_in(2) ? one_of(smaller) : text.substr(other, other_length);
    text.replace(at, length, part);
  }

  std::pair<std::size_t, std::size_t> brackets(const std::string& text, std::size_t from) {
    const std::size_t at = text.find_first_of("{[", from + below(text.size() - from));
    if (at == std::string::npos) return {0, 0};
    int depth = 0;
    for (std::size_t i = at; i < text.size(); ++i) {
      if (text[i] == '{' || text[i] == '[') ++depth;
      if ((text[i] == '}' || text[i] == ']') && --depth == 0) return {at, i + 1 - at};
    }
    return {0, 0};
  }

  static bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+' || c == '_';
  }
  // Returns where the word at or behind a place begins, and its length.
  [[nodiscard]] std::pair<std::size_t, std::size_t> word(const std::string& text, std::size_t from) {
    std::size_t at = from + below(text.size() - from);
    while (at < text.size() && !is_word(text[at])) ++at;
    while (at > from && at < text.size() && is_word(text[at - 1])) --at;
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    return {at, end - at};
  }

  void exchange_words(std::string& text, std::size_t from) {
    const auto [at, length] = word(text, from);
    const auto [other, other_length] = word(text, from);
    text.replace(at, length, text.substr(other, other_length));
  }

  // The next number by one that tries the reader; a word where there is none near.
  void change_number(std::string& text, std::size_t from) {
    static const std::vector<std::string> odd{"0",
                                              "-0",
                                              "-1",
                                              "1",
                                              "2",
                                              "0.5",
                                              "1e-320",
                                              "1e308",
                                              "-1e308",
                                              "1e400",
                                              "nan",
                                              "-inf",
                                              "infinity",
                                              "1e150",
                                              "1e-150",
                                              "9007199254740993",
                                              "18446744073709551616",
                                              "-9223372036854775808",
                                              "2147483648",
                                              "4294967296",
                                              "1152921504606846976",
                                              "1e5",
                                              "1e9",
                                              "0x10",
                                              "1,5",
                                              "1e",
                                              ".",
                                              "+1",
                                              "\"\"",
                                              "1 m"};
    std::pair<std::size_t, std::size_t> found{0, 0};
    for (int tries = 0; tries < 8; ++tries) {
      found = word(text, from);
      if (found.second > 0 &&
          (std::isdigit(static_cast<unsigned char>(text[found.first])) != 0 || text[found.first] == '-'))
        break;
    }
    text.replace(found.first, found.second, one_of(odd));
  }

  std::mt19937_64 random_;
};

}  // namespace dda
