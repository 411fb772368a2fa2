// thesis.json and the page of each chapter.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "verification/chapters/statement.h"

namespace verify {

// The text of thesis.json with this chapter in place of what `before`, its text so far, has of it. Chapters stay in the
// order of their numbers. An empty `before` is a new file; throws dda::InputError if it is another file.
[[nodiscard]] std::string with_chapter(std::string_view before, const Chapter& chapter);

[[nodiscard]] Document chapter_page(const Chapter& chapter);

// Writes DIR/thesis.json and DIR/chapter_N.md.
void write_chapter(const std::filesystem::path& folder, const Chapter& chapter);

}  // namespace verify
