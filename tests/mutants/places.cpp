// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutants/places.hpp"

#include <filesystem>
#include <fstream>
#include <regex>

namespace handhold::mutants {
namespace fs = std::filesystem;

std::map<std::string, std::string> places(const std::string& root) {
  static const std::regex planted("DEFECT\\((\\w+),");
  std::map<std::string, std::string> out;
  for (const char* folder : {"cases", "realtime", "reference", "compare", "reports"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(root) / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      for (int number = 1; std::getline(file, line); ++number)
        for (std::sregex_iterator i(line.begin(), line.end(), planted), end; i != end; ++i)
          out.emplace((*i)[1], fs::relative(entry.path(), root).string() + ":" + std::to_string(number));
    }
  return out;
}

}  // namespace handhold::mutants
