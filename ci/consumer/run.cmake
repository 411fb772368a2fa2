# Installs BUILD into a prefix of its own, builds the consumer against nothing but that prefix, and runs it. No standard
# of C++ is named here: what is installed asks for the one that it needs.
# cmake -D BUILD=build/release -D WORK=build/release/consumer -D COMPILER=g++ -P run.cmake
file(REMOVE_RECURSE "${WORK}")
set(checked COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix" ${checked})
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${WORK}/build" -G Ninja
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
  ${checked})
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" ${checked})
execute_process(COMMAND "${WORK}/build/consumer" COMMAND_ERROR_IS_FATAL ANY)

# What is installed must not point back into the source or build tree.
file(GLOB_RECURSE installed "${WORK}/prefix/*.cmake" "${WORK}/prefix/*.h")
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH source)
cmake_path(GET source PARENT_PATH source)
foreach(file ${installed})
  file(STRINGS "${file}" lines REGEX "${source}")
  if(lines)
    message(FATAL_ERROR "${file} names the source tree: ${lines}")
  endif()
endforeach()
