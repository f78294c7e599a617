// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/gzip.hpp"

#include <array>
#include <new>

#include <fmt/format.h>
#include <zlib.h>

#include "cases/model/input_error.hpp"

namespace handhold {

bool is_gzip(std::string_view bytes) { return bytes.substr(0, 3) == "\x1f\x8b\x08"; }

std::string gunzip(std::string_view bytes, std::size_t most, const std::string& path) {
  constexpr int gzip_window = 15 + 16;  // zlib's way to ask for the largest window and gzip's header
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib only reads it
  stream.avail_in = uInt(bytes.size());
  std::string out;
  int status = Z_OK;
  while (status == Z_OK && out.size() <= most) {
    std::array<char, 1 << 16> piece;
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = uInt(piece.size());
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (out.size() > most) throw InputError(fmt::format("{}: more than {} MiB unpacked (cut it)", path, most >> 20));
  if (status == Z_STREAM_END) return out;
  throw InputError(fmt::format("{}: the gzip file is damaged or cut off (fetch it again)", path));
}

}  // namespace handhold
