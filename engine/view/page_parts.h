// The parts of the page that are the same for every run; their sources are in page/.
#pragma once

#include <span>
#include <string_view>

namespace dda {

std::string_view page_template();  // HTML with {{TITLE}}, {{STYLE}}, {{DATA}} and {{SCRIPTS}}
std::string_view page_style();
std::span<const std::string_view> page_scripts();  // in the order in which they must run

}  // namespace dda
