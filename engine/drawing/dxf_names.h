// Names in DXF: those that release 12 takes for layers, and extended data for what these lose.
#pragma once

#include <string>
#include <string_view>

namespace dda {

// Extended data of entities: the name under which it is kept, and what its texts begin with.
inline constexpr const char* dxf_application = "DDA";
inline const std::string dxf_layer_key = "layer=";
inline const std::string dxf_material_key = "material=";

// A name that release 12 takes: up to 31 letters, digits, "-" and "_"; other bytes become "_".
std::string dxf_name(std::string_view name);

// Texts of release 12 are ASCII: other characters are \U+ and four hexadecimal digits, as AutoCAD has them, those
// beyond 16 bits by two such (surrogates); the backslash too. The text must be UTF-8, as readable() gives it.
std::string dxf_escaped(std::string_view text);

// The text of escaped characters; what is none stays as it is.
std::string dxf_unescaped(std::string_view text);

}  // namespace dda
