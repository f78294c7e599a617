# SPDX-License-Identifier: GPL-3.0-or-later
# The check of the layers must itself be able to fail: plants one wrong include after another in a scratch folder.
#   cmake -DSCRATCH=<empty folder> -P check_layering_test.cmake
cmake_minimum_required(VERSION 3.25)

# expect(<passes|fails> <file> <line>): what the check says of a tree that holds this one file.
function(expect outcome file line)
  file(REMOVE_RECURSE "${SCRATCH}")
  file(WRITE "${SCRATCH}/${file}" "// a comment; with [brackets]\n${line}\n")
  execute_process(COMMAND ${CMAKE_COMMAND} "-DROOT=${SCRATCH}" -P "${CMAKE_CURRENT_LIST_DIR}/check_layering.cmake"
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
  if(result EQUAL 0)
    set(got passes)
  elseif(said MATCHES "${file}:2: ")  # for the right reason, with the right line
    set(got fails)
  endif()
  if(NOT got STREQUAL outcome)
    message(SEND_ERROR "expected that ${file} with ${line} ${outcome}; the check said: ${said}")
  endif()
endfunction()

expect(passes cases/model/pose.hpp             "#include <Eigen/Core>")
expect(passes realtime/step.cpp          "#include \"cases/model/patch.hpp\"")
expect(passes compare/engine/engines.cpp        "#include \"realtime/step.hpp\"")
expect(passes reference/simbody_world.cpp "#include <Simbody.h>")
expect(passes reports/cli/handhold.cpp       "#include <CLI/CLI.hpp>")

expect(passes reference/simbody_force.hpp "#include <Simbody.h>")
expect(passes reference/simbody_world.cpp "#include \"reference/simbody_force.hpp\"")

expect(fails reference/reference.hpp     "#include \"reference/simbody_force.hpp\"")
expect(fails compare/engine/engines.cpp         "#include \"reference/simbody_force.hpp\"")
expect(fails cases/model/pose.hpp              "#include \"realtime/step.hpp\"")
expect(fails realtime/step.cpp           "#include \"reference/world.hpp\"")
expect(fails reference/world.cpp         "#include \"realtime/step.hpp\"")
expect(fails compare/judge/gate.cpp            "#include \"reference/world.hpp\"")
expect(fails reports/page.cpp            "#include \"realtime/step.hpp\"")
expect(fails realtime/step.cpp           "#include \"cases/geometry/voxelizer.hpp\"")
expect(fails reference/world.cpp         "#include \"cases/hand/trace.hpp\"")
expect(fails cases/model/pose.hpp        "#include \"cases/hand/trace.hpp\"")
expect(fails cases/model/scene.cpp       "#include <fmt/format.h>")
expect(fails cases/hand/trace.cpp        "#include \"cases/catalogue/case.hpp\"")
expect(fails cases/closed_form/pinch.hpp "#include \"cases/model/scene.hpp\"")
expect(fails realtime/step.cpp           "#include <gsl/gsl_math.h>")
expect(fails realtime/step.cpp           "#include <fmt/format.h>")
expect(fails reference/world.cpp         "#include <Simbody.h>")
expect(fails cases/geometry/repair.cpp   "#include <CGAL/Surface_mesh.h>")
expect(fails cases/hand/trace.cpp        "#  include <toml++/toml.h>")
expect(fails compare/judge/gate.hpp            "#include <fmt/format.h>")
expect(fails reports/page.hpp            "#include <nlohmann/json.hpp>")
expect(fails reports/page.cpp            "#include <CLI/CLI.hpp>")
expect(fails cases/hand/trace.cpp        "#include \"trace.hpp\"")

expect(passes cases/catalogue/l1/x.cpp   "Level level = Level::rigid;  // the reference plays it, realtime does not")
expect(fails cases/catalogue/l1/x.cpp    "const char* engine = \"reference\";")
expect(fails cases/catalogue/l1/x.cpp    "if (engine == \"rigid\") return;")
expect(fails cases/catalogue/l2/x.cpp    "Claim force(const Limit& realtime);")
expect(fails cases/model/scene.cpp       "Limit kinematic_grasp;")
file(REMOVE_RECURSE "${SCRATCH}")
