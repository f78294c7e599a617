// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/packed_recording.hpp"

#include <array>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "cases/model/hand_motion.hpp"
#include "cases/model/input_error.hpp"
#include "reports/data/deflate.hpp"
#include "tests/reports/unpacked.hpp"

namespace handhold::reports {
namespace {

constexpr std::size_t frames = 50;
constexpr double dt = 1.0 / 90;
const nlohmann::json unit{{"lo", -1}, {"step", 2.0 / 65535}};

/// A hand that turns about a slanted axis, more than once.
class TurningHand : public HandMotion {
 public:
  [[nodiscard]] const HandModel& model() const override { return model_; }
  [[nodiscard]] Side side() const override { return Side::right; }
  [[nodiscard]] const std::vector<Interval>& presence() const override { return presence_; }
  [[nodiscard]] std::vector<double> seen() const override { return {}; }
  [[nodiscard]] Pose pose(int phalanx, double t) const override {
    const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
    return {Eigen::Quaterniond(Eigen::AngleAxisd(20 * t, axis)), {0.01 * phalanx, std::sin(t), 0.3}};
  }
  [[nodiscard]] Twist twist(int, double) const override { return {}; }

 private:
  HandModel model_{};
  std::vector<Interval> presence_{{0, 0.4}};
};

Scene scene() {
  Scene out;
  out.bodies.resize(1);
  out.bodies[0].name = "block";
  out.bodies[0].inertia.mass = 0.2;
  out.hands.push_back({std::make_shared<TurningHand>(), {{.phalanx = 2, .p_P = {Eigen::Vector3d(0, -0.01, 0)}}}});
  return out;
}

ContactState contact(int sample, double t) {
  ContactState out{.id = {0, 2, 0, std::uint8_t(sample)}};
  out.mode = sample == 0 ? Mode::stick : Mode::slip;
  out.C_W = {0.02, 0.01 * std::sin(9 * t), 0.5 * t};
  out.f_W = {-3, 0.7 * std::cos(5 * t), 1e-4 * sample};
  return out;
}

/// A body that falls and turns; its first sample touches in the middle only.
Recording recording() {
  Recording out{.engine = "some engine", .scene = "a fall"};
  for (std::size_t k = 0; k < frames; ++k) {
    Frame frame{.t = dt * double(k)};
    const Eigen::Quaterniond R(Eigen::AngleAxisd(8 * frame.t, Eigen::Vector3d::UnitY()));
    frame.bodies.push_back({{R, {0.1, -0.2, -4.905 * frame.t * frame.t}}, {}});
    if (k >= 10 && k < 20) frame.contacts.push_back(contact(0, frame.t));
    frame.contacts.push_back(contact(1, frame.t));
    frame.energy = {.kinetic = 9 * frame.t, .potential = -9 * frame.t, .elastic = 1e-6 * double(k), .dissipated = 3};
    out.frames.push_back(frame);
    if (k > 0) out.frame_time.push_back(1e-5 * double(k));
  }
  out.events = {{.t = 0.1111111, .kind = EventKind::breakaway, .id = {0, 2, 0, 0}},
                {.t = 0.1111112, .kind = EventKind::breakaway, .id = {0, 2, 0, 1}},
                {.t = 0.2, .kind = EventKind::release, .id = {0, 2, 0, 0}}};
  return out;
}

/// All of a packed recording, column by column in the order of the format.
struct Decoded {
  explicit Decoded(const std::string& packed) : in(packed) {
    const auto& h = in.header;
    in.expect(frames * (7 * 2 + 6 * h["contacts"].size() + h["energy"].size() + (h["cost"].is_null() ? 0 : 1)));
    read_pose(hand, h["hands"][0]["scale"]);
    read_pose(body, h["position"]);
    for (std::size_t c = 0; c < h["contacts"].size(); ++c) {
      contacts.emplace_back();
      for (int i = 0; i < 6; ++i) contacts.back().push_back(in.numbers(frames, h[i < 3 ? "anchor" : "force"]));
      modes.push_back(in.bytes(c, frames));
    }
    for (const auto& scale : h["energy"]) energies.push_back(in.numbers(frames, scale));
    if (!h["cost"].is_null()) cost = in.numbers(frames, h["cost"]);
  }

  void read_pose(std::vector<std::vector<double>>& pose, const nlohmann::json& position) {
    for (int i = 0; i < 7; ++i) pose.push_back(in.numbers(frames, i < 3 ? position : unit));
  }

  Unpacked in;
  std::vector<std::vector<double>> hand{}, body{}, energies{};
  std::vector<std::vector<std::vector<double>>> contacts{};
  std::vector<std::vector<int>> modes{};
  std::vector<double> cost{};
};

Decoded packed() {
  Blobs blobs;
  const std::string name = pack_recording(scene(), recording(), blobs);
  return Decoded(blobs.at(name));
}

/// Half a step of the scale, and the rounding of a double.
double bound(const nlohmann::json& scale) { return 0.5 * scale["step"].get<double>() * (1 + 1e-9); }

void expect_pose(const std::vector<std::vector<double>>& columns, std::size_t k, const Pose& X,
                 const nlohmann::json& scale) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(columns[i][k], X.p[i], bound(scale));
  const Eigen::Quaterniond R(columns[3][k], columns[4][k], columns[5][k], columns[6][k]);
  // Four components, each at most half a step of 2 / 65535 off: the angle is at most twice their length.
  EXPECT_LE(R.normalized().angularDistance(X.R), 2 * 2 * bound(unit));
}

TEST(PackedRecording, PosesKeepTheirBounds) {
  const Decoded d = packed();
  const Recording truth = recording();
  const TurningHand hand;
  for (std::size_t k = 0; k < frames; ++k) {
    expect_pose(d.body, k, truth.frames[k].bodies[0].X_WO, d.in.header["position"]);
    expect_pose(d.hand, k, hand.pose(2, truth.frames[k].t), d.in.header["hands"][0]["scale"]);
  }
}

TEST(PackedRecording, AQuaternionStaysOnOneSide) {  // q and -q are one rotation: a jump would cost bytes
  const Decoded d = packed();
  for (std::size_t k = 1; k < frames; ++k) {
    double dot = 0;
    for (int i = 3; i < 7; ++i) dot += d.hand[i][k] * d.hand[i][k - 1];
    EXPECT_GT(dot, 0.9);
  }
}

TEST(PackedRecording, ContactsKeepTheirBoundsAndModes) {
  const Decoded d = packed();
  const Recording truth = recording();
  ASSERT_EQ(d.contacts.size(), 2u);
  for (std::size_t k = 0; k < frames; ++k) {
    const bool touches = k >= 10 && k < 20;
    EXPECT_EQ(d.modes[0][k], touches ? 2 : 0);  // absent, apart, stick, slip
    EXPECT_EQ(d.modes[1][k], 3);
    const ContactState& c = truth.frames[k].contacts.back();
    const Eigen::Vector3d anchor = truth.frames[k].bodies[0].X_WO.inverse() * c.C_W;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(d.contacts[1][i][k], anchor[i], bound(d.in.header["anchor"]));
      EXPECT_NEAR(d.contacts[1][3 + i][k], c.f_W[i], bound(d.in.header["force"]));
    }
  }
}

TEST(PackedRecording, WhatDoesNotBalanceIsTakenBeforeRounding) {
  const Decoded d = packed();
  for (std::size_t k = 0; k < frames; ++k) EXPECT_NEAR(d.energies[5][k], 1e-6 * double(k), 1e-9);
}

TEST(PackedRecording, FrameTimesAndEvents) {
  const Decoded d = packed();
  EXPECT_NEAR(d.cost[10], 1e-4, bound(d.in.header["cost"]));
  EXPECT_EQ(d.in.header["events"], (nlohmann::json{{0.11111, "breakaway", 0, 2, 2}, {0.2, "release", 0, 2, 1}}));
  EXPECT_EQ(d.in.header["t"]["n"], frames);
  EXPECT_NEAR(d.in.header["t"]["dt"].get<double>(), dt, 1e-15);
}

TEST(PackedRecording, UnevenTimesAreKept) {
  Recording uneven = recording();
  uneven.frames[3].t += 1e-4;
  Blobs blobs;
  const Unpacked in(blobs.at(pack_recording(scene(), uneven, blobs)));
  EXPECT_EQ(in.header["t"]["list"][3].get<double>(), uneven.frames[3].t);
}

TEST(PackedRecording, AnEngineWithoutEnergiesOrTimesHasNoColumnsOfThem) {
  Recording bare = recording();
  bare.frame_time.clear();
  for (Frame& frame : bare.frames) frame.energy = {}, frame.contacts.clear();
  Blobs blobs;
  const Unpacked in(blobs.at(pack_recording(scene(), bare, blobs)));
  EXPECT_TRUE(in.header["energy"].empty());
  EXPECT_TRUE(in.header["cost"].is_null());
  EXPECT_EQ(in.size(), 2 * frames * 14);
}

TEST(PackedRecording, ValuesThatAreNotFiniteDoNoHarmToTheOthers) {
  Recording diverged = recording();
  diverged.frames.back().bodies[0].X_WO.p.x() = std::nan("");
  Blobs blobs;
  const Decoded d(blobs.at(pack_recording(scene(), diverged, blobs)));
  EXPECT_NEAR(d.body[2][10], recording().frames[10].bodies[0].X_WO.p.z(), bound(d.in.header["position"]));
}

TEST(PackedRecording, SameBytesForTheSameRecordingAndStoredOnce) {
  Blobs blobs;
  const std::string a = pack_recording(scene(), recording(), blobs), b = pack_recording(scene(), recording(), blobs);
  EXPECT_EQ(a, b);
  EXPECT_EQ(blobs.size(), 1u);
}

TEST(PackedMesh, VerticesAndTriangles) {
  Mesh mesh;
  for (int i = 0; i < 70000; ++i) mesh.vertices.emplace_back(1e-6 * i, std::sin(i), 0.25);
  mesh.triangles = {{0, 1, 2}, {69999, 65536, 3}};
  Blobs blobs;
  Unpacked in(blobs.at(pack_mesh(mesh, blobs)));
  in.expect(3 * 70000 + 2 * 6);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& scale = in.header["scales"][axis];
    const std::vector<double> values = in.numbers(70000, scale);
    for (int i = 0; i < 70000; i += 997) EXPECT_NEAR(values[i], mesh.vertices[i][axis], bound(scale));
  }
  const auto low = in.integers(6), high = in.integers(6);
  EXPECT_EQ(low[3] + 65536 * high[3], 69999);
  EXPECT_EQ(low[4] + 65536 * high[4], 65536);
}

TEST(Deflate, RoundTripsAndRefusesWhatIsCutOff) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += char(i * i % 251);
  EXPECT_EQ(inflated(deflated(text)), text);
  EXPECT_EQ(inflated(deflated("")), "");
  const std::string packed = deflated(text);
  EXPECT_THROW((void)inflated(packed.substr(0, packed.size() / 2)), InputError);
}

TEST(Deflate, Base64OfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace handhold::reports
