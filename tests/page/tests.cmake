# SPDX-License-Identifier: GPL-3.0-or-later
# The page in a real browser: Debian's chromium, told what to do by playwright-core. Without it the test is skipped.
find_program(HANDHOLD_CHROMIUM chromium)

if(NOT HANDHOLD_PAGE OR NOT HANDHOLD_CHROMIUM)
  add_test(NAME page.browser COMMAND "${CMAKE_COMMAND}" -E echo
    "skipped: there is no chromium, or the program is built with HANDHOLD_PAGE=OFF (apt-get install chromium)")
  set_tests_properties(page.browser PROPERTIES LABELS page SKIP_REGULAR_EXPRESSION "^skipped")
  return()
endif()

set(reports "${CMAKE_CURRENT_BINARY_DIR}/page")
# One step a frame is too coarse for C06: its gates fail, which is what the page has to show first.
add_test(NAME page.failing_report COMMAND
  handhold suite --only C06,D04 --engines reference,realtime --substeps 1 --no-order --out "${reports}/failing")
add_test(NAME page.passing_report COMMAND
  handhold suite --only C04,D02,D04 --engines reference,realtime --out "${reports}/passing")
set_tests_properties(page.failing_report page.passing_report PROPERTIES LABELS page FIXTURES_SETUP page_reports
  PASS_REGULAR_EXPRESSION "report: [^\n]*index.html")
set(environment "HANDHOLD_PAGE_TOOLS=${PROJECT_BINARY_DIR}/page" "HANDHOLD_CHROMIUM=${HANDHOLD_CHROMIUM}"
  "HANDHOLD_PAGE_FAILING=${reports}/failing" "HANDHOLD_PAGE_PASSING=${reports}/passing")
add_test(NAME page.browser COMMAND "${HANDHOLD_NODE}" --test "${CMAKE_CURRENT_LIST_DIR}/page.test.mjs")
set_tests_properties(page.browser PROPERTIES LABELS page FIXTURES_REQUIRED page_reports TIMEOUT 900
  RUN_SERIAL TRUE  # a browser that draws in software needs both cores
  ENVIRONMENT "${environment}")
