// Numbers and text as the JSON library writes them, without a document around them: a list of a million entries is a
// hundred million small objects for the library, and takes ten times as long.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/parallel.h"

namespace dda {

// The same digits as in a document; null where not finite, which JSON cannot say.
void append_json_number(double value, std::string& text);

// In quotes. Throws nlohmann::json::type_error for bytes that are no UTF-8.
void append_json_text(std::string_view value, std::string& text);

// The list of what `append_one` makes of each entry, on one line.
template <typename List, typename AppendOne>
void append_json_list(const List& list, const AppendOne& append_one, std::string& text) {
  text += '[';
  bool is_first = true;
  for (const auto& each : list) {
    if (!std::exchange(is_first, false)) text += ',';
    append_one(each, text);
  }
  text += ']';
}

// What `append_one` makes of entry 0 to `count` - 1, with `separator` between, `in_part` entries each by the threads
// that there are. A few parts at a time: all of them would be as much memory as the text. How long that becomes is
// guessed from the first ones; `more` bytes that follow find room in it.
template <typename AppendOne>
void append_entries(std::size_t count, std::size_t in_part, std::string_view separator, const AppendOne& append_one,
                    std::string& text, std::size_t more = 0) {
  constexpr double room = 1.05;  // for later entries that are longer
  std::vector<std::string> parts(16);
  const std::size_t at_once = parts.size() * in_part;
  for (std::size_t begin = 0; begin < count; begin += at_once) {
    parallel_for_each(parts.size(), 1, [&](std::size_t part) {
      parts[part].clear();
      const std::size_t first = begin + part * in_part;
      for (std::size_t i = first; i < std::min(count, first + in_part); ++i) {
        if (i > 0) parts[part] += separator;
        append_one(i, parts[part]);
      }
    });
    const std::size_t before = text.size();
    for (const std::string& part : parts) text += part;
    if (begin > 0 || count <= at_once) continue;
    const double longer = static_cast<double>(text.size() - before) * static_cast<double>(count - at_once);
    text.reserve(text.size() + static_cast<std::size_t>(room * longer / static_cast<double>(at_once)) + more);
  }
}

}  // namespace dda
