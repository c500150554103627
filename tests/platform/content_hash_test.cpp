#include "platform/content_hash.h"

#include <gtest/gtest.h>

namespace penumbra::platform {
namespace {

TEST(ContentHash, OfNothingIsTheAlgorithmsPublishedValue) {
  // The hash is BLAKE2b's of 256 bits, without a key, for empty input.
  EXPECT_EQ(ContentHash().hex(), "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
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
