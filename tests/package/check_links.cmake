# SPDX-License-Identifier: GPL-3.0-or-later
# The real-time path stays free of every package but Eigen (which is headers only).
#   cmake -DPROGRAM=<linked program> -DARCHIVES=<a.a;b.a> -P check_links.cmake
cmake_minimum_required(VERSION 3.25)
find_program(readelf NAMES readelf REQUIRED)
find_program(nm NAMES nm REQUIRED)

execute_process(COMMAND ${readelf} -d "${PROGRAM}" OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "Shared library: .[^]]+" libraries "${dynamic}")
list(TRANSFORM libraries REPLACE "Shared library: ." "")
message(STATUS "${PROGRAM} needs: ${libraries}")
if(NOT libraries)
  message(FATAL_ERROR "nothing found: is it a dynamically linked program?")
endif()
foreach(library IN LISTS libraries)  # the compiler's own, and its sanitisers'
  if(NOT library MATCHES "^(libstdc\\+\\+|libm|libgcc_s|libc|ld-linux[-a-z0-9_]*|libasan|libubsan)\\.so")
    list(APPEND wrong "needs ${library}")
  endif()
endforeach()

foreach(archive IN LISTS ARCHIVES)
  execute_process(COMMAND ${nm} -C "${archive}" OUTPUT_VARIABLE symbols ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "(gsl_[a-z]|__gmp|mpfr_|CGAL::|SimTK::|fmt::|toml::|nlohmann::)[A-Za-z_:]*" foreign "${symbols}")
  list(REMOVE_DUPLICATES foreign)
  if(foreign)
    list(APPEND wrong "${archive} mentions ${foreign}")
  endif()
endforeach()
if(wrong)
  list(JOIN wrong "\n  " wrong)
  message(NOTICE "Eigen alone is not enough:\n  ${wrong}")
  message(FATAL_ERROR "the real-time path depends on a package")
endif()
