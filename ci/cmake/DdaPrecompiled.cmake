# Precompiled headers (ADR 25): what nearly every source includes is parsed once for all libraries and once, with GoogleTest,
# for all tests. Sources still include what they use: the build with -DDDA_PRECOMPILE=OFF and clang-tidy see no such header.
option(DDA_PRECOMPILE "Parse the headers that most sources share once" ON)

set(DDA_LIBRARY_HEADERS <algorithm> <array> <chrono> <cmath> <complex> <filesystem> <functional> <map> <memory> <numeric>
  <optional> <span> <string> <string_view> <utility> <vector> <Eigen/Dense> <fmt/format.h> <ci/cmake/common_types.h>)

# GCC takes a precompiled header only under the options and macros it was made with, and says so as an error (-Winvalid-pch).
function(dda_header_set NAME)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINK" ${ARGN})
  set(source "${CMAKE_BINARY_DIR}/${NAME}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "// ${NAME}: a target needs a source, this one is made for its headers.\n")
  add_library(${NAME} OBJECT "${source}")
  target_link_libraries(${NAME} PRIVATE dda_options Eigen3::Eigen fmt::fmt ${ARG_LINK})
  target_include_directories(${NAME} PRIVATE "${CMAKE_SOURCE_DIR}")
  target_precompile_headers(${NAME} PRIVATE ${ARG_HEADERS})
  if(CMAKE_CXX_COMPILER_LAUNCHER)
    set_target_properties(${NAME} PROPERTIES CXX_COMPILER_LAUNCHER
      "${CMAKE_SOURCE_DIR}/ci/cmake/precompile;${CMAKE_CXX_COMPILER_LAUNCHER}")
  endif()
  target_compile_options(${NAME} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# dda_use_headers(TARGET SET): TARGET reads the headers of SET precompiled, whose options must be its own.
function(dda_use_headers TARGET SET)
  if(DDA_PRECOMPILE)
    target_link_libraries(${TARGET} PRIVATE $<BUILD_INTERFACE:fmt::fmt>)
    target_precompile_headers(${TARGET} REUSE_FROM ${SET})
    target_compile_options(${TARGET} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  endif()
endfunction()

if(DDA_PRECOMPILE)
  dda_header_set(dda_library_headers HEADERS ${DDA_LIBRARY_HEADERS})
  if(BUILD_TESTING)
    dda_header_set(dda_test_headers HEADERS ${DDA_LIBRARY_HEADERS} <gtest/gtest.h> LINK GTest::gtest)
    dda_fast_to_compile(dda_test_headers)
  endif()
endif()
