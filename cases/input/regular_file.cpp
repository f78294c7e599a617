// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/regular_file.hpp"

#include <cerrno>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr off_t largest_file = off_t{512} << 20;

class Descriptor {
 public:
  // Non-blocking, because to open a pipe that nobody writes to would wait for ever.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::string read_regular_file(const std::filesystem::path& file) {
  const auto fail = [&file](const std::string& rule, const char* advice) {
    throw InputError(fmt::format("{}: {} ({})", file.string(), rule, advice));
  };
  const Descriptor descriptor(file);
  if (descriptor.number() < 0) {
    const bool missing = errno == ENOENT || errno == ENOTDIR;
    fail(missing ? "no such file" : "cannot be read", missing ? "check the path" : "check its permissions");
  }
  struct stat status {};
  if (::fstat(descriptor.number(), &status) != 0) fail("cannot be read", "check its permissions");
  if (S_ISDIR(status.st_mode)) fail("is a folder", "give a file, not a folder");
  if (!S_ISREG(status.st_mode)) fail("is a device or a pipe", "write its content to a file first");
  if (status.st_size > largest_file)
    fail(fmt::format("{} MiB, the limit is 512", status.st_size >> 20), "make it smaller");
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::read(descriptor.number(), bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail("ends before its size", "does another program write it at the moment?");
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace handhold
