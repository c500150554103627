// One mistake in an include gives one message, at the place of the mistake.
#include <gtest/gtest.h>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

struct Breakage {
  const char* name;
  const char* include;  // the broken text of part.hlsl
  int line;
  int column;
  const char* message;
};

class OneMistake : public testing::TestWithParam<Breakage> {};

TEST_P(OneMistake, GivesOneMessageAtItsPlace) {
  const ShaderFiles files;
  files.write("part.hlsl", GetParam().include);
  files.write("main.hlsl", compute_shader("Twice(float(id.x))", "#include \"part.hlsl\"\n"));
  const CompileResult result = compile(files.request("main.hlsl"));
  EXPECT_TRUE(result.spirv.empty());
  ASSERT_EQ(result.diagnostics.size(), 1U);
  const hlsl::Diagnostic& diagnostic = result.diagnostics.front();
  EXPECT_EQ(diagnostic.file, files.path("part.hlsl").string());
  EXPECT_EQ(diagnostic.line, GetParam().line);
  EXPECT_EQ(diagnostic.column, GetParam().column);
  EXPECT_EQ(diagnostic.message, GetParam().message);
  EXPECT_EQ(diagnostic.severity, hlsl::Severity::error);
}

const Breakage breakages[] = {
    {"StrayDollar", "float Twice(float x)\n{\n    return x $ 2.0;\n}\n", 3, 14, "unexpected token '$'"},
    {"StrayAt", "float Twice(float x)\n{\n    return @x;\n}\n", 3, 12, "unexpected token '@'"},
    {"StrayBackquote", "float Twice(float x)\n{`\n    return x;\n}\n", 2, 2, "unexpected token '`'"},
    {"MissingSemicolon", "float Twice(float x)\n{\n    return 2.0 * x\n}\n", 3, 19, "expected ';'"},
    {"MissingSemicolonBeforeComment",
     "float Twice(float x)\n{\n    float y = x // half\n    return y + x;\n}\n", 3, 16, "expected ';'"},
    {"MissingSemicolonAtTheEnd", "float Twice(float x) { return 2.0 * x; }\nstruct Pair { float x; }\n", 2,
     25, "expected ';'"},
    {"ExtraBrace", "float Twice(float x)\n{\n    return 2.0 * x;\n}\n}\n", 5, 0,
     "the HLSL front end cannot read on from here"},
    {"MissingParenthesis", "float Twice(float x)\n{\n    return (2.0 * x;\n}\n", 3, 20,
     "expected ')', found ';'"},
    {"UndeclaredName", "float Twice(float x)\n{\n    return factor * x;\n}\n", 3, 12,
     "unknown variable 'factor'"},
    {"UndeclaredNameInsideAnother", "float Twice(float x)\n{\n    return float2(x, x).xy.x * y;\n}\n", 3, 32,
     "unknown variable 'y'"},
    {"UndeclaredFunction", "float Twice(float x)\n{\n    return Double(x);\n}\n", 3, 12,
     "no matching overloaded function found 'Double'"},
    {"OpenComment", "float Twice(float x)\n{\n    return 2.0 * x; /* twice\n}\n", 3, 21,
     "'/*' is never closed"},
    {"OpenIf", "float Twice(float x)\n{\n#if 1\n    return 2.0 * x;\n}\n", 3, 1,
     "'#if' has no '#endif' in this file"},
    {"LooseEndif", "float Twice(float x)\n{\n    return 2.0 * x;\n}\n#endif\n", 5, 1,
     "'#endif' has no '#if' in this file"},
    {"OpenText", "float Twice(float x)\n{\n    return \"1\\\"\", \"2;\n}\n", 3, 19,
     "this text has no closing '\"' on its line"},
    {"ErrorDirective", "#error not for this platform\nfloat Twice(float x) { return x; }\n", 1, 1,
     "'#error': not for this platform"},
    {"WrongType", "float Twice(float x)\n{\n    float3 y = float2(x, x);\n    return y.x;\n}\n", 3, 14,
     "'=': cannot convert from ' temp 2-component vector of float' to ' temp 3-component vector of float'"},
};

INSTANTIATE_TEST_SUITE_P(Kinds, OneMistake, testing::ValuesIn(breakages),
                         [](const testing::TestParamInfo<Breakage>& kind) { return kind.param.name; });

TEST(OneMistakeInTheMainFile, ShowsTheLineAndACaret) {
  const ShaderFiles files;
  files.write("main.hlsl", compute_shader("1.0 $ 2.0"));
  const CompileResult result = compile(files.request("main.hlsl"));
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(format(result.diagnostics.front()), files.path("main.hlsl").string() +
                                                    ":5:22: error: unexpected token '$'\n"
                                                    "        _Out[id.x] = 1.0 $ 2.0;\n"
                                                    "                         ^");
}

}  // namespace
}  // namespace penumbra::shaders
