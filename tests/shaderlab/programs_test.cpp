// A program's text has every byte of its blocks where the .shader file has it.
#include "shaderlab/programs.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "shaderlab/parse.h"
#include "shaderlab/program_lines.h"
#include "shaderlab/sample_shaders.h"

namespace penumbra::shaderlab {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Programs : public testing::Test {
 protected:
  const std::vector<Program>& read(const std::string& text) {
    ParsedShader parsed = parse_shader(text, "a.shader");
    EXPECT_THAT(parsed.diagnostics, IsEmpty());
    shader_ = std::move(parsed.shader);
    programs_ = programs(shader_);
    return programs_;
  }

  Shader shader_;
  std::vector<Program> programs_;
};

TEST_F(Programs, TextIsTheFileWithBlanksOutsideItsBlocks) {
  const std::string text =
      "Shader \"x\" {\n HLSLINCLUDE\tint a;\n ENDHLSL\n SubShader { Pass {\n  Cull Off HLSLPROGRAM int b; // "
      "\xC3\xA4\n"
      "\tint c; ENDHLSL } Pass { HLSLPROGRAM int d; ENDHLSL } } }\n";
  ASSERT_THAT(read(text), SizeIs(2));
  const std::string& program = programs_[0].text;
  ASSERT_LE(program.size(), text.size());
  std::string kept;
  for (std::size_t i = 0; i < program.size(); ++i) {
    EXPECT_TRUE(program[i] == text[i] || (program[i] == ' ' && text[i] != '\n')) << i;
    if (program[i] != ' ' && program[i] != '\n') kept += program[i];
  }
  EXPECT_EQ(kept, "\tinta;intb;//\xC3\xA4\tintc;");
}

TEST_F(Programs, OfTheSamplesKeepEveryPlace) {
  for (const std::string& sample : all_samples())
    for (const Program& program : read(sample)) expect_places_of_the_file(program, sample);
}

TEST_F(Programs, AnIncludeBlockAfterTheProgramComesFirstAndSaysItsLine) {
  const std::string text =
      "Shader \"x\" {\nSubShader { Pass { HLSLPROGRAM int b;\nENDHLSL } }\n\n  HLSLINCLUDE int late;\n  "
      "ENDHLSL\n}\n";
  ASSERT_THAT(read(text), SizeIs(1));
  expect_places_of_the_file(programs_[0], text);
  const std::string& program = programs_[0].text;
  EXPECT_LT(program.find("int late;"), program.find("int b;"));
  EXPECT_EQ(std::count(program.begin(), program.end(), '#'),
            1);  // the program has to move back, the include does not
}

TEST_F(Programs, ADirectiveStartsALineEvenWhenItsBlockStartsInTheMiddleOfOne) {
  const std::string text =
      "Shader \"x\" { SubShader { Pass { HLSLINCLUDE int a; ENDHLSL HLSLPROGRAM #define B 1\nENDHLSL } } }";
  ASSERT_THAT(read(text), SizeIs(1));
  expect_places_of_the_file(programs_[0], text);
  const std::vector<Line> lines = code_lines(programs_[0].text);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_EQ(lines[1].number, 1);
  EXPECT_EQ(lines[1].text.find_first_not_of(' '), text.find("#define"));
}

TEST_F(Programs, IncludeBlocksGoIntoProgramsOfTheirLanguageWhereverTheyStand) {
  const std::string text =
      "Shader \"x\" {\nCGINCLUDE\nint cg;\nENDCG\nSubShader {\nHLSLINCLUDE\nint inner;\nENDHLSL\nPass "
      "{\nCGPROGRAM\n"
      "int a;\nENDCG\n}\n}\nSubShader {\nPass {\nHLSLPROGRAM\nint b;\nENDHLSL\n}\nPass {\nGLSLPROGRAM\nint "
      "c;\nENDGLSL\n} } }";
  ASSERT_THAT(read(text), SizeIs(3));
  const auto code = [&](int i) {
    std::string joined;
    for (const Line& line : code_lines(programs_[static_cast<std::size_t>(i)].text)) joined += line.text;
    return joined;
  };
  EXPECT_EQ(code(0), "int cg;int a;");
  EXPECT_EQ(code(1), "int inner;int b;");
  EXPECT_EQ(code(2), "int c;");
  EXPECT_TRUE(programs_[0].implicit_includes);
  EXPECT_FALSE(programs_[1].implicit_includes);
  EXPECT_FALSE(programs_[2].implicit_includes);
  EXPECT_EQ(programs_[2].language, Language::glsl);
}

TEST_F(Programs, KnowWhereTheyStand) {
  ASSERT_THAT(read(kLitSample), SizeIs(2));
  EXPECT_EQ(programs_[0].file, "a.shader");
  EXPECT_EQ(programs_[0].sub_shader_index, 0);
  EXPECT_EQ(programs_[0].pass_index, 0);
  EXPECT_EQ(pass_name(programs_[0]), "Forward");
  EXPECT_EQ(programs_[1].sub_shader_index, 1);
  EXPECT_EQ(pass_name(programs_[1]), "ShadowCaster");
  EXPECT_EQ(programs_[0].sub_shader, &shader_.sub_shaders[0]);
  EXPECT_EQ(programs_[0].shader, &shader_);
  EXPECT_EQ(kLitSample.substr(programs_[1].place.offset, 11), "HLSLPROGRAM");
}

TEST_F(Programs, TagsHoldFromTheInsideOut) {
  ASSERT_THAT(read(kLitSample), SizeIs(2));
  EXPECT_EQ(*effective_tag(programs_[0], "LightMode"), "UniversalForward");
  EXPECT_EQ(*effective_tag(programs_[0], "Queue"), "Geometry+10");
  EXPECT_EQ(*effective_tag(programs_[0], "RenderPipeline"), "UniversalPipeline");
  EXPECT_EQ(effective_tag(programs_[1], "RenderPipeline"), nullptr);
  read(
      "Shader \"x\" { Category { Tags { \"k\"=\"outer\" } Category { Tags { \"k\"=\"inner\" } SubShader { "
      "Pass {"
      " CGPROGRAM ENDCG } } } } }");
  EXPECT_EQ(*effective_tag(programs_.at(0), "k"), "inner");
}

TEST_F(Programs, SurfaceAndRayTracingShadersAreKnownByTheirPragma) {
  ASSERT_THAT(read(kLegacySample), SizeIs(1));
  EXPECT_TRUE(programs_[0].is_surface_shader);
  EXPECT_EQ(programs_[0].pass_index, -1);
  EXPECT_EQ(programs_[0].pass, nullptr);
  EXPECT_EQ(pass_name(programs_[0]), "");
  read(
      "Shader \"x\" { SubShader { Pass { HLSLPROGRAM\n#  pragma raytracing test\n// #pragma surface "
      "s\n/*\n#pragma "
      "surface s\n*/\nENDHLSL } } }");
  EXPECT_TRUE(programs_.at(0).is_ray_tracing);
  EXPECT_FALSE(programs_.at(0).is_surface_shader);
}

}  // namespace
}  // namespace penumbra::shaderlab
