// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/deflate.hpp"

#include <array>
#include <stdexcept>

#include <zlib.h>

#include "cases/model/input_error.hpp"

namespace handhold::reports {
namespace {

constexpr int raw_window = -15;  // the largest window, without zlib's header
constexpr std::size_t piece = 1 << 16;

/// Points the stream at `bytes`, which zlib only reads.
void feed(z_stream& stream, std::string_view bytes) {
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
}

/// Appends what one call of `step` yields; returns its status.
template <class Step>
int append(z_stream& stream, std::string& out, Step step) {
  std::array<char, piece> buffer;
  stream.next_out = reinterpret_cast<Bytef*>(buffer.data());
  stream.avail_out = uInt(buffer.size());
  const int status = step(stream);
  out.append(buffer.data(), buffer.size() - stream.avail_out);
  return status;
}

}  // namespace

std::string deflated(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, raw_window, 9, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("zlib cannot start");
  feed(stream, bytes);
  std::string out;
  while (append(stream, out, [](z_stream& s) { return deflate(&s, Z_FINISH); }) == Z_OK) continue;
  deflateEnd(&stream);
  return out;
}

std::string inflated(std::string_view bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, raw_window) != Z_OK) throw std::runtime_error("zlib cannot start");
  feed(stream, bytes);
  std::string out;
  int status = Z_OK;
  while (status == Z_OK) status = append(stream, out, [](z_stream& s) { return inflate(&s, Z_NO_FLUSH); });
  inflateEnd(&stream);
  if (status != Z_STREAM_END)
    throw InputError("packed data: is damaged or cut off (write the report that holds it again)");
  return out;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return k < bytes.size() ? unsigned(static_cast<unsigned char>(bytes[k])) : 0;
    };
    const unsigned three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    out += digits[three >> 18 & 63];
    out += digits[three >> 12 & 63];
    out += i + 1 < bytes.size() ? digits[three >> 6 & 63] : '=';
    out += i + 2 < bytes.size() ? digits[three & 63] : '=';
  }
  return out;
}

}  // namespace handhold::reports
