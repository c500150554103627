#include "input/mistake.h"

#include <gmock/gmock.h>

#include <map>

#include "input/input_error.h"

namespace penumbra {
namespace {

TEST(Mistake, IsReportedWithItsPlaceAndOtherErrorsAreAsTheyWere) {
  EXPECT_EQ(with_place("a.shader", [] { return 3; }), 3);
  const std::map<int, int> empty;
  EXPECT_THAT([&] { return with_place("a.shader", [&] { return empty.at(1); }); },
              testing::ThrowsMessage<std::logic_error>(testing::StartsWith("a.shader: ")));
  EXPECT_THAT([] { with_place("a.shader", [] { throw InputError("b.json:1", "is wrong"); }); },
              testing::ThrowsMessage<InputError>("b.json:1: is wrong"));
}

}  // namespace
}  // namespace penumbra
