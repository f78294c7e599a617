# SPDX-License-Identifier: GPL-3.0-or-later
# Fails when a source file does not say its licence in its first two lines, or says another than its folder's.
#   cmake -DROOT=<repository> -P check_licences.cmake
cmake_minimum_required(VERSION 3.25)

set(count 0)
foreach(folder IN ITEMS cases realtime reference compare reports tests cmake docs)
  file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp" "${ROOT}/${folder}/*.h"
    "${ROOT}/${folder}/*.c" "${ROOT}/${folder}/*.cmake" "${ROOT}/${folder}/*CMakeLists.txt" "${ROOT}/${folder}/*.py"
    "${ROOT}/${folder}/*.ts" "${ROOT}/${folder}/*.tsx" "${ROOT}/${folder}/*.mjs"
    "${ROOT}/${folder}/*.js" "${ROOT}/${folder}/*.cs" "${ROOT}/${folder}/*.gd")
  list(FILTER files EXCLUDE REGEX "node_modules/")
  foreach(file IN LISTS files)
    # What an engine may link, our own code on Eigen, and what an application copies. The rest uses libraries under the
    # GPL.
    set(licence "GPL-3.0-or-later")
    if(file MATCHES "^(cases/model|realtime|docs/loggers)/")
      set(licence "Apache-2.0")
    endif()
    file(STRINGS "${ROOT}/${file}" lines LIMIT_COUNT 2)
    if(NOT "${lines}" MATCHES "SPDX-License-Identifier: ${licence}( |;|$)")
      message(NOTICE "${file}: must say 'SPDX-License-Identifier: ${licence}' in its first two lines")
      set(wrong TRUE)
    endif()
    math(EXPR count "${count} + 1")
  endforeach()
endforeach()
if(count EQUAL 0)
  message(FATAL_ERROR "no sources under ${ROOT}: give -DROOT=<repository>")
endif()
if(wrong)
  message(FATAL_ERROR "licences are missing or wrong: see the lines above")
endif()
message(STATUS "${count} files say their licence")
