# SPDX-License-Identifier: GPL-3.0-or-later
# HANDHOLD_PAGE_FRAME: the file that becomes part of the program as the report's page. Made from TypeScript with node in
# <build>/page; without node, a plain table.
option(HANDHOLD_PAGE "Build the report's page, which needs node and npm; OFF: reports are a plain table" ON)

if(NOT HANDHOLD_PAGE)
  set(HANDHOLD_PAGE_FRAME "${CMAKE_CURRENT_LIST_DIR}/plain.html")
  return()
endif()

find_program(HANDHOLD_NODE node)
find_program(HANDHOLD_NPM npm)
if(NOT HANDHOLD_NODE OR NOT HANDHOLD_NPM)
  message(FATAL_ERROR "node and npm: are needed for the report's page (install them, or give -DHANDHOLD_PAGE=OFF)")
endif()

set(page "${CMAKE_CURRENT_LIST_DIR}")
set(made "${PROJECT_BINARY_DIR}/page")
set(HANDHOLD_PAGE_FRAME "${made}/page.html")
set(packages "${page}/package.json" "${page}/package-lock.json" "${page}/.npmrc")
file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS "${page}/src/*")

add_custom_command(OUTPUT "${made}/packages.stamp"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${made}"
  COMMAND "${CMAKE_COMMAND}" -E copy ${packages} "${made}"
  COMMAND "${HANDHOLD_NPM}" ci --silent --no-audit --no-fund
  COMMAND "${CMAKE_COMMAND}" -E touch "${made}/packages.stamp"
  DEPENDS ${packages} WORKING_DIRECTORY "${PROJECT_BINARY_DIR}/page" VERBATIM
  COMMENT "Installing what the report's page is made with")

add_custom_command(OUTPUT "${HANDHOLD_PAGE_FRAME}"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${made}/src"
  COMMAND "${CMAKE_COMMAND}" -E copy_directory "${page}/src" "${made}/src"
  COMMAND "${CMAKE_COMMAND}" -E copy "${page}/build.mjs" "${page}/formulas.json" "${page}/tsconfig.json" "${made}"
  COMMAND "${HANDHOLD_NPM}" run --silent check
  COMMAND "${HANDHOLD_NODE}" build.mjs page.html
  DEPENDS "${made}/packages.stamp" ${page_sources} "${page}/build.mjs" "${page}/formulas.json" "${page}/tsconfig.json"
  WORKING_DIRECTORY "${made}" VERBATIM
  COMMENT "Building the report's page")
file(MAKE_DIRECTORY "${made}")
# A target of its own, so that the page need not wait until all that the program links is compiled.
add_custom_target(handhold_page DEPENDS "${HANDHOLD_PAGE_FRAME}")
