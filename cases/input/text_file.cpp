// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/text_file.hpp"

#include <filesystem>

#include "cases/input/gzip.hpp"
#include "cases/input/regular_file.hpp"
#include "cases/input/text_encoding.hpp"

namespace handhold {
namespace {

constexpr std::size_t largest_file = std::size_t{512} << 20;  // half an hour of a hand takes a tenth of it

}  // namespace

std::string read_text_file(const std::string& path) {
  std::string text = read_regular_file(path);
  if (is_gzip(text)) text = gunzip(text, largest_file, path);
  return plain_text(std::move(text));
}

std::string stem_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return clean_text(file.substr(0, file.find('.')));
}

}  // namespace handhold
