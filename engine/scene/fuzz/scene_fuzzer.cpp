// libFuzzer target: any bytes give a model or an InputError.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/core/error.h"
#include "engine/scene/scene.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    dda::parse_scene({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  } catch (const dda::InputError&) {
    return 0;
  }
  return 0;
}
