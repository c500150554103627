// ESSL whose copies of another precision are out of scope is found, and one without them is emitted instead.
#include "shaders/target_corrections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shaders/compile.h"
#include "shaders/cross_compile.h"

namespace penumbra::shaders {
namespace {

TEST(PrecisionCopies, AreInScopeOrLost) {
  EXPECT_FALSE(reads_lost_copy(""));
  EXPECT_FALSE(reads_lost_copy("void main() { int mp_copy_7 = _7; { x = mp_copy_7; } y = mp_copy_7; }"));
  EXPECT_TRUE(reads_lost_copy("void main() { { int mp_copy_7 = _7; } y = mp_copy_7; }"));
  EXPECT_TRUE(reads_lost_copy("void main() { for (;_7 < 3;) { y = float(hp_copy_7_1); } }"));
  EXPECT_TRUE(reads_lost_copy("void main() { if (mp_copy_7 == 1) { } }"));
  EXPECT_FALSE(reads_lost_copy("void main() { int other_mp_copy_7; x = other_mp_copy_7; }"));
  EXPECT_FALSE(
      reads_lost_copy("} } void f() { int mp_copy_7 = 1; } void g() { int mp_copy_7 = 1; x = mp_copy_7; }"));
}

CompileResult compiled(const std::string& text) {
  CompileRequest request;
  request.file = "loop.hlsl";
  request.text = text;
  request.stage = hlsl::Stage::fragment;
  return compile(request);
}

// SPIRV-Cross copies the counter at the loop's head and reads the copy after the loop.
TEST(PrecisionCopies, OfALoopsCounterDoNotGetLost) {
  const CompileResult loop = compiled(R"(float4 Main(float4 u : U, min16float4 k : K) : SV_Target {
    min16float sum = 0;
    int i = 0;
    [loop] for (; float(i) < u.w; ++i) sum += k.x * (min16float)sin(u.x * (0.25 + i));
    return float4(k.xyz * (sum * i), 1); })");
  ASSERT_FALSE(loop.spirv.empty()) << format(loop.diagnostics.at(0));
  const CrossCompileResult essl = cross_compile(loop.spirv, Target::essl310);
  ASSERT_TRUE(essl.diagnostics.empty()) << format(essl.diagnostics.at(0));
  EXPECT_FALSE(reads_lost_copy(essl.text)) << essl.text;
}

// RelaxedPrecision is decoration 0 of OpDecorate (71) and OpMemberDecorate (72); SPIR-V specification 3.20.
TEST(PrecisionCopies, ModulesKeepAllButTheirPrecision) {
  const SpirvModule header{0x07230203, 0x10300, 0, 9, 0};
  SpirvModule module = header;
  const SpirvModule location{(4U << 16U) | 71U, 7, 30, 0};
  for (const SpirvModule& words :
       {location, SpirvModule{(3U << 16U) | 71U, 7, 0}, SpirvModule{(4U << 16U) | 72U, 8, 1, 0},
        SpirvModule{(4U << 16U) | 72U, 8, 0, 4}})
    module.insert(module.end(), words.begin(), words.end());
  SpirvModule kept = header;
  kept.insert(kept.end(), location.begin(), location.end());
  kept.insert(kept.end(), {(4U << 16U) | 72U, 8, 0, 4});
  EXPECT_EQ(without_relaxed_precision(module), kept);
  EXPECT_EQ(without_relaxed_precision(kept), kept);
  EXPECT_TRUE(without_relaxed_precision({}).empty());
}

}  // namespace
}  // namespace penumbra::shaders
