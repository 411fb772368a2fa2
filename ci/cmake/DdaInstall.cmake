# Install rules: the engine's libraries and headers for find_package(dda), and the program. Included once, after engine/.
include(CMakePackageConfigHelpers)

# The engine's modules without those of the program alone: its command line, and PETSc, which is no library to build on.
get_property(modules GLOBAL PROPERTY DDA_MODULES)
set(installed)
foreach(module ${modules})
  get_target_property(folder ${module} SOURCE_DIR)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${CMAKE_SOURCE_DIR}")
  if(folder MATCHES "^engine/" AND NOT folder MATCHES "^engine/(app|distributed)$")
    list(APPEND installed ${module})
    install(DIRECTORY "${folder}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/dda/engine" FILES_MATCHING PATTERN "*.h")
  endif()
endforeach()
install(TARGETS ${installed} EXPORT ddaTargets)

# What the installed libraries need found again: the package of every linked PACKAGE::target that is not ours.
set(packages)
foreach(module ${installed})
  get_target_property(linked ${module} INTERFACE_LINK_LIBRARIES)
  string(REGEX MATCHALL "[A-Za-z0-9_]+::" names "${linked}")
  list(APPEND packages ${names})
endforeach()
list(TRANSFORM packages REPLACE "::" "")
list(REMOVE_DUPLICATES packages)
list(REMOVE_ITEM packages dda)
list(JOIN packages " " DDA_PACKAGES)

set(config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/dda")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ddaConfig.cmake.in" "${CMAKE_BINARY_DIR}/ddaConfig.cmake"
  INSTALL_DESTINATION "${config_folder}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/ddaConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/ddaConfig.cmake" "${CMAKE_BINARY_DIR}/ddaConfigVersion.cmake"
  DESTINATION "${config_folder}")
install(EXPORT ddaTargets NAMESPACE dda:: DESTINATION "${config_folder}")

# Find modules of our own, when a linked library has no package configuration.
file(GLOB find_modules "${CMAKE_CURRENT_LIST_DIR}/Find*.cmake")
install(FILES ${find_modules} DESTINATION "${config_folder}")

if(TARGET dda)
  install(TARGETS dda)
endif()
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
