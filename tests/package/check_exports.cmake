# SPDX-License-Identifier: GPL-3.0-or-later
# The shared library shows the functions that the C header declares, all of them and nothing else.
#   cmake -DLIBRARY=<library.so> -DHEADER=<handhold.h> -P check_exports.cmake
cmake_minimum_required(VERSION 3.25)
find_program(nm NAMES nm REQUIRED)

execute_process(COMMAND ${nm} -D --defined-only "${LIBRARY}" OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^ \n]+\n" shown "${symbols}")
list(TRANSFORM shown STRIP)
list(SORT shown)

file(READ "${HEADER}" header)
string(REGEX MATCHALL "\n[a-z][a-z_ *]* hh_[a-z_]+\\(" declared "${header}")
list(TRANSFORM declared REPLACE ".*(hh_[a-z_]+)\\(" "\\1")
list(SORT declared)

list(LENGTH declared count)
if(count EQUAL 0 OR NOT shown STREQUAL declared)
  message(FATAL_ERROR "${LIBRARY} shows\n  ${shown}\nbut ${HEADER} declares\n  ${declared}")
endif()
message(STATUS "${count} functions")
