// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/write_report.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "cases/model/input_error.hpp"
#include "reports/data/results_json.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

/// A folder of its own for every test, removed afterwards.
class WriteReport : public testing::Test {
 protected:
  WriteReport() {
    std::string name = (fs::temp_directory_path() / "handhold-report-XXXXXX").string();
    root = ::mkdtemp(name.data());
  }
  ~WriteReport() override { fs::remove_all(root); }

  [[nodiscard]] std::size_t entries() const {
    return std::size_t(std::distance(fs::directory_iterator(root), fs::directory_iterator()));
  }

  fs::path root;
};

TEST_F(WriteReport, WritesAllFilesAndLeavesNothingBeside) {
  write_report(sample_result(), root / "a" / "report/");
  for (const char* name : {"index.html", "results.json", "times.json", "junit.xml", "table.txt"})
    EXPECT_GT(fs::file_size(root / "a" / "report" / name), 100u) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(root / "a"), fs::directory_iterator()), 1);
}

TEST_F(WriteReport, ReplacesAnEarlierReport) {
  write_report({}, root / "report");
  write_report(sample_result(), root / "report");
  EXPECT_EQ(read(root / "report/results.json"), results_json(sample_result()));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteReport,
       RefusesAFolderWithOtherFiles) {  // it replaces the folder as a whole: a slip in --out must not delete work
  fs::create_directory(root / "home");
  std::ofstream(root / "home" / "thesis.tex") << "years of work";
  EXPECT_THROW(check_report_folder(root / "home"), InputError);
  EXPECT_THROW(write_report(sample_result(), root / "home"), InputError);
  EXPECT_EQ(read(root / "home" / "thesis.tex"), "years of work");
}

TEST_F(WriteReport, RefusesAFileAndALink) {
  std::ofstream(root / "file") << "text";
  EXPECT_THROW(write_report(sample_result(), root / "file"), InputError);
  EXPECT_THROW(write_report(sample_result(), root / "file" / "below"), InputError);
  fs::create_directory_symlink(root, root / "link");
  EXPECT_THROW(write_report(sample_result(), root / "link"), InputError);
}

TEST_F(WriteReport, AFullDiskLeavesTheOldReport) {  // a limit on the size of files stands for the disk
  write_report({}, root / "report");
  const std::string before = read(root / "report/results.json");
  struct rlimit old {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small { 1000, old.rlim_max };
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_report(sample_result(), root / "report"), InputError);
  EXPECT_THROW(write_file(root / "single", std::string(5000, 'x')), InputError);
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(read(root / "report/results.json"), before);
  EXPECT_EQ(entries(), 1u);  // nor is anything left beside it
}

TEST_F(WriteReport, ErrorsStandOnOneLineAndNameThePlace) {
  try {
    check_report_folder("/proc/handhold/report");
    FAIL() << "no error";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find('\n'), std::string::npos);
    EXPECT_EQ(what.rfind("/proc/handhold/report: cannot be written", 0), 0u) << what;
  }
}

TEST_F(WriteReport, FilesAreReadableByOthers) {
  write_report(sample_result(), root / "report");
  EXPECT_NE(fs::status(root / "report").permissions() & fs::perms::others_exec, fs::perms::none);
}

TEST_F(WriteReport, SingleFileIsReplacedInOneStep) {
  write_file(root / "a.csv", "old");
  write_file(root / "a.csv", "new");
  EXPECT_EQ(read(root / "a.csv"), "new");
  EXPECT_EQ(entries(), 1u);
}

}  // namespace
}  // namespace handhold::reports
