// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/log/object_log.hpp"

#include <gtest/gtest.h>

#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/expect_input_error.hpp"
#include "tests/cases/input/sample_joints.hpp"
#include "tests/cases/input/trace_fixtures.hpp"

namespace handhold {
namespace {

using nlohmann::json;

/// A closing hand beside a cube that rises, y up, one line a frame.
std::string sample_lines(const json& head_objects, const char* unit = "m") {
  json recording = test::closing_recording();
  std::string lines = json{{"format", "openxr"}, {"unit", unit}, {"objects", head_objects}}.dump() + "\n";
  int i = 0;
  for (json& frame : recording["frames"]) {
    frame["objects"]["cube"] = {{"position", {0.1, 1 + 0.01 * i++, -0.3}}, {"orientation", {0, 0, 0, 1}}};
    lines += frame.dump() + "\n";
  }
  return lines;
}

const json cube{{"cube", {{"shape", "shape:box"}, {"mass", 0.2}, {"friction", 0.5}}}};

TEST(ObjectLog, ReadsObjectsAndHandsInOneFrame) {
  const test::TemporaryFile file("log.jsonl", sample_lines(cube));
  const ObjectLog log = read_object_log(file.path());
  ASSERT_EQ(log.t.size(), 12u);
  ASSERT_EQ(log.objects.size(), 1u);
  const LoggedObject& object = log.objects[0];
  EXPECT_EQ(object.shape, "shape:box");
  EXPECT_EQ(*object.mass, 0.2);
  EXPECT_EQ(*object.mu_static, 0.5);
  // y up: (x, y, z) -> (x, -z, y).
  EXPECT_TRUE(object.X_WO[3]->p.isApprox(Eigen::Vector3d(0.1, 0.3, 1.03), 1e-12));
  ASSERT_TRUE(log.trace.has_value());
  EXPECT_EQ(log.trace->t.size(), 12u);
  EXPECT_NEAR(log.trace->hands[0].samples[0].X_WP[palm].p.z(), 1.2, 0.05);
}

TEST(ObjectLog, IsReadAsARecordingOfHandsToo) {
  const test::TemporaryFile file("log.jsonl", sample_lines(cube));
  EXPECT_EQ(read_trace(file.path()).t.size(), 12u);
}

TEST(ObjectLog, NamesWhatIsWrong) {
  const auto read = [](const std::string& text) {
    const test::TemporaryFile file("log.jsonl", text);
    (void)read_object_log(file.path());
  };
  expect_input_error([&] { read(sample_lines({{"cub", {{"shape", "shape:box"}}}})); }, {"did you mean 'cub'"});
  expect_input_error([&] { read(sample_lines({{"cube", {{"mas", 1}}}})); }, {"mass"});
  expect_input_error([&] { read(sample_lines({{"cube", {{"mass", -1}}}})); }, {"mass -1"});
  expect_input_error([&] { read(sample_lines(json::object())); }, {"the head names no object"});
}

}  // namespace
}  // namespace handhold
