# Tests of what somebody else's project gets: the installed package, and the real-time path that links with Eigen alone.
set(prefix "${PROJECT_BINARY_DIR}/prefix")

add_test(NAME package.clear COMMAND ${CMAKE_COMMAND} -E rm -rf "${prefix}")  # of headers that are no more
add_test(NAME package.install COMMAND ${CMAKE_COMMAND} --install "${PROJECT_BINARY_DIR}" --prefix "${prefix}")
set_tests_properties(package.clear package.install PROPERTIES LABELS package FIXTURES_SETUP installed)
set_tests_properties(package.install PROPERTIES DEPENDS package.clear)

# package_test(<name>): builds and runs tests/package/<name> against the installed package.
function(package_test name)
  add_test(NAME package.use_${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test "${CMAKE_CURRENT_SOURCE_DIR}/package/${name}" "${PROJECT_BINARY_DIR}/package/${name}"
    --build-generator "${CMAKE_GENERATOR}"
    --build-options "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}"
      "-DCMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
    --test-command "${PROJECT_BINARY_DIR}/package/${name}/use_${name}")
  set_tests_properties(package.use_${name} PROPERTIES LABELS package FIXTURES_REQUIRED installed FIXTURES_SETUP use_${name})
endfunction()

package_test(realtime)
package_test(everything)

# links_test(<name> <consumer> <library>...): what the consumer's program and the libraries depend on.
function(links_test name consumer)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:handhold_\\1>" OUTPUT_VARIABLE archives)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND}
    "-DPROGRAM=${PROJECT_BINARY_DIR}/package/${consumer}/use_${consumer}" "-DARCHIVES=${archives}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/package/check_links.cmake")
  set_tests_properties(${name} PROPERTIES LABELS package FIXTURES_REQUIRED use_${consumer})
endfunction()

links_test(package.realtime_links_eigen_alone realtime model realtime)
links_test(package.link_check_can_fail everything cases)
set_tests_properties(package.link_check_can_fail PROPERTIES PASS_REGULAR_EXPRESSION "needs libgsl.*libhandhold_cases.a mentions")

add_test(NAME layering COMMAND ${CMAKE_COMMAND} "-DROOT=${PROJECT_SOURCE_DIR}" -P "${CMAKE_CURRENT_SOURCE_DIR}/check_layering.cmake")
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
