// Whatever the bytes, the readers end soon and what they return holds together.
#include <gtest/gtest.h>

#include <algorithm>

#include "processor_time.h"
#include "sanitized.h"
#include "shaderlab/compute.h"
#include "shaderlab/parse.h"
#include "shaderlab/program_lines.h"
#include "shaderlab/programs.h"
#include "shaderlab/sample_shaders.h"

namespace penumbra::shaderlab {
namespace {

double seconds_of(const std::string& text) {
  ParsedShader parsed;
  const double seconds = processor_seconds([&] { parsed = parse_shader(text, "a"); });
  EXPECT_LE(parsed.diagnostics.size(), 102u);
  return seconds;
}

// The least time of three runs: what else the machine does takes caches away from one of them.
double least_seconds_of(const std::string& text) {
  return std::min({seconds_of(text), seconds_of(text), seconds_of(text)});
}

constexpr std::size_t small_size = 250'000 / sanitizer_reduction;  // bytes
constexpr std::size_t large_size = 4 * small_size;

std::string repeated(const std::string& part, std::size_t bytes) {
  std::string text;
  text.reserve(bytes + part.size());
  while (text.size() < bytes) text += part;
  return text;
}

// Expects what must hold for any input.
void expect_sound(const std::string& text) {
  const ParsedShader parsed = parse_shader(text, "a");
  const auto errors =
      std::count_if(parsed.diagnostics.begin(), parsed.diagnostics.end(),
                    [](const auto& diagnostic) { return diagnostic.severity == hlsl::Severity::error; });
  if (!parsed.complete) {
    EXPECT_EQ(errors, 1);
  }
  const auto lines = 1 + std::count(parsed.shader.text.begin(), parsed.shader.text.end(), '\n');
  for (const hlsl::Diagnostic& diagnostic : parsed.diagnostics) {
    EXPECT_LE(diagnostic.line, lines);
    EXPECT_FALSE(diagnostic.message.empty());
  }
  for (const Program& program : programs(parsed.shader)) {
    expect_places_of_the_file(program, parsed.shader.text);
    EXPECT_NE(program.sub_shader, nullptr);
  }
  for (const Kernel& kernel : compute_kernels(text, "a.compute").kernels)
    EXPECT_FALSE(kernel.function.text.empty());
}

TEST(HostileShaders, EveryPrefixOfASampleIsReadSoundly) {
  for (const std::string& sample : all_samples())
    for (std::size_t length = 0; length < sample.size(); length += sanitizer_reduction)
      expect_sound(sample.substr(0, length));
}

// Four times the text may take about four times as long; quadratic readers would take sixteen times.
TEST(HostileShaders, TimeGrowsWithTheLengthOnly) {
  const std::string pass = "Shader \"x\" { SubShader { Pass {\n";
  const std::vector<std::string> parts{"{",
                                       "/*",
                                       "/* /* */",
                                       "[(",
                                       "[",
                                       "\"\"",
                                       "\"a\n",
                                       "Culll Off ",
                                       "Zip { ",
                                       "Zip {} ",
                                       "a",
                                       "Blend One Zero\n",
                                       "HLSLPROGRAM /* ENDHLSL */ // ENDHLSL\n",
                                       "HLSLINCLUDE\nENDHLSL ",
                                       "#line\n",
                                       "Tags{\"a\"=\"b\"} ",
                                       "SetTexture [a] { combine "};
  for (const std::string& part : parts) {
    const double small = least_seconds_of(pass + repeated(part, small_size));
    const double large = least_seconds_of(pass + repeated(part, large_size));
    EXPECT_LT(large, 0.1 + 10 * small) << part;
    EXPECT_LT(large, 5) << part;
  }
  const std::string properties = "Shader \"x\" { Properties {\n";
  for (const std::string part : {"[A(\"\n", "_A(\"a\",2D)=\"\"{}\n", "[A]", "_A(\"a\",Range(0,1))=0 "})
    EXPECT_LT(seconds_of(properties + repeated(part, large_size)), 5) << part;
}

TEST(HostileShaders, DeepNestingIsRefused) {
  const ParsedShader parsed = parse_shader("Shader \"x\" {" + repeated("Category {", large_size), "a");
  ASSERT_EQ(parsed.diagnostics.size(), 1u);
  EXPECT_EQ(parsed.diagnostics[0].message, "Category is nested in more than 32 others");
}

TEST(HostileShaders, ProgramsThatWouldFillTheMemoryAreRefused) {
  const std::string text =
      "Shader \"x\" { SubShader { Pass {\n" + repeated("HLSLPROGRAM\nENDHLSL\n", 400'000) + "} } }";
  const ParsedShader parsed = parse_shader(text, "a");
  ASSERT_EQ(parsed.diagnostics.size(), 1u);
  EXPECT_EQ(parsed.diagnostics[0].message, "more than " +
                                               std::to_string((std::size_t{256} << 20) / text.size()) +
                                               " programs in a file of this length: split the file");
}

TEST(HostileShaders, AKernelLineOfManyMacrosIsReadInTime) {
  constexpr int macros = 100'000 / sanitizer_reduction;
  std::string text = "#pragma kernel A";
  for (int i = 0; i < macros; ++i) text += " M" + std::to_string(i) + "=1";
  ComputeKernels read;
  EXPECT_LT(processor_seconds([&] { read = compute_kernels(text, "a.compute"); }), 5.0);
  EXPECT_EQ(read.kernels.at(0).defines.size(), std::size_t{macros});
}

}  // namespace
}  // namespace penumbra::shaderlab
