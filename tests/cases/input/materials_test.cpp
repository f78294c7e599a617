// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/scene/materials.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "cases/input/nearest_name.hpp"
#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

// Zhang & Mak 1999 print 0.37 for nylon and 0.61 for silicone; Buchholz et al. 1988 0.38 for aluminium, 0.61 for
// sandpaper.
TEST(Materials, StaticCoefficientIsTheSources) {
  EXPECT_EQ(material("nylon").friction().mu_static, 0.37);
  EXPECT_EQ(material("silicone").friction().mu_static, 0.61);
  EXPECT_EQ(material("aluminium").friction().mu_static, 0.38);
  EXPECT_EQ(material("sandpaper").friction().mu_static, 0.61);
}

TEST(Materials, EveryEntryCanBeSimulatedAndSaysWhereItIsFrom) {
  for (const Material& m : materials()) {
    EXPECT_NO_THROW(validate(m.friction())) << m.name;
    EXPECT_LE(m.friction().mu_dynamic, m.friction().mu_static) << m.name;
    EXPECT_FALSE(m.source.empty()) << m.name;
    EXPECT_GT(m.density, 100) << m.name;    // no foam ...
    EXPECT_LT(m.density, 10000) << m.name;  // ... and nothing heavier than steel in the table
    EXPECT_EQ(m.evidence == Evidence::assumed, m.source.substr(0, 2) == "no") << m.name;
  }
}

TEST(Materials, AreInOrderOfNameWithoutDoubles) {
  const auto before = [](const Material& a, const Material& b) { return a.name < b.name; };
  EXPECT_TRUE(std::is_sorted(materials().begin(), materials().end(), before));
  const auto same = [](const Material& a, const Material& b) { return a.name == b.name; };
  EXPECT_EQ(std::adjacent_find(materials().begin(), materials().end(), same), materials().end());
}

TEST(Materials, UnknownNameListsTheNames) {
  expect_input_error([] { (void)material("unobtainium"); }, {"'unobtainium'", "aluminium", "wood"});
}

// Textbook distance: kitten -> sitting is 3.
TEST(NearestName, FindsTheLeastEditDistance) {
  EXPECT_EQ(nearest_name("sitting", {"banana", "kitten"}), "kitten");
  EXPECT_EQ(nearest_name("freeze_until", {"held_until", "mass"}), "held_until");
  EXPECT_EQ(nearest_name("qqqq", {"mass", "name"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace handhold
