// What tells text of Windows' tools from the UTF-8 that everything here reads: spreadsheets save "Unicode text", and
// `>` of some shells writes it, as UTF-16 with a mark at its beginning.
#pragma once

#include <string_view>

namespace dda {

inline bool is_utf16(std::string_view beginning) {
  return beginning.starts_with("\xFF\xFE") || beginning.starts_with("\xFE\xFF");
}

// What messages say of such a file, and what they ask for.
inline constexpr auto utf16_text = "text in UTF-16";
inline constexpr auto save_as_utf8 = "text in UTF-8; editors and spreadsheets save it so";

}  // namespace dda
