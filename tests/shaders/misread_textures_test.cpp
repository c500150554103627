// The search for textures that are read as another kind ends, whatever the words;
// refused/misread_textures.hlsl and taken/textures.hlsl show what it finds.
#include "shaders/module_problems.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra::shaders {
namespace {

TEST(MisreadTextures, AnyWordsAreRead) {
  EXPECT_THAT(misread_textures({}), testing::IsEmpty());
  EXPECT_THAT(misread_textures({1, 2, 3, 4, 5, 0xFFFF0000U, 7}), testing::IsEmpty());
}

}  // namespace
}  // namespace penumbra::shaders
