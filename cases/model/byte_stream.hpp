// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace handhold {

/// CRC-32 (IEEE 802.3) of some bytes.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

/// Appends values as little-endian bytes: this program runs on little-endian machines only (checked at compile time).
class ByteWriter {
 public:
  template <class T>
  void value(const T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&x), sizeof x);
  }
  void text(const std::string& s) {
    value<std::uint64_t>(s.size());
    bytes_.append(s);
  }
  template <class T>
  void list(const std::vector<T>& items) {
    value<std::uint64_t>(items.size());
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads what ByteWriter wrote. Running past the end sets `failed` and gives zeros; a list is never longer than the
/// bytes that are left.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  void value(T& x) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::string_view bytes = take(sizeof x);
    if (!failed_) std::memcpy(static_cast<void*>(&x), bytes.data(), sizeof x);
  }
  void text(std::string& s) { s = std::string(take(count(1))); }
  template <class T>
  void list(std::vector<T>& items) {
    const std::uint64_t n = count(sizeof(T));
    const std::string_view bytes = take(n * sizeof(T));
    items.resize(failed_ ? 0 : n);
    if (!items.empty()) std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] bool done() const { return !failed_ && rest_.empty(); }

 private:
  std::string_view take(std::uint64_t n) {
    failed_ |= n > rest_.size();
    if (failed_) return {};
    const std::string_view bytes = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return bytes;
  }
  std::uint64_t count(std::size_t each) {
    std::uint64_t n = 0;
    value(n);
    failed_ |= n > rest_.size() / each;
    return failed_ ? 0 : n;
  }

  std::string_view rest_;
  bool failed_ = false;
};

}  // namespace handhold
