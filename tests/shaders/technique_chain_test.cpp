// What a chain may be: kinds, their order, their scales, and the message for every chain that cannot be run.
#include "shaders/technique_chain.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace penumbra::shaders {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

Technique chain(const std::vector<std::pair<std::string, int>>& passes, bool screen = true) {
  Technique technique;
  technique.name = "made up";
  technique.screen = screen;
  for (const auto& [kind, scale] : passes) {
    TechniquePass pass;
    pass.kind = kind;
    pass.scale = scale;
    technique.chain.push_back(pass);
  }
  return technique;
}

std::string problem(const std::vector<std::pair<std::string, int>>& passes, bool screen = true) {
  const ChainProblem found = chain_problem(chain(passes, screen));
  return found.text + " | " + found.way_out;
}

TEST(TechniqueChain, EveryChainThatCanBeRunIsTaken) {
  EXPECT_EQ(problem({{"resolve", 1}}, false), " | ");
  EXPECT_EQ(problem({{"resolve", 1}}), " | ");
  EXPECT_EQ(problem({{"mask", 4}, {"mask-blur", 4}, {"resolve", 1}}), " | ");
  EXPECT_EQ(problem({{"resolve", 2}, {"upsample", 1}}), " | ");
  EXPECT_EQ(problem({{"mask", 4}, {"mask-blur", 4}, {"resolve", 2}, {"upsample", 1}, {"denoise", 1}}), " | ");
}

TEST(TechniqueChain, WhatCannotBeRunIsSaid) {
  EXPECT_THAT(problem({}), HasSubstr("no resolve pass"));
  EXPECT_THAT(problem({{"denoise", 1}}), HasSubstr("no resolve pass"));
  EXPECT_THAT(problem({{"resolve", 1}, {"denoise", 1}}, false), HasSubstr("write \"screen\": true"));
  EXPECT_THAT(problem({{"resolve", 2}}, false), HasSubstr("write \"screen\": true"));
  EXPECT_THAT(
      problem({{"denoise", 1}, {"resolve", 1}}),
      HasSubstr(
          "'resolve' comes after 'denoise' | the order is mask, mask-blur, resolve, upsample, denoise"));
  EXPECT_THAT(problem({{"resolve", 1}, {"resolve", 1}}), HasSubstr("'resolve' comes after 'resolve'"));
  EXPECT_THAT(problem({{"mask", 4}, {"resolve", 1}}),
              HasSubstr("'mask' and 'mask-blur' must be used together"));
  EXPECT_THAT(problem({{"mask-blur", 4}, {"resolve", 1}}),
              HasSubstr("'mask' and 'mask-blur' must be used together"));
  EXPECT_THAT(problem({{"resolve", 2}}), HasSubstr("'upsample' and a resolve pass of scale 2"));
  EXPECT_THAT(problem({{"resolve", 1}, {"upsample", 1}}),
              HasSubstr("'upsample' and a resolve pass of scale 2"));
  EXPECT_THAT(problem({{"resolve", 3}}), HasSubstr("kind 'resolve' has a scale of 1 or 2, not 3"));
  EXPECT_THAT(problem({{"mask", 2}, {"mask-blur", 4}, {"resolve", 1}}), HasSubstr("scale of 4, not 2"));
}

TEST(TechniqueChain, TheResolvePassIsFoundWhereverItStands) {
  const Technique masked = chain({{"mask", 4}, {"mask-blur", 4}, {"resolve", 1}, {"denoise", 1}});
  EXPECT_EQ(&masked.resolve(), &masked.chain[2]);
  EXPECT_THROW((void)chain({{"mask", 4}}).resolve(), std::logic_error);
  EXPECT_THROW((void)pass_kind("resolv"), std::out_of_range);
}

}  // namespace
}  // namespace penumbra::shaders
