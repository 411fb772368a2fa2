# Build rules every folder shares: compiler settings, and dda_module() for one engine or verification folder.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(DDA_CCACHE ccache)
if(DDA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # ccache keeps what was made with a precompiled header only when told that time stamps and macros in it do not matter, and
  # reads that header for every object but for a sum of it that lies beside (precompile writes it): an object that is there
  # already is then taken in 0.1 s instead of 1.4. (Remembering files by their inode is quick too, and has given stale objects.)
  # Paths below the source folder are hashed as relative ones, so that clones in other folders share what one has compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    CCACHE_PCH_EXTSUM=1 "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1 "${DDA_CCACHE}")
endif()
find_program(DDA_MOLD mold)
if(DDA_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

# GCC collects garbage whenever its heap has grown by a half, a tenth to a sixth of the time of a source that begins with the
# 140 MB of a precompiled header. Below 1 GB it need not.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)

# The same bits everywhere: no fused multiply-add that one build has and another has not, never -ffast-math.
add_compile_options(-ffp-contract=off)
if(DDA_SANITIZE)
  # A check at every use of a pointer takes as long to compile as all other checks together. What these would find ends under
  # ASan as well (null, object-size), in an assertion of Eigen's (alignment), or cannot be here (vptr: nothing polymorphic is cast downwards).
  add_compile_options(-fsanitize=${DDA_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${DDA_SANITIZE})
endif()

# In a file of several sources a local name may be one of another source's.
set(shadow $<IF:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>,$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>,-Wshadow>)
add_library(dda_options INTERFACE)
target_compile_options(dda_options INTERFACE -Wall -Wextra -Wpedantic ${shadow} -Wconversion -Wsign-conversion
  -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wnull-dereference -Wdouble-promotion
  $<$<BOOL:${DDA_WERROR}>:-Werror>)

# Headers are included by their path in the repository: "engine/FOLDER/file.h", "verification/FOLDER/file.h". Who may
# include whom is checked by ci/check-layers.

add_custom_target(unit_tests)

# The code under test comes from libraries at full optimization; that of the tests themselves only has to compile fast.
# (There GCC 12 sees uninitialized values in Eigen that are not there.) -O0 takes longer than -Og, which throws code away early.
function(dda_fast_to_compile TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-Og;-Wno-maybe-uninitialized>)
  set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endfunction()

# dda_compile_together(TARGET SIZE): its sources are compiled at most SIZE at a time, in batches without two that declare the
# same name (ADR 31). DDA_ALONE names batches that do not go together all the same, or sources that are being worked on.
set(DDA_LIBRARIES_TOGETHER 1 CACHE STRING "Sources of libraries that are compiled as one file; 1: each alone")
set(DDA_TESTS_TOGETHER 4 CACHE STRING "Sources of tests that are compiled as one file; 1: each alone")
set(DDA_ALONE "" CACHE STRING "Sources and batches of which each source is compiled alone, e.g. bolt_test;exact_test_0")
function(dda_compile_together TARGET SIZE)
  if(SIZE LESS 2)
    return()
  endif()
  find_program(DDA_PYTHON python3 REQUIRED)
  get_target_property(sources ${TARGET} SOURCES)
  list(FILTER sources EXCLUDE REGEX "^${CMAKE_BINARY_DIR}")
  execute_process(COMMAND "${DDA_PYTHON}" -B "${CMAKE_SOURCE_DIR}/ci/source_batches.py" ${SIZE} ${sources}
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" OUTPUT_VARIABLE numbers COMMAND_ERROR_IS_FATAL ANY)
  foreach(source number IN ZIP_LISTS sources numbers)
    cmake_path(GET source STEM name)
    if(NOT name IN_LIST DDA_ALONE AND NOT "${TARGET}_${number}" IN_LIST DDA_ALONE)
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${TARGET}_${number}")
    endif()
  endforeach()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# dda_add_layers(): the folders that layers.txt of this folder names, in its order.
function(dda_add_layers)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS layers.txt)
  file(STRINGS layers.txt lines REGEX "^[^#]")
  foreach(line ${lines})
    separate_arguments(folders UNIX_COMMAND "${line}")
    foreach(folder ${folders})
      add_subdirectory(${folder})
    endforeach()
  endforeach()
endfunction()

# dda_module(NAME DEPENDS other... [LINK library...] [PRIVATE_LINK library...] [TEST_LINK library...])
# One engine folder: every .cpp of it but main.cpp and *_test.cpp becomes the static library dda::NAME; every
# *_test.cpp becomes its unit-test program NAME_test, known to ctest under the labels "fast" and "unit".
function(dda_module NAME)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LINK;PRIVATE_LINK;TEST_LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  set(tests ${sources})
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "(_test|/main)\\.cpp$")
  if(sources)
    set(scope PUBLIC)
    add_library(dda_${NAME} STATIC ${sources})
    target_link_libraries(dda_${NAME} PRIVATE $<BUILD_INTERFACE:dda_options> ${ARG_PRIVATE_LINK})
    dda_use_headers(dda_${NAME} dda_library_headers)
    dda_compile_together(dda_${NAME} ${DDA_LIBRARIES_TOGETHER})
  else()
    set(scope INTERFACE)
    add_library(dda_${NAME} INTERFACE)
  endif()
  add_library(dda::${NAME} ALIAS dda_${NAME})
  list(TRANSFORM ARG_DEPENDS PREPEND "dda::")
  target_link_libraries(dda_${NAME} ${scope} Eigen3::Eigen ${ARG_DEPENDS} ${ARG_LINK})
  # Its headers are C++20, which whoever links the installed library is to know: many a compiler's own default is older.
  target_compile_features(dda_${NAME} ${scope} cxx_std_20)
  target_include_directories(dda_${NAME} ${scope} $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/dda>)
  set_target_properties(dda_${NAME} PROPERTIES EXPORT_NAME ${NAME})
  set_property(GLOBAL APPEND PROPERTY DDA_MODULES dda_${NAME})
  if(tests AND BUILD_TESTING)
    dda_test(${NAME}_test SOURCES ${tests} LINK dda::${NAME} ${ARG_TEST_LINK} LABELS fast unit)
  endif()
endfunction()

# dda_test(NAME SOURCES file... LINK target... [LABELS label...]): a GoogleTest program, its cases known to ctest under
# the labels (default: fast). Those labelled "unit" are what the target unit_tests builds.
function(dda_test NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;LABELS" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS fast)
  endif()
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE dda_options ${ARG_LINK} GTest::gtest_main)
  dda_fast_to_compile(${NAME})
  dda_use_headers(${NAME} dda_test_headers)
  dda_compile_together(${NAME} ${DDA_TESTS_TOGETHER})
  gtest_discover_tests(${NAME} DISCOVERY_TIMEOUT 60)
  # gtest_discover_tests(PROPERTIES LABELS ...) loses all labels but the first, so they are set when ctest reads the tests.
  set(labels_file "${CMAKE_CURRENT_BINARY_DIR}/${NAME}_labels.cmake")
  file(WRITE "${labels_file}" "foreach(test IN LISTS ${NAME}_TESTS)
  set_tests_properties(\"\${test}\" PROPERTIES LABELS \"${ARG_LABELS}\")\nendforeach()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${labels_file}")
  if("unit" IN_LIST ARG_LABELS)
    add_dependencies(unit_tests ${NAME})
  endif()
endfunction()
