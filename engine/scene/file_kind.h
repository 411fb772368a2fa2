// Files that are given in place of a scene or of a folder of results: what they are, and who reads them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dda {

struct FileKind {
  std::string what;     // "a drawing (DXF)"
  std::string command;  // which command reads it, as the end of a sentence
};

// By the first bytes of the file, and its name where these say nothing; nothing for what may be a scene.
std::optional<FileKind> kind_other_than_scene(const std::filesystem::path& file, std::string_view beginning);

// The same, of a file that is there.
std::optional<FileKind> kind_other_than_scene(const std::filesystem::path& file);

}  // namespace dda
