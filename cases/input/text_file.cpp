// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/text_file.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "cases/input/gzip.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::size_t largest_file = std::size_t{512} << 20;  // half an hour of a hand takes a tenth of it

}  // namespace

std::string read_text_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(fmt::format("{}: is a folder (name a file)", path));
  }
  if (std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored)) {
    throw InputError(fmt::format("{}: is a device or a pipe (write it to a file first)", path));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read (check the path and the permissions)", path));
  std::string text;
  std::vector<char> block(std::size_t{1} << 20);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > largest_file) throw InputError(fmt::format("{}: more than 512 MiB (cut the recording)", path));
  }
  if (is_gzip(text)) text = gunzip(text, largest_file, path);
  return plain_text(std::move(text));
}

std::string stem_of(const std::string& path) {
  const std::string file = std::filesystem::path(path).filename().string();
  return clean_text(file.substr(0, file.find('.')));
}

}  // namespace handhold
