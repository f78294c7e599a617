// SPDX-License-Identifier: GPL-3.0-or-later
// The program itself, as a user runs it: exit codes, one line of error, files written.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "cases/hand/keyframed_hand.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/model/voxel_file.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct Result {
  int exit_code{};
  std::string out{}, error{};
};

std::string read(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

/// A folder of its own for every test, where the program runs.
class CommandLine : public testing::Test {
 protected:
  CommandLine() {
    std::string name = (fs::temp_directory_path() / "handhold-cli-XXXXXX").string();
    root = ::mkdtemp(name.data());
  }
  ~CommandLine() override { fs::remove_all(root); }

  [[nodiscard]] Result run(const std::string& arguments) const {
    const fs::path out = root / ".out", error = root / ".err";
    const std::string command = "cd '" + root.string() + "' && '" HANDHOLD_EXECUTABLE "' " + arguments + " >'" +
                                out.string() + "' 2>'" + error.string() + "'";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(error)};
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root / name, std::ios::binary) << text;
  }

  fs::path root;
};

class Help : public CommandLine, public testing::WithParamInterface<const char*> {};

TEST_P(Help, ExitsWithZeroAndShowsExamples) {
  const Result result = run(GetParam());
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("Examples:"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Every, Help,
                         testing::Values("--help", "list --help", "suite --help", "run --help", "voxelize --help",
                                         "trace --help", "trace info --help", "trace convert --help", "engines --help",
                                         "export --help", "judge-log --help", "merge --help", "baseline check --help",
                                         "baseline update --help"));

class BadInput : public CommandLine, public testing::WithParamInterface<const char*> {};

TEST_P(BadInput, ExitsWithTwoAndOneLine) {
  write("empty", "");
  write("noise.obj", std::string("v 0 0 0\nf 1 2 3\n\xFF\x00\x01", 19));
  write("noise.json", "{\"frames\": [[");
  write("bad.toml", "name = \"x\"\nunknown_key = 3\n");
  fs::create_directory(root / "full");
  write("full/thesis.tex", "text");
  const Result result = run(GetParam());
  EXPECT_EQ(result.exit_code, 2) << result.out << result.error;
  EXPECT_EQ(result.error.rfind("handhold: error: ", 0), 0u) << result.error;
  EXPECT_EQ(result.error.find('\n'), result.error.size() - 1) << result.error;  // one line, and it ends
}

INSTANTIATE_TEST_SUITE_P(
    Every, BadInput,
    testing::Values("", "nonsense", "--nonsense", "list --nonsense", "list extra",  // words
                    "suite --only C99", "suite --only ''", "suite --frame-rate 0", "suite --frame-rate nan",
                    "suite --frame-rate x",  // numbers
                    "suite --substeps 0", "suite --substeps 1e9", "suite --accuracy -1", "suite --accuracy inf",
                    "suite --no-order=7", "suite --only C01 --out full", "suite --only C01 --out empty",
                    "suite --only C01 --out /proc/x/y",  // places
                    "run", "run missing.toml", "run empty", "run bad.toml", "run .", "run --case C99",
                    "run --case C01/none", "run --case ''", "run bad.toml --case C01", "run --trace empty",
                    "run --mesh empty", "run --trace missing --mesh shape:box", "run --trace empty --mesh shape:box",
                    "run --case C01 --engine bullet", "run --case C01 --duration -1", "run --case C01 --mass 1",
                    "run --case C01 --stiffness nan", "run --case C01 --out empty", "run --case C01 --visual-hand half",
                    "run --case C01 --visual-hand whole",  //
                    "voxelize", "voxelize missing.obj", "voxelize empty", "voxelize noise.obj", "voxelize .",
                    "voxelize shape:", "voxelize shape:potato", "voxelize shape:box,x", "voxelize shape:box,x=1m",
                    "voxelize shape:box,x=-1", "voxelize shape:box --scale 0", "voxelize shape:box --voxel-size -1",
                    "voxelize shape:box,x=1e30", "voxelize shape:box --out no/such/x.hhvox",
                    "voxelize shape:box --sample-spacing 5", "voxelize shape:box --sample-spacing 1 --out x.hhvox",  //
                    "trace", "trace info", "trace info missing", "trace info empty", "trace info noise.json",
                    "trace info .", "trace convert empty out.csv", "trace convert missing",  //
                    "export", "export C99", "export C01", "judge", "judge missing", "judge .", "engines check",
                    "engines check true", "suite --engine mine", "suite --engine mine=true", "judge-log",
                    "judge-log missing", "judge-log empty", "judge-log noise.json", "judge-log .",
                    "judge-log noise.json --engine bullet", "suite --only C01 --shard 3/2",
                    "suite --only C01 --shard 0/2", "suite --only C01 --shard 1/2x", "merge", "merge missing",
                    "merge .", "baseline", "baseline check", "baseline check missing.json",
                    "baseline check bad.toml --from missing", "baseline update new.json --from missing",
                    "suite --only C01 --baseline missing.json", "suite --only C01 --baseline bad.toml"));

TEST_F(CommandLine, TellsWhatMovedSinceTheBaseline) {
  const std::string suite = "suite --only C01 --engines realtime --no-order --no-variants --out ";
  ASSERT_EQ(run(suite + "first").exit_code, 0);
  EXPECT_EQ(run("baseline update b.json --from first --reason short").exit_code, 2);
  EXPECT_EQ(run("baseline update b.json --from first --reason 'the first of all'").exit_code, 0);
  EXPECT_EQ(run("baseline check b.json --from first").exit_code, 0);
  EXPECT_EQ(run(suite + "again --baseline b.json").exit_code, 0);

  const Result finer = run(suite + "finer --substeps 16 --baseline b.json");  // limits are tighter, values move
  EXPECT_EQ(finer.exit_code, 1) << finer.out;
  EXPECT_NE(finer.out.find("Against the baseline: gates: "), std::string::npos) << finer.out;
  EXPECT_NE(read(root / "finer/junit.xml").find("type=\"baseline\""), std::string::npos);
  const Result check = run("baseline check b.json --from finer");
  EXPECT_EQ(check.exit_code, 1);
  EXPECT_NE(check.out.find("tighter"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("handhold baseline update b.json --from finer"), std::string::npos) << check.out;
  EXPECT_EQ(run("baseline update b.json --from finer --reason 'sixteen sub-steps'").exit_code, 0);
  EXPECT_EQ(run("baseline check b.json --from finer").exit_code, 0);
  EXPECT_NE(read(root / "b.json").find("sixteen sub-steps (gates: "), std::string::npos);
}

TEST_F(CommandLine, ABaselineKeepsTheOrdersThatAReportDoesNotHold) {
  const std::string suite = "suite --only A01 --engines realtime --no-variants --out ";
  ASSERT_EQ(run(suite + "with").exit_code, 0);
  ASSERT_EQ(run(suite + "without --no-order --substeps 8").exit_code, 0);
  ASSERT_EQ(run("baseline update b.json --from with --reason 'with its studies'").exit_code, 0);
  ASSERT_NE(read(root / "b.json").find("realtime order"), std::string::npos);
  ASSERT_EQ(run("baseline update b.json --from without --reason 'eight sub-steps'").exit_code, 0);
  EXPECT_NE(read(root / "b.json").find("realtime order"), std::string::npos);
}

TEST_F(CommandLine, ListsWhatThereIs) {
  const Result cases = run("list");
  EXPECT_EQ(cases.exit_code, 0);
  EXPECT_NE(cases.out.find("C01  "), std::string::npos);
  const Result rest = run("list --engines --materials --shapes");
  EXPECT_EQ(rest.exit_code, 0);
  for (const char* wanted : {"realtime", "wood", "mug"}) EXPECT_NE(rest.out.find(wanted), std::string::npos) << wanted;
}

TEST_F(CommandLine, HelpNamesAMaterialThatThereIs) {
  const std::string help = run("run --help").out, option = "mug.obj --material ";
  const std::size_t name = help.find(option) + option.size();
  ASSERT_LT(option.size(), name);
  const std::string material = help.substr(name, help.find('\n', name) - name);
  EXPECT_NE(run("list --materials").out.find("\n" + material + " "), std::string::npos) << material;
}

TEST_F(CommandLine, VersionExitsWithZero) { EXPECT_EQ(run("--version").exit_code, 0); }

TEST_F(CommandLine, SuiteWritesAReportThatAgreesWithItsExitCode) {
  const Result result = run("suite --only C01 --no-order --out report");
  ASSERT_TRUE(result.exit_code == 0 || result.exit_code == 1) << result.error;
  const auto json = nlohmann::json::parse(read(root / "report/results.json"));
  EXPECT_EQ(json["verdict"]["passed"], result.exit_code == 0);
  const auto times = nlohmann::json::parse(std::ifstream(root / "report/times.json"));
  EXPECT_EQ(times["occasion"]["command"], "handhold suite --only C01 --no-order --out report");
  EXPECT_EQ(json["cases"].size(), 1u);
  EXPECT_EQ(result.out.find('\x1b'), std::string::npos);  // no terminal, no colours
  EXPECT_EQ(fs::exists(root / "report/junit.xml"), true);
}

// With one step a frame some limits, which are asymptotic, do not hold yet.
TEST_F(CommandLine, PartsMergeToTheBytesOfOneRun) {
  const std::string suite = "suite --only C01 --engines realtime --no-order --no-variants ";
  ASSERT_EQ(run(suite + "--out whole").exit_code, 0);
  for (const char* part : {"1", "2", "3", "4"}) {  // of three runs: one part is empty
    const Result played = run(suite + "--shard " + part + "/4 --out " + part);
    EXPECT_EQ(played.exit_code, 0) << played.out << played.error;
  }
  EXPECT_EQ(run("merge 1 2 4 --out merged").exit_code, 2);
  const Result merged = run("merge 4 2 1 3 --out merged");
  EXPECT_EQ(merged.exit_code, 0) << merged.out << merged.error;
  EXPECT_EQ(read(root / "merged/results.json"), read(root / "whole/results.json"));
}

TEST_F(CommandLine, AFailedGateGivesExitCodeOne) {
  const Result result = run("suite --only C09,D13,G02 --no-order --substeps 1 --out report");
  EXPECT_EQ(result.exit_code, 1) << result.error;
  EXPECT_GT(nlohmann::json::parse(read(root / "report/results.json"))["verdict"]["failed"], 0);
  EXPECT_NE(result.out.find("Failed gates"), std::string::npos);
}

TEST_F(CommandLine, RunSaysWhatHappenedAndWritesRecordings) {
  const Result result = run("run --case C01/slides --engine realtime --out rec");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("longest slip"), std::string::npos);
  EXPECT_TRUE(fs::exists(root / "rec/realtime/frames.csv"));
}

// A palm comes down on a block, 9 mm too far, and goes up again.
TEST_F(CommandLine, RunSaysUntilWhenTheReferenceMeansSomething) {
  const Result result = run("run --case C01/slides --engine reference");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("this answer means something to the end"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("for edges turn by up to 90 degrees"), std::string::npos) << result.out;
  EXPECT_EQ(run("run --case C01/slides --engine reference --no-horizon").out.find("means something"),
            std::string::npos);
}

TEST_F(CommandLine, RunDrawsTheVisualHandAndWritesItAsATrace) {
  const Eigen::Quaterniond palm_down(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()));
  std::vector<HandKeyframe> way;
  for (const auto& [t, z] : {std::pair{0.2, 0.10}, {0.6, 0.035}, {1.0, 0.10}})
    way.push_back(HandKeyframe::of_curl(t, {palm_down, {0, 0.045, z}}, 0, 0));
  const HandModel model = anatomical_hand();
  write_trace_csv(sample_trace("palm", Side::right, model, keyframed_hand(model, Side::right, way), 0, 1.5, 90),
                  (root / "palm.csv").string());
  const Result result =
      run("run --trace palm.csv --mesh shape:box,x=0.06,y=0.06,z=0.06 --place 0,0,0 --held-until 9 --engine realtime "
          "--visual-hand whole --out rec");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("drawn hand, right"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("500 µm: kept"), std::string::npos) << result.out;
  const Result info = run("trace info rec/realtime/drawn_hand.csv");
  EXPECT_EQ(info.exit_code, 0) << info.error;
  EXPECT_NE(info.out.find("136"), std::string::npos) << info.out;  // 1.5 s at 90 Hz, both ends
}

TEST_F(CommandLine, VoxelizeAgreesWithTheVolumeOfABox) {  // 60 mm cube: 216 cm³
  const Result result = run("voxelize shape:box,x=0.06,y=0.06,z=0.06 --voxel-size 2");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  EXPECT_NE(result.out.find("60.0 x 60.0 x 60.0 mm"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("216 cm³"), std::string::npos) << result.out;
}

TEST_F(CommandLine, VoxelizeWritesAFileOfVoxels) {
  const Result result =
      run("voxelize shape:box,x=0.06,y=0.06,z=0.06 --voxel-size 2 --sample-spacing 60 --out box.hhvox");
  EXPECT_EQ(result.exit_code, 0) << result.error;
  const VoxelFile file = read_voxel_file(root / "box.hhvox");
  EXPECT_EQ(file.field->occupied_count(), 27000u);
  EXPECT_EQ(file.samples_O.size(), 8u);  // its corners
}

TEST_F(CommandLine, JudgeLogSaysWhatNoBodyDoes) {
  std::string resting = R"({"format": "openxr", "objects": {"cube": {"shape": "shape:box"}}})", jumping = resting;
  for (int i = 0; i < 60; ++i) {
    const auto frame = [&](double x) {
      return "\n{\"t\": " + std::to_string(i / 60.0) + R"(, "objects": {"cube": {"position": [)" + std::to_string(x) +
             R"(, 1, 0], "orientation": [0, 0, 0, 1]}}})";
    };
    resting += frame(0);
    jumping += frame(i < 30 ? 0 : 0.25);
  }
  write("resting.jsonl", resting);
  write("jumping.jsonl", jumping);
  const Result rest = run("judge-log resting.jsonl");
  EXPECT_EQ(rest.exit_code, 0) << rest.out << rest.error;
  EXPECT_NE(rest.out.find("nothing that a rigid body"), std::string::npos) << rest.out;
  const Result jump = run("judge-log jumping.jsonl");
  EXPECT_EQ(jump.exit_code, 1) << jump.out << jump.error;
  EXPECT_NE(jump.out.find("jumps 250 mm in one frame"), std::string::npos) << jump.out;
  const nlohmann::json verdict = nlohmann::json::parse(run("judge-log jumping.jsonl --json").out);
  EXPECT_NEAR(verdict["findings"].at(0)["end"].get<double>(), 0.5, 1e-6);
}

TEST_F(CommandLine, OutputThatCannotBeWrittenIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const int status = std::system("'" HANDHOLD_EXECUTABLE "' list >/dev/full 2>/dev/null");
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

TEST_F(CommandLine, CtrlCWritesThePartialReportAndSaysSo) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    (void)::chdir(root.c_str());
    (void)std::freopen(".out", "w", stdout);
    (void)std::freopen(".err", "w", stderr);
    ::execl(HANDHOLD_EXECUTABLE, "handhold", "suite", "--threads", "1", "--out", "report", static_cast<char*>(nullptr));
    std::_Exit(127);
  }
  for (int i = 0;
       i < 600 && std::count(std::istreambuf_iterator<char>(std::ifstream(root / ".err").rdbuf()), {}, '\n') < 2; ++i)
    ::usleep(20000);
  ::kill(child, SIGINT);  // the second run has begun, so the first is judged
  int status{};
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1) << read(root / ".err");
  const auto json = nlohmann::json::parse(read(root / "report/results.json"));
  EXPECT_EQ(json["verdict"]["interrupted"], true);
  EXPECT_EQ(json["verdict"]["passed"], false);
  EXPECT_NE(read(root / ".out").find("Interrupted, so this is no pass"), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
