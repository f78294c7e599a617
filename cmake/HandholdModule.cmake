# SPDX-License-Identifier: GPL-3.0-or-later
# handhold_module(<name> SOURCES <file>... [PUBLIC <target>...] [PRIVATE <target>...] [SHAREABLE])
#
# Declares the static library handhold::<name>; SHAREABLE: its objects may become part of a shared one. Headers lie beside the sources and are included from the repository's root
# ("<folder>/x.hpp"); they install to include/handhold/<folder>/.
include_guard()

add_library(handhold_flags INTERFACE)
target_compile_options(handhold_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Wnon-virtual-dtor
  -Wno-restrict       # gcc 12 sees overlaps in std::string where there are none (its bug 105651)
  -ffp-contract=off)  # the same bits whether or not the machine has FMA

option(HANDHOLD_PCH "Precompile Eigen and the standard library once a target: more than half of the time to compile" ON)

# handhold_precompile(<target> <kind> [LINK <target>...] [HEADERS <header>...] [OPTIONS <flag>...])
#
# Eigen's and the standard library's headers, and those named, are read once for all targets of one kind, which are compiled
# alike. With -fpch-preprocess the compiler cache can see what a file was compiled from.
function(handhold_precompile target kind)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "LINK;HEADERS;OPTIONS")
  if(NOT HANDHOLD_PCH)
    return()
  endif()
  set(holder handhold_precompiled_${kind})
  if(NOT TARGET ${holder})
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/${holder}.cpp" CONTENT "// holds a precompiled header\n")
    add_library(${holder} OBJECT "${PROJECT_BINARY_DIR}/${holder}.cpp")
    target_link_libraries(${holder} PRIVATE Eigen3::Eigen handhold_flags ${arg_LINK})
    target_compile_features(${holder} PRIVATE cxx_std_20)
    target_compile_options(${holder} PRIVATE -fpch-preprocess ${arg_OPTIONS})
    target_precompile_headers(${holder} PRIVATE <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <functional>
      <map> <memory> <optional> <string> <vector> ${arg_HEADERS})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${holder})
  target_compile_options(${target} PRIVATE -fpch-preprocess)
endfunction()

function(handhold_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SHAREABLE" "" "SOURCES;PUBLIC;PRIVATE")
  add_library(handhold_${name} STATIC ${arg_SOURCES})
  add_library(handhold::${name} ALIAS handhold_${name})
  set_target_properties(handhold_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(handhold_${name} PUBLIC cxx_std_20)
  target_include_directories(handhold_${name} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR};${CMAKE_INSTALL_INCLUDEDIR}/handhold>")
  target_link_libraries(handhold_${name}
    PUBLIC ${arg_PUBLIC}
    PRIVATE ${arg_PRIVATE} "$<BUILD_INTERFACE:handhold_flags>")
  if(arg_SHAREABLE)
    set_target_properties(handhold_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    # Without it no function that others may see could be inlined into its neighbours.
    target_compile_options(handhold_${name} PRIVATE -fno-semantic-interposition)
    handhold_precompile(handhold_${name} shareable OPTIONS -fPIC -fno-semantic-interposition)
  elseif("fmt::fmt" IN_LIST arg_PRIVATE)
    handhold_precompile(handhold_${name} fmt LINK fmt::fmt HEADERS <fmt/format.h>)
  else()
    handhold_precompile(handhold_${name} plain)
  endif()
  install(TARGETS handhold_${name} EXPORT handholdTargets)
endfunction()

# handhold_isolated(<name> SOURCES <file>... LINK <target>... OPTIONS <flag>... [PRECOMPILE <header>...])
#
# An object library for the few files that include a package whose flags or headers must not reach the others (CGAL adds
# -frounding-math, Simbody fails as C++20). Use as $<TARGET_OBJECTS:handhold_<name>>.
function(handhold_isolated name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;OPTIONS;PRECOMPILE")
  add_library(handhold_${name} OBJECT ${arg_SOURCES})
  target_include_directories(handhold_${name} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(handhold_${name} PRIVATE ${arg_LINK})
  target_compile_options(handhold_${name} PRIVATE -ffp-contract=off ${arg_OPTIONS})
  if(HANDHOLD_PCH AND arg_PRECOMPILE)
    target_precompile_headers(handhold_${name} PRIVATE ${arg_PRECOMPILE})
    target_compile_options(handhold_${name} PRIVATE -fpch-preprocess)
  endif()
endfunction()

# sources_in(<list> <folder> <name>...): appends <folder>/<name>.cpp of each name to the list. Every source is named: one that
# is forgotten shows as an undefined reference, and none comes in by lying there.
function(sources_in list folder)
  set(named ${ARGN})
  list(TRANSFORM named PREPEND "${folder}/")
  list(TRANSFORM named APPEND ".cpp")
  set(${list} ${${list}} ${named} PARENT_SCOPE)
endfunction()
