# SPDX-License-Identifier: MIT
# Install rules: the core as fixrad::fixrad for find_package(fixrad), and the host tool where it is built.
# Components: fixrad_core (library, headers, CMake package) and fixrad_tool.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(FIXRAD_PACKAGE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/fixrad")

install(TARGETS fixrad EXPORT fixradTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT fixrad_core)
# Headers keep their path from the repository root, so that #include "lib/fixrad.h" reads the same everywhere.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/lib/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/fixrad/lib"
  COMPONENT fixrad_core FILES_MATCHING PATTERN "*.h")
install(EXPORT fixradTargets NAMESPACE fixrad:: DESTINATION "${FIXRAD_PACKAGE_DIR}" COMPONENT fixrad_core)

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/fixradConfig.cmake.in" "${PROJECT_BINARY_DIR}/fixradConfig.cmake"
  INSTALL_DESTINATION "${FIXRAD_PACKAGE_DIR}" NO_SET_AND_CHECK_MACRO)
# Before 1.0 a new minor version may break its users.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fixradConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fixradConfig.cmake" "${PROJECT_BINARY_DIR}/fixradConfigVersion.cmake"
  DESTINATION "${FIXRAD_PACKAGE_DIR}" COMPONENT fixrad_core)

if(TARGET fixrad_tool)
  install(TARGETS fixrad_tool RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT fixrad_tool)
endif()
