// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace handhold {

/// The input is wrong: a file, an option, a scene. `what()` reads "<what was given>: <the rule> (<what to do>)" on one
/// line, with file and line where there is one: control characters, which a file may have held, are written as blanks.
/// The command line turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string text) : std::runtime_error(of_one_line(std::move(text))) {}

 private:
  static std::string of_one_line(std::string text) {
    for (char& c : text) {
      if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    }
    return text;
  }
};

}  // namespace handhold
