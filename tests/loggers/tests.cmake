# SPDX-License-Identifier: GPL-3.0-or-later
# The loggers of docs/loggers: C++ in cases_input_test, C# there as well where mono is found, JavaScript in a browser.
find_program(HANDHOLD_MCS mcs)
find_program(HANDHOLD_MONO mono)
set(csharp_logger "")
if(HANDHOLD_MCS AND HANDHOLD_MONO)
  set(demo "${CMAKE_CURRENT_BINARY_DIR}/loggers_demo.exe")
  add_custom_command(OUTPUT "${demo}"
    COMMAND "${HANDHOLD_MCS}" -warnaserror "-out:${demo}" "${CMAKE_CURRENT_LIST_DIR}/Demo.cs"
      "${PROJECT_SOURCE_DIR}/docs/loggers/HandholdLog.cs"
    DEPENDS "${CMAKE_CURRENT_LIST_DIR}/Demo.cs" "${PROJECT_SOURCE_DIR}/docs/loggers/HandholdLog.cs" VERBATIM
    COMMENT "Compiling the C# logger")
  add_custom_target(csharp_logger DEPENDS "${demo}")
  add_dependencies(cases_input_test csharp_logger)
  set(csharp_logger "${HANDHOLD_MONO} ${demo}")
endif()
handhold_tell_path(cases/input/loggers_test.cpp HANDHOLD_CSHARP_LOGGER "${csharp_logger}")

if(HANDHOLD_PAGE AND HANDHOLD_CHROMIUM)
  add_test(NAME loggers.browser COMMAND "${HANDHOLD_NODE}" --test "${CMAKE_CURRENT_LIST_DIR}/webxr.test.mjs"
    "${CMAKE_CURRENT_LIST_DIR}/recorder.test.mjs")
  set_tests_properties(loggers.browser PROPERTIES LABELS page TIMEOUT 300 RUN_SERIAL TRUE ENVIRONMENT
    "HANDHOLD_PAGE_TOOLS=${PROJECT_BINARY_DIR}/page;HANDHOLD_CHROMIUM=${HANDHOLD_CHROMIUM};HANDHOLD_EXECUTABLE=$<TARGET_FILE:handhold>")
endif()
