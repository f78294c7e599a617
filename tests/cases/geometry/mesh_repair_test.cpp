// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/mesh_repair.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/mesh_topology.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/geometry/brute_force.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;

void turn(std::array<int, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

Mesh join(Mesh a, const Mesh& b, const Vector3d& offset) {
  const int shift = static_cast<int>(a.vertices.size());
  for (const Vector3d& v : b.vertices) a.vertices.push_back(v + offset);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

// Repairs a copy; the result must be closed, oriented and of the volume given (1e-12: no coordinate may change).
RepairReport expect_repaired(Mesh mesh, double volume, double tolerance = 1e-12) {
  const RepairReport report = repair(mesh);
  EXPECT_TRUE(mesh_topology(mesh).closed_and_oriented());
  EXPECT_NEAR(solid_properties(mesh).volume / volume, 1, tolerance);
  return report;
}

std::string refusal(Mesh mesh) {
  try {
    const RepairReport report = repair(mesh);
    return "accepted: " + report.confidence;
  } catch (const InputError& error) {
    return error.what();
  }
}

class Repair : public testing::Test {
 protected:
  Mesh mug_ = make_mug();
  double volume_ = solid_properties(mug_).volume;
};

TEST_F(Repair, LeavesASoundMeshAlone) {
  Mesh mesh = mug_;
  const RepairReport report = repair(mesh);
  EXPECT_TRUE(report.closed_as_given);
  EXPECT_TRUE(report.oriented_as_given);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.intersecting_pairs, 0u);
  EXPECT_EQ(report.method, "as given");
  EXPECT_EQ(report.confidence, "closed and consistent as given");
  EXPECT_EQ(mesh.triangles.size(), mug_.triangles.size());
}

TEST_F(Repair, TurnsAnInsideOutMesh) {
  for (auto& t : mug_.triangles) turn(t);
  const RepairReport report = expect_repaired(mug_, volume_);
  EXPECT_EQ(report.faces_flipped, mug_.triangles.size());
  EXPECT_FALSE(report.oriented_as_given);
  EXPECT_EQ(report.confidence, "inside out as given, all faces turned: certain");
}

TEST_F(Repair, TurnsBackFlippedFaces) {
  std::mt19937 random(4);
  std::size_t flipped = 0;
  for (auto& t : mug_.triangles) {
    if (random() % 10 > 0) continue;
    turn(t);
    ++flipped;
  }
  const RepairReport report = expect_repaired(mug_, volume_);
  EXPECT_EQ(report.faces_flipped, flipped);
  EXPECT_EQ(report.method, "oriented");
}

TEST_F(Repair, JoinsLoosePoints) {
  Mesh soup;
  for (const auto& t : mug_.triangles) {
    for (const int v : t) soup.vertices.push_back(mug_.vertices[v]);
    const int n = static_cast<int>(soup.vertices.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  const RepairReport report = expect_repaired(soup, volume_);
  EXPECT_EQ(report.points_welded, soup.vertices.size() - mug_.vertices.size());
  EXPECT_TRUE(report.closed_as_given);
}

// As float exporters leave them: 1e-9 m apart. The volume may change by the area times that, relative to 3 mm walls
// 1e-6.
TEST_F(Repair, JoinsNearPoints) {
  Mesh soup;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1e-9, 1e-9);
  for (const auto& t : mug_.triangles) {
    for (const int v : t)
      soup.vertices.push_back(mug_.vertices[v] + Vector3d(noise(random), noise(random), noise(random)));
    const int n = static_cast<int>(soup.vertices.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  EXPECT_TRUE(expect_repaired(soup, volume_, 1e-5).closed_as_given);
}

TEST_F(Repair, DropsDoubledAndDegenerateFaces) {
  const std::size_t faces = mug_.triangles.size();
  mug_.triangles.insert(mug_.triangles.end(), mug_.triangles.begin(), mug_.triangles.begin() + 50);
  for (std::size_t t = faces; t < mug_.triangles.size(); t += 2) turn(mug_.triangles[t]);
  mug_.triangles.push_back({3, 3, 5});
  const RepairReport report = expect_repaired(mug_, volume_);
  EXPECT_EQ(report.duplicate_faces, 50u);
  EXPECT_EQ(report.degenerate_faces, 1u);
  EXPECT_EQ(report.faces_flipped, 0u);
}

/// 20 µm wide, all along one face of a box that is given with points of its own.
TEST_F(Repair, ClosesAHairlineCrack) {
  const Mesh box = make_box({0.06, 0.04, 0.1});
  Mesh cracked = box;
  const double top = 0.05;
  for (auto& t : cracked.triangles) {
    const auto high = [&](int v) { return box.vertices[v].z() > 0.99 * top; };
    if (!high(t[0]) || !high(t[1]) || !high(t[2])) continue;
    for (int& v : t) {
      cracked.vertices.push_back(box.vertices[v] + Vector3d(0, 0, 20e-6));
      v = static_cast<int>(cracked.vertices.size()) - 1;
    }
  }
  const RepairReport report = expect_repaired(cracked, solid_properties(box).volume, 20e-6 / 0.1);
  EXPECT_EQ(report.method, "points joined");
  EXPECT_FALSE(report.closed_as_given);
  EXPECT_NE(report.confidence.find("a crack was closed, its points lay up to 0.05 mm apart"), std::string::npos)
      << report.confidence;
}

/// A face that stands on an edge of the mug, given from both sides: it opens nothing when it goes.
TEST_F(Repair, CutsOffAFinOfTwoSides) {
  const auto first = mug_.triangles[0];
  const int tip = static_cast<int>(mug_.vertices.size());
  mug_.vertices.push_back(mug_.vertices[first[0]] + Vector3d(0, 0, 0.5));
  mug_.triangles.push_back({first[0], first[1], tip});
  mug_.triangles.push_back({first[1], first[0], tip});
  const RepairReport report = expect_repaired(mug_, volume_);
  EXPECT_TRUE(report.closed_as_given);
  EXPECT_EQ(report.duplicate_faces, 2u);
}

/// Two boxes that share a wall, each with a wall of its own: one box.
TEST_F(Repair, AWallBetweenTwoSolidsGoes) {
  const Mesh box = make_box({0.01, 0.02, 0.03});
  Mesh mirrored = box;  // at the face x = 5 mm, so that the wall has the same diagonal from both sides
  for (Vector3d& v : mirrored.vertices) v.x() = 0.01 - v.x();
  for (auto& t : mirrored.triangles) turn(t);
  Mesh two = join(box, mirrored, Vector3d::Zero());
  const RepairReport report = repair(two);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.intersecting_pairs, 0u);
  EXPECT_NEAR(solid_properties(two).volume, 2 * solid_properties(box).volume, 1e-18);
}

/// Every face twice, once from each side: the solid stays.
TEST_F(Repair, ASolidOfTwoSidesStays) {
  const auto faces = mug_.triangles;
  for (auto t : faces) {
    turn(t);
    mug_.triangles.push_back(t);
  }
  EXPECT_EQ(expect_repaired(mug_, volume_).duplicate_faces, faces.size());
}

// Missing triangles of a curved, dense surface: what comes back is nearly what was there.
TEST_F(Repair, FillsSmallHoles) {
  Mesh sphere = make_sphere(0.04, 4);
  const double volume = solid_properties(sphere).volume;
  auto& t = sphere.triangles;
  t.erase(t.begin() + 1000, t.begin() + 1002);
  t.erase(t.begin() + 3000);
  const RepairReport report = expect_repaired(sphere, volume, 1e-3);
  EXPECT_GE(report.holes_filled, 2u);
  EXPECT_FALSE(report.closed_as_given);
  EXPECT_GT(report.volume_uncertainty, 0);
  EXPECT_LT(report.volume_uncertainty, 0.001);
  EXPECT_NE(report.confidence.find("holes filled: volume known to about 0.0"), std::string::npos) << report.confidence;
  EXPECT_EQ(report.method, "holes filled");
}

TEST_F(Repair, FillsHolesOfAFlippedSoup) {
  Mesh sphere = make_sphere(0.04, 4);
  const double volume = solid_properties(sphere).volume;
  sphere.triangles.erase(sphere.triangles.begin() + 1000, sphere.triangles.begin() + 1002);
  for (std::size_t t = 0; t < sphere.triangles.size(); t += 7) turn(sphere.triangles[t]);
  const RepairReport report = expect_repaired(sphere, volume, 1e-3);
  EXPECT_EQ(report.method, "oriented, holes filled");
}

TEST_F(Repair, RefusesHolesThatLeaveTheVolumeOpen) {
  Mesh sphere = make_sphere(0.04, 4);
  auto& t = sphere.triangles;
  const auto high = [&](const auto& f) { return sphere.vertices[f[0]].z() > 0.02; };
  t.erase(std::remove_if(t.begin(), t.end(), high), t.end());
  const std::string text = refusal(sphere);
  EXPECT_NE(text.find("% of the volume open"), std::string::npos) << text;
  EXPECT_NE(refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}}}).find("at least 4"), std::string::npos);
}

TEST_F(Repair, RefusesSheetsAndStrips) {
  // A flat fan, closed into nothing by its own reverse: doubled faces are dropped, a disc remains.
  Mesh disc;
  disc.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  disc.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  EXPECT_NE(refusal(disc).find("accepted"), 0u);
  // A Moebius strip of 12 quadrilaterals.
  Mesh strip;
  const int n = 12;
  for (int i = 0; i < n; ++i) {
    const double turn_angle = 2 * brute::pi * i / n;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(turn_angle / 2);
      strip.vertices.emplace_back(r * std::cos(turn_angle), r * std::sin(turn_angle), s * std::sin(turn_angle / 2));
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    strip.triangles.push_back({a, c, d});
    strip.triangles.push_back({a, d, b});
  }
  EXPECT_NE(refusal(strip).find("accepted"), 0u);
}

TEST_F(Repair, RefusesFinsOnASolid) {
  Mesh box = make_box({0.06, 0.04, 0.02});
  box.vertices.emplace_back(0.1, 0, 0);
  box.triangles.push_back({0, 1, 8});
  const std::string text = refusal(box);
  EXPECT_NE(text.find("more than two faces"), std::string::npos) << text;
}

TEST_F(Repair, KeepsCavities) {
  const Mesh outer = make_box({0.06, 0.06, 0.06});
  Mesh inner = make_box({0.02, 0.02, 0.02});
  const double hollow = std::pow(0.06, 3) - std::pow(0.02, 3);
  EXPECT_EQ(expect_repaired(join(outer, inner, Vector3d::Zero()), hollow).components, 2u);  // turned inward
  for (auto& t : inner.triangles) turn(t);
  EXPECT_EQ(expect_repaired(join(outer, inner, Vector3d::Zero()), hollow).faces_flipped, 0u);
}

TEST_F(Repair, UnitesPiecesThatOverlap) {
  const Mesh box = make_box({0.06, 0.06, 0.06});
  const double overlap = 0.029 * 0.043 * 0.037;
  const RepairReport report =
      expect_repaired(join(box, box, {0.031, 0.017, 0.023}), 2 * std::pow(0.06, 3) - overlap, 1e-12);
  EXPECT_EQ(report.intersecting_pairs, 0u);
  EXPECT_EQ(report.components, 1u);
  EXPECT_EQ(report.method, "pieces united");
  EXPECT_NE(report.confidence.find("overlapping pieces united"), std::string::npos) << report.confidence;
}

TEST_F(Repair, PiecesThatTouchInAPointDoNotPierce) {
  const Mesh box = make_box({0.06, 0.06, 0.06});
  const RepairReport report = expect_repaired(join(box, box, {0.06, 0.06, 0.06}), 2 * std::pow(0.06, 3));
  EXPECT_EQ(report.intersecting_pairs, 0u);
}

/// Far from a piece that pierces itself: that nothing is counted twice between them does not clear it.
TEST_F(Repair, APieceThatPiercesItselfIsNotClearedByAnother) {
  Mesh cone;  // whose tip was drawn out through its base
  cone.vertices = {{-0.03, -0.03, 0}, {0.03, -0.03, 0}, {0.03, 0.03, 0},
                   {-0.03, 0.03, 0},  {0, 0, 0.01},     {0.1, 0, -0.03}};
  cone.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {5, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  Mesh two = join(cone, make_box({0.06, 0.06, 0.06}), {0, 0, 0.5});
  const RepairReport report = repair(two);
  EXPECT_EQ(report.components, 2u);
  EXPECT_GT(report.intersecting_pairs, 0u);
  EXPECT_NE(report.confidence.find("pierce each other"), std::string::npos) << report.confidence;
}

/// One of two that overlap is inside out: their sum is no volume of anything, and which of them is wrong nobody knows.
TEST_F(Repair, RefusesOverlapsThatItCannotUnite) {
  const Mesh box = make_box({0.06, 0.06, 0.06});
  Mesh inside_out = make_box({0.05, 0.05, 0.05});
  for (auto& t : inside_out.triangles) turn(t);
  const std::string text = refusal(join(box, inside_out, {0.031, 0.017, 0.023}));
  EXPECT_NE(text.find("its 2 pieces overlap"), std::string::npos) << text;
}

TEST_F(Repair, AcceptsSolidsThatTouchAlongAnEdge) {
  const Mesh box = make_box({0.06, 0.06, 0.06});
  const RepairReport report = expect_repaired(join(box, box, {0.06, 0.06, 0}), 2 * std::pow(0.06, 3));
  EXPECT_TRUE(report.closed_as_given);
}

TEST_F(Repair, DoesNotPrint) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  (void)refusal(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 2}, {1, 3, 2}, {1, 2, 4}, {0, 2, 4}}});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace handhold
