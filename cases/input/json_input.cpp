// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/json_input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include <fmt/format.h>

#include "cases/input/nearest_name.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using nlohmann::json;

constexpr int deepest = 64;  // recordings have seven levels

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Goes through the text once before the parser sees it: bounds its depth, replaces the numbers that JSON does not
/// have, and puts commas between several values.
class Scan {
 public:
  Scan(std::string_view text, const std::string& path) : text_(text), path_(path) {
    out_.reserve(text.size() + 16);
    while (at_ < text_.size()) step();
  }

  /// One value: itself; several: a list of them.
  [[nodiscard]] std::string result() { return values_ > 1 ? "[" + std::move(out_) + "]" : std::move(out_); }

 private:
  void step() {
    const char c = text_[at_];
    if (c == '"') return copy_string();
    if (is_letter(c) && (at_ == 0 || !std::isalnum(static_cast<unsigned char>(text_[at_ - 1])))) return copy_word();
    if ((c == '{' || c == '[') && depth_++ == 0 && values_++ > 0) out_ += ',';
    if (c == '}' || c == ']') --depth_;
    if (depth_ > deepest) {
      const auto line = 1 + std::count(text_.begin(), text_.begin() + std::ptrdiff_t(at_), '\n');
      throw InputError(fmt::format("{}:{}, byte {}: more than {} levels of lists and objects (is it the right file?)",
                                   path_, line, at_ + 1, deepest));
    }
    out_ += c;
    ++at_;
  }

  void copy_string() {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    end = std::min(end + 1, text_.size());
    out_ += text_.substr(at_, end - at_);
    at_ = end;
  }

  void copy_word() {
    std::size_t end = at_;
    std::string word;
    for (; end < text_.size() && is_letter(text_[end]); ++end)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[end])));
    if (word == "nan" || word == "inf" || word == "infinity") {
      if (!out_.empty() && (out_.back() == '-' || out_.back() == '+')) out_.pop_back();
      out_ += "null";
    } else {
      out_ += text_.substr(at_, end - at_);
    }
    at_ = end;
  }

  std::string_view text_;
  const std::string& path_;
  std::string out_{};
  std::size_t at_{};
  int depth_{}, values_{};
};

/// What others call the members that we know by other names.
const std::map<std::string, std::string>& other_names() {
  static const std::map<std::string, std::string> names{
      {"timestamp", "t"}, {"time", "t"}, {"time_stamp", "t"}, {"ts", "t"}, {"seconds", "t"}};
  return names;
}

std::string suggestion(const std::string& key, const std::vector<std::string>& known) {
  std::string nearest = nearest_name(key, known);
  const auto other = other_names().find(key);
  if (nearest.empty() && other != other_names().end() &&
      std::find(known.begin(), known.end(), other->second) != known.end())
    nearest = other->second;
  return nearest.empty() ? "remove it, or use " + join_names(known) : fmt::format("did you mean \"{}\"?", nearest);
}

}  // namespace

json parse_json(std::string_view text, const std::string& path) {
  const std::string scanned = Scan(text, path).result();
  try {
    json value = json::parse(scanned);
    if (value.is_structured()) return value;
  } catch (const json::parse_error& error) {
    const std::size_t byte = std::min(error.byte, scanned.size());
    const auto line = 1 + std::count(scanned.begin(), scanned.begin() + std::ptrdiff_t(byte), '\n');
    const bool cut = error.byte >= scanned.size();
    throw InputError(fmt::format(
        "{}:{}, byte {}: this is not JSON ({})", path, line, byte,
        cut ? "the text ends too early: the file was cut off, copy it whole" : "the file is damaged: fetch it again"));
  } catch (const json::out_of_range&) {
    throw InputError(fmt::format("{}: a number in it is beyond 1e308 (correct it)", path));
  }
  throw InputError(fmt::format("{}: the JSON text is neither object nor list (is it the right file?)", path));
}

void check_keys(const json& object, const std::vector<std::string>& known, const std::string& where) {
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    throw InputError(fmt::format("{}: \"{}\" is unknown ({})", where, key, suggestion(key, known)));
  }
}

}  // namespace handhold
