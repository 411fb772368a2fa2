// Documents as one self-contained HTML page: style sheet and figures inside, no script, no reference to anything else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "verification/study/document.h"

namespace verify {

// Figures are read from `folder`; std::runtime_error naming the file that is missing.
[[nodiscard]] std::string to_html(const Document& document, const std::filesystem::path& folder);

// Text with &, < and > escaped, `code` and **bold** as elements, and no line break between a number and its unit.
[[nodiscard]] std::string inline_html(std::string_view text);

// An SVG file's text as an element of a page: without its XML declaration and document type, with `prefix` before every
// id, since two figures of one program use the same ones.
[[nodiscard]] std::string embedded_svg(std::string svg, const std::string& prefix);

[[nodiscard]] std::string_view report_css();

}  // namespace verify
