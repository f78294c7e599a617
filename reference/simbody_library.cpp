// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/simbody_library.hpp"

#include <cstring>
#include <stdexcept>

namespace handhold::reference::simbody {

void check_library() {
  char built[64] = {};
  SimTK_about_SimTKcommon("debug", int(sizeof built), built);
  const bool library_checks = std::strcmp(built, "debug") == 0;
#ifdef NDEBUG
  const bool we_check = false;
#else
  const bool we_check = true;
#endif
  if (library_checks != we_check)
    throw std::logic_error(
        "Simbody and handhold were built with different NDEBUG: their states differ in memory (see "
        "reference/CMakeLists.txt)");
}

std::string version() {
  int major = 0, minor = 0, build = 0;
  SimTK_version_SimTKcommon(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace handhold::reference::simbody
