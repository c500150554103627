// One broken character gives one error, at the place a person would mend, with what to write there.
#include <gtest/gtest.h>

#include "shaderlab/parse.h"

namespace penumbra::shaderlab {
namespace {

struct Broken {
  const char* text;
  const char* message;  // "line:column: what"
};

constexpr Broken kBroken[] = {
    {"", "1:1: expected Shader \"Name\", found the end of the file"},
    {"Shadr \"x\" { }", "1:1: expected Shader \"Name\", found 'Shadr'"},
    {"Shader Samples/Lit { }", "1:8: expected the shader's name in quotes, found 'Samples'"},
    {"Shader \"x\"\nProperties { }", "2:1: expected '{' after the shader's name, found 'Properties'"},
    {"Shader \"x {\n}", "1:8: this string is not closed on its line"},
    {"Shader \"x\" {\n/* no end\n}", "2:1: this comment is not closed: no */ follows"},
    {"Shader \"x\" {\nSubShader {\nPass { }\n",
     "4:1: expected '}' for the SubShader of line 2, found the end of the file"},
    {"Shader \"x\" {\nSubShader {\nPass {\nCull Off\nPass { }\n} }",
     "5:1: 'Pass' is not allowed in the Pass of line 3: is its '}' missing?"},
    {"Shader \"x\" {\nSubShader {\nPass { }\nFallback Off\n}",
     "4:1: 'Fallback' is not allowed in the SubShader of line 2: is its '}' missing?"},
    {"Shader \"x\" {\nSubShader { } }\nSubShader { Pass { } }",
     "3:1: the Shader ended before this 'SubShader', and what follows would be lost: is there one '}' too "
     "many?"},
    {"Shader \"x\" { SubShader { Pass {\nHLSLPROGRAM\nfloat a;\n} } }",
     "2:1: HLSLPROGRAM is not closed: no ENDHLSL follows"},
    {"Shader \"x\" { SubShader { Pass {\nHLSLPROGRAM\n// ENDHLSL\n} } }",
     "2:1: HLSLPROGRAM is not closed: no ENDHLSL follows (the one in line 3 is inside a comment)"},
    {"Shader \"x\" { SubShader { Pass {\nHLSLPROGRAM\n\n  ENDCG\n} } }",
     "4:3: ENDCG does not close the HLSLPROGRAM of line 2: write ENDHLSL"},
    {"Shader \"x\" {\nHLSLINCLUDE\nint a;\nSubShader { Pass {\nHLSLPROGRAM\nENDHLSL\n} } }",
     "5:1: the HLSLINCLUDE of line 2 is not closed before this HLSLPROGRAM: write ENDHLSL first"},
    {"Shader \"x\" {\nHLSLPROGRAM\nENDHLSL\n}",
     "2:1: HLSLPROGRAM is in the Shader of line 1: a program belongs in a Pass, a surface shader in a "
     "SubShader"},
    {"Shader \"x\" { SubShader { Pass {\n#pragma vertex Vertex\nENDHLSL } } }",
     "2:1: '#pragma' is outside a program: move it between HLSLPROGRAM and ENDHLSL"},
    {"Shader \"x\" { SubShader { Pass {\nfloat4 a;\n} } }",
     "2:9: ShaderLab has no use for ';' here: shader code belongs between HLSLPROGRAM and ENDHLSL"},
    {"Shader \"x\" { SubShader { Passs {\nHLSLPROGRAM\nENDHLSL } } }",
     "1:26: 'Passs' is not a command of ShaderLab: did you mean 'Pass'? (and its block holds a program)"},
    {"Shader \"x\" { SubShader { Pass { Cull\nZWrite Off } } }",
     "2:1: expected a value for Cull, found 'ZWrite'"},
    {"Shader \"x\" { SubShader { Pass { Blend One } } }", "1:43: expected a value for Blend, found '}'"},
    {"Shader \"x\" { SubShader { Pass { Blend One Zero, One\n} } }",
     "2:1: expected a value for Blend, found '}'"},
    {"Shader \"x\" { SubShader { Pass { ZTest [_ZTest\nCull [_Cull] } } }",
     "1:39: this '[' is not closed: no ']' follows outside parentheses"},
    {"Shader \"x\" { SubShader { Pass { Stencil {\nRef 2 Comp Always\nCull Off",
     "3:9: expected a command or '}' in the Stencil of line 1, found the end of the file"},
    {"Shader \"x\" { SubShader { Pass { Stencil Ref 2 } } }",
     "1:41: expected '{' after Stencil, found 'Ref'"},
    {"Shader \"x\" { SubShader { Pass { Name Forward } } }",
     "1:38: expected the name of the Pass in quotes, found 'Forward'"},
    {"Shader \"x\" { SubShader { Tags { \"Queue\" \"Geometry\" } } }",
     "1:41: expected '=' after the tag \"Queue\", found \"Geometry\""},
    {"Shader \"x\" { SubShader { Tags { \"Queue\" = Geometry } } }",
     "1:43: expected the value of \"Queue\" in quotes, found 'Geometry'"},
    {"Shader \"x\" { SubShader { Tags { Queue = \"Geometry\" } } }",
     "1:33: expected a tag in quotes or '}' in Tags, found 'Queue'"},
    {"Shader \"x\" { SubShader { LOD high } }", "1:30: expected a number for LOD, found 'high'"},
    {"Shader \"x\" { SubShader { UsePass Lit } }",
     "1:34: expected \"Shader/PASSNAME\" for UsePass, in quotes, found 'Lit'"},
    {"Shader \"x\" { Cull Off }",
     "1:14: expected Properties, another item or '}' in the Shader of line 1, found 'Cull'"},
    {"Shader \"x\" { Fallback Diffuse }", "1:23: expected Off or a shader's name in quotes, found 'Diffuse'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Float) = 0\n_B (\"b\" Float) = 0 } }",
     "3:9: expected ',' between label and type of _B, found 'Float'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Flot) = 0 } }",
     "2:10: expected a type for _A (did you mean 'Float'?), found 'Flot'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Matrix4x4) = 0 } }",
     "2:10: expected the type of _A, Float, Range(a, b), Int, Integer, Color, Vector, 2D, 3D, Cube, 2DArray, "
     "CubeArray "
     "or Any, found 'Matrix4x4'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Float)\n_B (\"b\", Float) = 0 } }",
     "3:1: expected '=' and the default of _A, found '_B'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Float) = 1.0f } }",
     "2:19: expected the default of _A, a number without a suffix, found '1.0f'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Color) = (1, 1, 1, 1, 1) } }",
     "2:30: expected ')' after the default of _A, found ','"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Color) = 1 } }",
     "2:19: expected '(' before the default of _A, found '1'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", Range(0)) = 1 } }",
     "2:17: expected ',' between the values of the Range, found ')'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", 2D) = white {} } }",
     "2:16: expected the default texture of _A in quotes, found 'white'"},
    {"Shader \"x\" { Properties {\n_A (\"a\", 2D) = \"white\" {\n_B (\"b\", Float) = 0 } }",
     "3:17: expected '}' for the '{' of line 2 after the default of _A, found '='"},
    {"Shader \"x\" { Properties {\n[Toggle(_A] _A (\"a\", Float) = 0 } }",
     "2:1: this '[' is not closed: no ']' follows outside parentheses"},
    {"Shader \"x\" { Properties {\n[HDR] } }",
     "2:7: expected a property's name after its attributes, found '}'"},
    {"Shader \"x\" { Properties { _A (\"a\", Float) = 0\nSubShader { } }",
     "2:11: expected '(' after the property SubShader, found '{'"},
    {"Shader \"x\" { \x01 }",
     "1:14: ShaderLab has no use for the byte 0x01 here: shader code belongs between HLSLPROGRAM and "
     "ENDHLSL"},
};

TEST(BrokenShaders, GiveOneErrorEachWhereItIs) {
  for (const Broken& broken : kBroken) {
    std::string said;
    const ParsedShader parsed = parse_shader(broken.text, "");
    for (const hlsl::Diagnostic& diagnostic : parsed.diagnostics) {
      if (diagnostic.severity != hlsl::Severity::error) continue;
      said += (said.empty() ? "" : " | ") + std::to_string(diagnostic.line) + ":" +
              std::to_string(diagnostic.column) + ": " + diagnostic.message;
    }
    EXPECT_EQ(said, broken.message) << broken.text;
  }
}

TEST(BrokenShaders, AWholeMessageNamesTheFileAndShowsTheLine) {
  const ParsedShader parsed =
      parse_shader("Shader \"x\"\n{\n\tSubShader {\n\t\tPass { ZWrite }\n\t}\n}", "Lit.shader");
  ASSERT_EQ(parsed.diagnostics.size(), 1u);
  EXPECT_EQ(hlsl::format(parsed.diagnostics[0]),
            "Lit.shader:4:17: error: expected a value for ZWrite, found '}'\n    \t\tPass { ZWrite }\n    "
            "\t\t              ^");
}

TEST(BrokenShaders, KeepWhatStandsBeforeTheError) {
  const ParsedShader parsed =
      parse_shader("Shader \"x\" { SubShader { Pass { Name \"a\" } Pass { Name b } } }", "");
  EXPECT_EQ(parsed.shader.name.text, "x");
  ASSERT_EQ(parsed.shader.sub_shaders.size(), 1u);
  EXPECT_EQ(parsed.shader.sub_shaders[0].passes.at(0).name.text, "a");
}

TEST(BrokenShaders, WarningsBehindTheErrorAreNotSaid) {
  const ParsedShader parsed = parse_shader("Shader \"x\" { Zippity Off\nSubShader { LOD }\n#line 5\n", "");
  ASSERT_EQ(parsed.diagnostics.size(), 2u);
  EXPECT_EQ(parsed.diagnostics[0].severity, hlsl::Severity::warning);
  EXPECT_EQ(parsed.diagnostics[1].severity, hlsl::Severity::error);
}

}  // namespace
}  // namespace penumbra::shaderlab
