# SPDX-License-Identifier: GPL-3.0-or-later
# Fails when a file includes a folder or a package that it may not see.
#   cmake -DROOT=<repository> -P check_layering.cmake
cmake_minimum_required(VERSION 3.25)

cmake_path(ABSOLUTE_PATH ROOT NORMALIZE)
include("${CMAKE_CURRENT_LIST_DIR}/../cmake/PrivateHeaders.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/../compare/engine/registry.cmake")

# What a file may include of our own, as a regular expression of the included path; the first rule that fits the file counts.
# The engines see the model alone, the judge sees no engine, and the engines not each other.
set(rules
  "^cases/model/"         "^cases/model/"
  "^cases/closed_form/"   "^cases/(closed_form/|model/(friction|input_error|pose|text)\\.hpp)"
  "^cases/catalogue/"     "^cases/"
  "^cases/"               "^cases/(model|input|geometry|hand)/"
  "^realtime/"            "^(cases/model|realtime)/"
  "^reference/"           "^(cases/model|reference)/"
  "^compare/(engine|peers)/"  "^(cases|compare|realtime|reference)/"
  "^compare/"             "^(cases|compare)/"
  "^reports/cli/"         "^(cases|compare|reports|realtime|reference)/"
  "^reports/"             "^(cases|compare|reports)/"
  "^tests/"               "")

function(seen_by file out)
  set(left ${rules})
  while(left)
    list(POP_FRONT left files seen)
    if(file MATCHES "${files}")
      set(${out} "${seen}" PARENT_SCOPE)
      return()
    endif()
  endwhile()
  set(${out} "^no folder" PARENT_SCOPE)
endfunction()

# A package's slow, viral or licence-bearing headers stay in few files: "<regex of the include>|<regex of the files that may>".
set(packages
  "Simbody|SimTK|simbody"  "^(tests/)?reference/(rigid/)?simbody_[a-z_]+\\.[ch]pp$"
  "CGAL/"                  "^(cases/geometry/cgal_[a-z_]+\\.cpp|tests/cases/(geometry|model|input)/[a-z_]+\\.cpp)$"
  "CLI/"                   "^reports/cli/(handhold|command_[a-z_]+|option_checks)\\.[ch]pp$"
  "zlib"                   "^(cases/input/gzip|reports/data/deflate|tests/cases/input/hand_dialects_test|tests/fuzz/input_kinds)\\.cpp$"
  "toml\\+\\+|toml\\.hpp"  "^cases/input/scene/(scene_file|toml_section)\\.[ch]pp$"
  "ode/|mujoco/|dart/"     "^compare/peers/[a-z_]+\\.cpp$"
  "benchmark/"             "^tests/bench/[a-z_]+\\.[ch]pp$"
  "gsl/"                   "^(cases/[a-ln-z]|compare|reference|tests).*\\.[ch]pp$"
  "fmt/"                   "^(cases/[a-ln-z]|reference|compare|reports|tests).*\\.[ch]pp$"
  "nlohmann/"              "^(cases|compare|reports|tests)/.*\\.[ch]pp$")

function(complain file number line why)
  string(STRIP "${line}" line)
  message(NOTICE "${file}:${number}: ${why}: ${line}")
  set_property(GLOBAL PROPERTY broken TRUE)
endfunction()

function(check_own_include file number line included)
  seen_by("${file}" seen)
  string(REGEX MATCH "^[a-z]+" folder "${included}")
  if(NOT included MATCHES "${seen}")
    complain("${file}" ${number} "${line}" "may see only ${seen}")
  elseif(included MATCHES "${private_headers}" AND NOT file MATCHES "^tests/|^${folder}/.*\\.cpp$" AND NOT file MATCHES "${private_headers}")
    complain("${file}" ${number} "${line}" "a header that shows a package serves the sources of its own folder only")
  endif()
endfunction()

function(check_package_include file number line included)
  if(file MATCHES "\\.hpp$" AND NOT file MATCHES "${private_headers}|^tests/" AND NOT included MATCHES "^([a-z_0-9]+|Eigen/[A-Za-z]+)$")
    complain("${file}" ${number} "${line}" "headers show only Eigen and the standard library")
    return()
  endif()
  set(rules ${packages})
  while(rules)
    list(POP_FRONT rules package users)
    if(included MATCHES "^(${package})" AND NOT file MATCHES "${users}")
      complain("${file}" ${number} "${line}" "only ${users} may see this package")
    endif()
  endwhile()
endfunction()

# What is true names no engine: no word of the code in cases is an engine's name. Two are words of their own, a
# level and the publication (or a material): of those only the string "rigid" is an engine.
set(words ${engines} simbody)
list(REMOVE_ITEM words rigid paper)
list(JOIN words "|" words)
string(REPLACE "-" "[-_]" words "${words}")

function(check_names file number line)
  string(REGEX REPLACE "//.*" "" code "${line}")
  string(TOLOWER " ${code} " code)
  if(code MATCHES "[^a-z_](${words})[^a-z_]|\"rigid\"")
    complain("${file}" ${number} "${line}" "a case names no engine")
  endif()
endfunction()

function(check_file file)
  file(READ "${ROOT}/${file}" text)
  string(REGEX REPLACE "[][;\\\\]" " " text "${text}")  # characters that would upset CMake's lists
  string(REPLACE "\n" ";" lines "${text}")
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    if(file MATCHES "^cases/")
      check_names("${file}" ${number} "${line}")
    endif()
    if(line MATCHES "^[ \t]*#[ \t]*include[ \t]*<([^>]+)>")
      check_package_include("${file}" ${number} "${line}" "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^[ \t]*#[ \t]*include[ \t]*\"([a-z]+/[^\"]+)\"")
      check_own_include("${file}" ${number} "${line}" "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^[ \t]*#[ \t]*include[ \t]*\"")
      complain("${file}" ${number} "${line}" "write includes from the repository's root")
    endif()
  endforeach()
endfunction()

set(count 0)
foreach(folder IN ITEMS cases realtime reference compare reports tests)
  file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp")
  list(FILTER files EXCLUDE REGEX "node_modules/|^tests/package/")
  foreach(file IN LISTS files)
    check_file("${file}")
    math(EXPR count "${count} + 1")
  endforeach()
endforeach()
if(count EQUAL 0)
  message(FATAL_ERROR "no sources under ${ROOT}: give -DROOT=<repository>")
endif()
get_property(broken GLOBAL PROPERTY broken)
if(broken)
  message(FATAL_ERROR "the layers are broken: see the lines above")
endif()
message(STATUS "${count} files keep the layers")
