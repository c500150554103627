#include "platform/content_hash.h"

#include <gtest/gtest.h>

namespace penumbra::platform {
namespace {

TEST(ContentHash, OfNothingIsTheAlgorithmsPublishedValue) {
  // XXH3, 128 bits, seed 0, empty input.
  EXPECT_EQ(ContentHash().hex(), "99aa06d3014798d86001c324468d497f");
}

TEST(ContentHash, KeepsTheBoundariesOfWhatItWasGiven) {
  EXPECT_NE(ContentHash().update("ab").update("c").hex(), ContentHash().update("a").update("bc").hex());
  EXPECT_NE(ContentHash().update("").hex(), ContentHash().hex());
}

TEST(ContentHash, OfAnIntegerDoesNotDependOnItsWidth) {
  EXPECT_EQ(ContentHash().update(std::int8_t{-5}).hex(), ContentHash().update(std::int64_t{-5}).hex());
  EXPECT_NE(ContentHash().update(1).hex(), ContentHash().update(1.0).hex());
}

TEST(ContentHash, MayBeReadAndThenContinued) {
  ContentHash hash;
  hash.update("first");
  const std::string early = hash.hex();
  EXPECT_EQ(hash.hex(), early);
  EXPECT_EQ(hash.update(2.5).hex(), ContentHash().update("first").update(2.5).hex());
}

}  // namespace
}  // namespace penumbra::platform
