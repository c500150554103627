// Tests missing returns: what is put there, and what must stay.
#include <gmock/gmock.h>

#include "preparation/after_pass.h"
#include "preparation/passes.h"

namespace penumbra::preparation {
namespace {

TEST(MissingReturns, OfTexturesAndSamplersGoWhereNothingCallsThem) {
  const auto run = after<return_from_empty_functions>;
  EXPECT_EQ(run("SamplerState f() { } Texture2D<float4> g(int i) { } float h();"), "float h();");
  const std::string called = "SamplerState f() { } float4 h(Texture2D t) { return t.Sample(f(), 0); }";
  EXPECT_EQ(run(called), called);
}

}  // namespace
}  // namespace penumbra::preparation
