// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/write_report.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "cases/model/input_error.hpp"
#include "reports/data/junit.hpp"
#include "reports/data/page_data.hpp"
#include "reports/data/table.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> report_files{"index.html", "results.json", "times.json",
                                                       "junit.xml",  "table.txt",    "recordings"};

[[noreturn]] void fail(const fs::path& what, int error) {
  throw InputError(
      fmt::format("{}: cannot be written, {} (choose another place with --out)", what.string(), std::strerror(error)));
}

/// A file descriptor that is closed on every way out.
class File {
 public:
  explicit File(const fs::path& path)
      : path_(path), descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(path_, errno);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  /// On the disk, not only in the cache: a full disk may show only now.
  void finish() {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, errno);  // EINVAL: a pipe or a device
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, errno);
  }

 private:
  fs::path path_;
  int descriptor_;
};

void write_new(const fs::path& path, std::string_view text) {
  File file(path);
  file.write(text);
  file.finish();
}

/// A new folder beside `folder`, removed with all it holds unless kept.
class Staging {
 public:
  explicit Staging(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder.parent_path(), error);
    if (error) fail(folder, error.value());
    std::string name = (folder.parent_path() / ("." + folder.filename().string() + ".partial-XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) fail(folder, errno);
    path_ = name;
    fs::permissions(path_, fs::perms(0755), error);  // mkdtemp makes it private; a report is for all to read
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Without a trailing slash, so that it has a name and a parent.
fs::path plain(const fs::path& folder) {
  const fs::path absolute = fs::absolute(folder).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

void require_replaceable(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(folder, error))) return;
  if (!fs::is_directory(folder, error) || fs::is_symlink(folder, error)) {
    throw InputError(fmt::format("{}: is not a folder (choose another place with --out)", folder.string()));
  }
  fs::directory_iterator entries(folder, error);
  if (error) fail(folder, error.value());
  for (const fs::directory_entry& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (std::find(report_files.begin(), report_files.end(), name) != report_files.end()) continue;
    throw InputError(fmt::format(
        "{}: holds other files ('{}'), and a report replaces its folder as a whole (choose a new or empty folder)",
        folder.string(), name));
  }
}

/// Afterwards `from` holds what `to` held, or is gone if there was nothing.
void exchange(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno == ENOENT) {  // nothing there yet
    if (::rename(from.c_str(), to.c_str()) != 0) fail(to, errno);
    return;
  }
  if (errno != EINVAL && errno != ENOSYS) fail(to, errno);
  const fs::path old = from.string() + ".old";  // a file system that cannot exchange: two steps
  if (::rename(to.c_str(), old.c_str()) != 0) fail(to, errno);
  if (::rename(from.c_str(), to.c_str()) != 0) {
    const int error = errno;
    if (::rename(old.c_str(), to.c_str()) != 0) fail(old, errno);
    fail(to, error);
  }
  std::error_code ignored;
  fs::remove_all(old, ignored);
}

}  // namespace

void check_report_folder(const fs::path& folder) {
  require_replaceable(plain(folder));
  const Staging trial(plain(folder));
}

void make_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, error.value());
  if (!fs::is_directory(folder)) fail(folder, ENOTDIR);
  const fs::path trial = folder / fmt::format(".handhold-{}", ::getpid());
  File(trial).finish();
  fs::remove(trial, error);
}

namespace {

void write_into(const fs::path& folder, const StoredReport& report) {
  write_new(folder / "index.html", page(report));
  write_new(folder / "results.json", report.results);
  write_new(folder / "times.json", report.times);
  if (!report.recordings.empty()) fs::create_directory(folder / "recordings");
  for (const auto& [name, bytes] : report.recordings) write_new(folder / "recordings" / name, bytes);
}

}  // namespace

void write_report(const compare::SuiteResult& result, const fs::path& folder) {
  const fs::path target = plain(folder);
  require_replaceable(target);
  const Staging staging(target);
  write_into(staging.path(), stored_report(result));
  write_new(staging.path() / "junit.xml", junit_xml(result));
  write_new(staging.path() / "table.txt", text_table(result));
  exchange(staging.path(), target);
}

void write_stored_report(const StoredReport& report, const fs::path& folder) {
  const fs::path target = plain(folder);
  require_replaceable(target);
  const Staging staging(target);
  write_into(staging.path(), report);
  exchange(staging.path(), target);
}

void write_file(const fs::path& path, std::string_view text) {
  const fs::path beside = path.string() + fmt::format(".partial-{}", ::getpid());
  try {
    write_new(beside, text);
    if (::rename(beside.c_str(), path.c_str()) != 0) fail(path, errno);
  } catch (...) {
    ::unlink(beside.c_str());
    throw;
  }
}

}  // namespace handhold::reports
