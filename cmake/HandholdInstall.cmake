# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the headers and a package that other CMake projects find with find_package(handhold [COMPONENTS realtime]).
include(CMakePackageConfigHelpers)
set(config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/handhold")

include(PrivateHeaders)
set(folders ${parts})
list(REMOVE_DUPLICATES folders)
foreach(folder IN ITEMS cases/model ${folders})
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
    "${PROJECT_SOURCE_DIR}/${folder}/*.hpp" "${PROJECT_SOURCE_DIR}/${folder}/*.h")
  list(FILTER headers EXCLUDE REGEX "${private_headers}")
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH below)
    install(FILES "${PROJECT_SOURCE_DIR}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/handhold/${below}")
  endforeach()
endforeach()

set(full_found FALSE)
set(reference_found FALSE)
if(TARGET handhold_reports)
  set(full_found TRUE)
endif()
if(TARGET handhold_reference)
  set(reference_found TRUE)
endif()
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/handholdConfig.cmake.in" "${PROJECT_BINARY_DIR}/handholdConfig.cmake"
  INSTALL_DESTINATION "${config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/handholdConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(EXPORT handholdTargets NAMESPACE handhold:: DESTINATION "${config_dir}")
install(FILES "${PROJECT_BINARY_DIR}/handholdConfig.cmake"
              "${PROJECT_BINARY_DIR}/handholdConfigVersion.cmake" DESTINATION "${config_dir}")
