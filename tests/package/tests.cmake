# SPDX-License-Identifier: GPL-3.0-or-later
# Tests of what somebody else's project gets: the installed package, and the real-time path built and installed alone, with
# Eigen and a compiler.
set(prefix "${PROJECT_BINARY_DIR}/prefix")
set(alone "${PROJECT_BINARY_DIR}/prefix_realtime")
set(cube "${PROJECT_BINARY_DIR}/package/cube.hhvox")
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/package")
string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" of_type)
set(same_compiler "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}" "-D${of_type}=${${of_type}}" "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}"
  "-DCMAKE_C_FLAGS=${CMAKE_CXX_FLAGS}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}")

add_test(NAME package.clear COMMAND ${CMAKE_COMMAND} -E rm -rf "${prefix}" "${alone}")  # of headers that are no more
set_tests_properties(package.clear PROPERTIES LABELS package FIXTURES_SETUP cleared)
add_test(NAME package.install COMMAND ${CMAKE_COMMAND} --install "${PROJECT_BINARY_DIR}" --prefix "${prefix}")
set_tests_properties(package.install PROPERTIES LABELS package FIXTURES_REQUIRED cleared FIXTURES_SETUP installed)

set(hidden GSL fmt nlohmann_json tomlplusplus CLI11 CGAL Simbody GTest)
list(TRANSFORM hidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
add_test(NAME package.install_realtime_alone COMMAND ${CMAKE_CTEST_COMMAND}
  --build-and-test "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/package/alone"
  --build-generator "${CMAKE_GENERATOR}" --build-target install
  --build-options -DHANDHOLD_COMPONENTS=realtime "-DCMAKE_INSTALL_PREFIX=${alone}" ${same_compiler} ${hidden})
set_tests_properties(package.install_realtime_alone PROPERTIES
  LABELS package FIXTURES_REQUIRED cleared FIXTURES_SETUP alone)
add_test(NAME package.voxelize COMMAND handhold voxelize shape:box,x=0.05,y=0.05,z=0.05 --voxel-size 2 --out "${cube}")
set_tests_properties(package.voxelize PROPERTIES LABELS package FIXTURES_SETUP cube)

# package_test(<name> <prefix> <fixture>... [TEST <command>...]): builds tests/package/<name> against a prefix and tests it.
function(package_test name prefix)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "TEST")
  add_test(NAME package.use_${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/package/${name}" "${PROJECT_BINARY_DIR}/package/${name}"
    --build-generator "${CMAKE_GENERATOR}"
    --build-options "-DCMAKE_PREFIX_PATH=${prefix}" "-DCUBE_FILE=${cube}" ${same_compiler}
    --test-command ${arg_TEST})
  set_tests_properties(package.use_${name} PROPERTIES
    LABELS package FIXTURES_REQUIRED "${arg_UNPARSED_ARGUMENTS}" FIXTURES_SETUP use_${name})
endfunction()

package_test(realtime "${alone}" alone cube TEST ${CMAKE_CTEST_COMMAND} --output-on-failure)
package_test(everything "${prefix}" installed TEST "${PROJECT_BINARY_DIR}/package/everything/use_everything")

# links_test(<name> <consumer> <program> [<archive>...]): what the consumer's program and the archives depend on.
function(links_test name consumer program)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} "-DPROGRAM=${program}" "-DARCHIVES=${ARGN}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/package/check_links.cmake")
  set_tests_properties(${name} PROPERTIES LABELS package FIXTURES_REQUIRED use_${consumer})
endfunction()

set(libraries "${alone}/${CMAKE_INSTALL_LIBDIR}")
links_test(package.realtime_links_eigen_alone realtime "${PROJECT_BINARY_DIR}/package/realtime/hold_cpp"
  "${libraries}/libhandhold_model.a" "${libraries}/libhandhold_realtime.a")
links_test(package.shared_links_eigen_alone realtime "${libraries}/libhandhold_realtime.so")
links_test(package.link_check_can_fail everything "${PROJECT_BINARY_DIR}/package/everything/use_everything"
  $<TARGET_FILE:handhold_cases>)
set_tests_properties(package.link_check_can_fail PROPERTIES PASS_REGULAR_EXPRESSION "needs libgsl.*libhandhold_cases.a mentions")
add_test(NAME package.exports COMMAND ${CMAKE_COMMAND}
  "-DLIBRARY=${libraries}/libhandhold_realtime.so" "-DHEADER=${PROJECT_SOURCE_DIR}/realtime/handhold.h"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/package/check_exports.cmake")
set_tests_properties(package.exports PROPERTIES LABELS package FIXTURES_REQUIRED alone)

add_test(NAME layering COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_layering.cmake")
add_test(NAME licences COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_licences.cmake")
add_test(NAME layering.check_can_fail COMMAND ${CMAKE_COMMAND} "-DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/layering"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/check_layering_test.cmake")

# The headers that C++17 files include too (Simbody's fail as C++20) must stay C++17.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/cases/*.hpp")
include(PrivateHeaders)
list(FILTER headers EXCLUDE REGEX "/(closed_form|catalogue)/")
list(FILTER headers EXCLUDE REGEX "${private_headers}")
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"\n")
list(JOIN headers "" text)
file(CONFIGURE OUTPUT headers_as_cxx17.cpp CONTENT "${text}" @ONLY)
add_library(headers_as_cxx17 OBJECT "${CMAKE_CURRENT_BINARY_DIR}/headers_as_cxx17.cpp")
set_target_properties(headers_as_cxx17 PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON)
target_include_directories(headers_as_cxx17 PRIVATE "${PROJECT_SOURCE_DIR}")
target_link_libraries(headers_as_cxx17 PRIVATE Eigen3::Eigen)
target_compile_options(headers_as_cxx17 PRIVATE -Wall -Wextra -Wpedantic)
