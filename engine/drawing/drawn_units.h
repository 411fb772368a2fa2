// Lengths in which drawings are made.
#pragma once

#include <array>
#include <string_view>

namespace dda {

struct DrawnUnit {
  int code;  // of $INSUNITS in DXF
  std::string_view symbol;
  double metres;
};

// Those of the DXF reference that a drawing of rock or masonry may have; its 0 is a drawing without unit.
inline constexpr std::array<DrawnUnit, 14> drawn_units{{{1, "in", 0.0254},
                                                        {2, "ft", 0.3048},
                                                        {3, "mi", 1609.344},
                                                        {4, "mm", 1e-3},
                                                        {5, "cm", 1e-2},
                                                        {6, "m", 1},
                                                        {7, "km", 1e3},
                                                        {9, "mil", 25.4e-6},
                                                        {10, "yd", 0.9144},
                                                        {13, "um", 1e-6},
                                                        {14, "dm", 0.1},
                                                        {15, "dam", 10},
                                                        {16, "hm", 100},
                                                        {21, "ft (US survey)", 1200.0 / 3937}}};

}  // namespace dda
