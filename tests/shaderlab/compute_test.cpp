// Tests the kernels of a .compute file with their macros and places.
#include "shaderlab/compute.h"

#include <gmock/gmock.h>

namespace penumbra::shaderlab {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// The kernels written as "Blur[WIDE=1 FAST]".
std::vector<std::string> kernels(const std::string& text) {
  const ComputeKernels read = compute_kernels(text, "a.compute");
  EXPECT_THAT(read.diagnostics, IsEmpty());
  std::vector<std::string> found;
  for (const Kernel& kernel : read.kernels) {
    std::string defines;
    for (const KernelDefine& define : kernel.defines)
      defines +=
          (defines.empty() ? "" : " ") + define.macro.text + (define.value.empty() ? "" : "=" + define.value);
    found.push_back(kernel.function.text + "[" + defines + "]");
  }
  return found;
}

std::vector<std::string> kernel_messages(const std::string& text, const std::string& file = "a.compute") {
  std::vector<std::string> formatted;
  for (hlsl::Diagnostic& diagnostic : compute_kernels(text, file).diagnostics) {
    diagnostic.source_line.clear();
    formatted.push_back(hlsl::format(diagnostic));
  }
  return formatted;
}

TEST(ComputeKernels, AreAllThatTheFileNames) {
  EXPECT_THAT(
      kernels(
          "#pragma kernel A\r\n  #\tpragma  kernel B WIDE=1 FAST MAIN=B\n#pragma target 5.0\nvoid A() {}\n"),
      ElementsAre("A[]", "B[WIDE=1 FAST MAIN=B]"));
}

TEST(ComputeKernels, OfCommentsAndStringsAreNone) {
  EXPECT_THAT(
      kernels("// #pragma kernel A\n/*\n#pragma kernel B\n*/\nint a; #pragma kernel C\n\"\n#pragma kernel D"),
      ElementsAre("D[]"));
  EXPECT_THAT(kernels("/* one */ #pragma /* two */ kernel A /* three */ B=2 // four"), ElementsAre("A[B=2]"));
  EXPECT_THAT(kernels("\"/*\"\n#pragma kernel A\n// */"), ElementsAre("A[]"));
}

TEST(ComputeKernels, MayBeJoinedFromLines) {
  EXPECT_THAT(kernels("#pragma kernel A \\\n  B=1\n#pragma kernel C"), ElementsAre("A[B=1]", "C[]"));
  EXPECT_THAT(kernels("// \\\n#pragma kernel A\n#pragma kernel B"), ElementsAre("B[]"));
}

// Unity takes the line that ends with a semicolon.
TEST(ComputeKernels, MayEndAsStatements) {
  EXPECT_THAT(kernels("#pragma kernel A;\n#pragma kernel B ; /* b */\n#pragma kernel C WIDE=1;"),
              ElementsAre("A[]", "B[]", "C[WIDE=1]"));
  EXPECT_THAT(
      kernel_messages("#pragma kernel ;"),
      ElementsAre("a.compute:1:16: error: expected the kernel's function after #pragma kernel, found ';'"));
  EXPECT_THAT(
      kernel_messages("#pragma kernel A;B"),
      ElementsAre("a.compute:1:16: error: expected the kernel's function after #pragma kernel, found 'A;B'"));
}

TEST(ComputeKernels, KnowTheirPlaces) {
  const ComputeKernels read = compute_kernels("\n  #pragma kernel Main  WIDE=1", "a.compute");
  ASSERT_THAT(read.kernels, SizeIs(1));
  const Kernel& kernel = read.kernels[0];
  EXPECT_EQ(kernel.place.line, 2);
  EXPECT_EQ(kernel.place.column, 3);
  EXPECT_EQ(kernel.function.place.column, 18);
  EXPECT_EQ(kernel.defines.at(0).macro.place.column, 24);
  EXPECT_EQ(read.text.substr(kernel.defines[0].macro.place.offset), "WIDE=1");
}

TEST(ComputeKernels, MalformedLinesAreSaidWhereTheyGoWrong) {
  EXPECT_THAT(kernel_messages("#pragma kernel"),
              ElementsAre("a.compute:1:15: error: expected the kernel's function after #pragma kernel"));
  EXPECT_THAT(
      kernel_messages("#pragma kernel 2D"),
      ElementsAre("a.compute:1:16: error: expected the kernel's function after #pragma kernel, found '2D'"));
  EXPECT_THAT(
      kernel_messages("#pragma kernel A B = 1"),
      ElementsAre("a.compute:1:20: error: expected MACRO or MACRO=VALUE without blanks for the kernel A, "
                  "found '='"));
  EXPECT_THAT(kernel_messages("#pragma kernel A B=1 B"),
              ElementsAre("a.compute:1:22: error: the kernel A defines B twice"));
}

TEST(ComputeKernels, LineCommentsBesideSeveralKernelsAreAWarning) {
  EXPECT_THAT(
      kernel_messages("#pragma kernel A // first\n#pragma kernel B"),
      ElementsAre(
          "a.compute:1:1: warning: with several kernels Unity's manual allows no // comment on a line "
          "with #pragma kernel"));
}

TEST(ComputeKernels, OfARayTracingShaderAreRefused) {
  for (const std::string file : {"a.raytrace", "A.RayTrace"})
    EXPECT_THAT(
        kernel_messages("#pragma kernel A", file),
        ElementsAre(file + ": error: ray-tracing shaders are not supported: their stages need DXR; leave the "
                           "file out"));
}

}  // namespace
}  // namespace penumbra::shaderlab
