#include "validation/waiting_units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::validation {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// There are three graphics APIs of two variants, one API after the other, as sources are read.
WaitingUnits two_variants() {
  WaitingUnits waiting;
  for (std::size_t unit = 0; unit < 6; ++unit) waiting.add(unit % 2 == 0 ? "even" : "odd", unit);
  return waiting;
}

std::vector<std::size_t> all_for(unsigned worker, WaitingUnits& waiting) {
  std::vector<std::size_t> units;
  while (const std::optional<std::size_t> unit = waiting.next(worker)) units.push_back(*unit);
  return units;
}

TEST(WaitingUnits, AWorkerGetsAVariantToItsEnd) {
  WaitingUnits waiting = two_variants();
  EXPECT_EQ(waiting.size(), 6u);
  EXPECT_EQ(waiting.next(0), 0u);
  EXPECT_EQ(waiting.next(1), 1u);
  EXPECT_EQ(waiting.next(1), 3u);
  EXPECT_EQ(waiting.next(0), 2u);
  EXPECT_EQ(waiting.next(1), 5u);
  EXPECT_EQ(waiting.size(), 1u);
  EXPECT_EQ(waiting.next(1), 4u) << "another worker's, which has not begun it";
  EXPECT_EQ(waiting.next(0), std::nullopt);
}

TEST(WaitingUnits, OneWorkerGetsEverything) {
  WaitingUnits waiting = two_variants();
  EXPECT_THAT(all_for(0, waiting), ElementsAre(0, 2, 4, 1, 3, 5));
  EXPECT_EQ(waiting.size(), 0u);
}

TEST(WaitingUnits, WhatIsPutFirstGoesToWhoeverAsks) {
  WaitingUnits waiting = two_variants();
  EXPECT_EQ(waiting.next(0), 0u);
  waiting.put_first(0);
  EXPECT_EQ(waiting.size(), 6u);
  EXPECT_EQ(waiting.next(7), 0u);
  EXPECT_THAT(all_for(0, waiting), UnorderedElementsAre(1, 2, 3, 4, 5));
}

TEST(WaitingUnits, GraphicsApisOfAVariantAreOne) {
  CompileUnit vulkan;
  vulkan.file = "a.shader";
  vulkan.pass = "Forward";
  vulkan.keywords = {"_A"};
  vulkan.compile.entry = "Fragment";
  CompileUnit metal = vulkan;
  metal.targets = {"msl23"};
  metal.compile.defines = {{"SHADER_API_METAL", "1"}};
  EXPECT_EQ(variant_of(metal), variant_of(vulkan));
  CompileUnit other = vulkan;
  other.keywords = {"_B"};
  EXPECT_NE(variant_of(other), variant_of(vulkan));
  other = vulkan;
  other.compile.stage = hlsl::Stage::vertex;
  EXPECT_NE(variant_of(other), variant_of(vulkan));
}

}  // namespace
}  // namespace penumbra::validation
