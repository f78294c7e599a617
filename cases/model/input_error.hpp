// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace handhold {

/// The input is wrong: a file, an option, a scene. `what()` reads "<what was given>: <the rule> (<what to do>)" on one
/// line, with file and line where there is one. The command line turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace handhold
