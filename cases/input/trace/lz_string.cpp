// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/lz_string.hpp"

#include <cstdint>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::size_t most_output = std::size_t{512} << 20;  // a few bytes can stand for gigabytes

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return c == '=' ? 0 : -1;  // padding reads as zero bits
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Bits of the base64 characters, the most significant first; numbers are stored with their least significant bit
/// first.
class BitReader {
 public:
  BitReader(std::string_view text, const std::string& name) : text_(text), name_(name) {
    while (!text_.empty() && is_space(text_.back())) text_.remove_suffix(1);
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  std::uint32_t read(int bits) {
    std::uint32_t value = 0;
    for (int i = 0; i < bits; ++i) value |= static_cast<std::uint32_t>(read_bit()) << i;
    return value;
  }

  [[noreturn]] void fail(std::string_view rule) const {
    throw InputError(fmt::format("{}, byte {}: {} (the file is damaged: fetch it again)", name_, at_, rule));
  }

 private:
  int read_bit() {
    if (left_ == 0) {
      if (at_ >= text_.size()) fail("the LZString text ends without its end mark");
      value_ = base64_value(text_[at_]);
      if (value_ < 0) fail("this character is not base64");
      ++at_;
      left_ = 6;
    }
    return value_ >> --left_ & 1;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_{};
  int value_{};
  int left_{};
};

/// A phrase of the dictionary is always a stretch of the text written so far.
struct Phrase {
  std::size_t begin{}, size{};
};

std::u16string decode(BitReader& bits) {
  constexpr std::uint32_t character8 = 0, character16 = 1, end = 2;
  std::u16string out;
  std::vector<Phrase> phrases(3);  // the codes above
  int width = 2;
  std::size_t until_wider = 1;  // the first code has 2 bits, then 3
  std::optional<Phrase> previous;
  const auto count_entry = [&] {
    if (--until_wider == 0) until_wider = std::size_t{1} << width++;
  };
  for (;;) {
    std::uint32_t code = bits.read(width);
    if (code == end) return out;
    Phrase phrase;
    if (code == character8 || code == character16) {
      const std::uint32_t c = bits.read(code == character8 ? 8 : 16);
      phrase = {out.size(), 1};
      phrases.push_back(phrase);
      out.push_back(static_cast<char16_t>(c));
      count_entry();
    } else {
      // The phrase that this very code completes: the previous one and its own first character.
      const bool unfinished = code == phrases.size() && previous;
      if (code > phrases.size() || (code == phrases.size() && !previous)) bits.fail("an unknown phrase");
      const Phrase source = unfinished ? Phrase{previous->begin, previous->size + 1} : phrases[code];
      if (out.size() + source.size > most_output) bits.fail("more than 512 MiB of text");
      phrase = {out.size(), source.size};
      for (std::size_t i = 0; i < source.size; ++i) out.push_back(out[source.begin + i]);
    }
    if (previous) {
      phrases.push_back({previous->begin, previous->size + 1});
      count_entry();
    }
    previous = phrase;
  }
}

}  // namespace

std::string decompress_lz_string(std::string_view base64, const std::string& name) {
  BitReader bits(base64, name);
  return to_utf8(decode(bits));
}

}  // namespace handhold
