// The contents of a .shader file come out as the tree says, each thing with its place.
#include "shaderlab/parse.h"

#include <gmock/gmock.h>

#include "shaderlab/sample_shaders.h"

namespace penumbra::shaderlab {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Shader parsed(const std::string& text) {
  ParsedShader result = parse_shader(text, "a.shader");
  EXPECT_THAT(result.diagnostics, IsEmpty()) << hlsl::format(result.diagnostics.front());
  return std::move(result.shader);
}

std::vector<std::string> messages(const std::string& text) {
  std::vector<std::string> formatted;
  for (hlsl::Diagnostic& diagnostic : parse_shader(text, "a").diagnostics) {
    diagnostic.source_line.clear();
    formatted.push_back(hlsl::format(diagnostic));
  }
  return formatted;
}

std::string in_pass(const std::string& commands) {
  return "Shader \"x\" { SubShader { Pass {\n" + commands + "\n} } }";
}

std::vector<Command> commands_of(const std::string& text) {
  return parsed(in_pass(text)).sub_shaders.at(0).passes.at(0).settings.commands;
}

// The command written as "Blend One Zero , One One".
std::string written(const Command& command) {
  std::string text = command.name.text;
  for (const Command::Value& value : command.values)
    text += " " + (value.kind == Command::Value::Kind::property ? "[" + value.text + "]" : value.text);
  return text;
}

TEST(Shader, EverythingAtTheTopIsRead) {
  const Shader shader = parsed(kLitSample);
  EXPECT_EQ(shader.name.text, "Samples/Lit");
  EXPECT_THAT(shader.properties, SizeIs(15));
  EXPECT_THAT(shader.includes, SizeIs(2));
  EXPECT_THAT(shader.sub_shaders, SizeIs(2));
}

TEST(Shader, SubShadersKnowTheirCategoryAndPassesTheirOrder) {
  const Shader shader = parsed(kLitSample);
  ASSERT_THAT(shader.categories, SizeIs(1));
  ASSERT_THAT(shader.sub_shaders, SizeIs(2));
  EXPECT_EQ(shader.sub_shaders[0].category, 0);
  EXPECT_EQ(shader.sub_shaders[1].category, -1);
  const SubShader& sub_shader = shader.sub_shaders[0];
  EXPECT_EQ(*find_tag(sub_shader.settings.tags, "Queue"), "Geometry+10");
  EXPECT_EQ(find_tag(sub_shader.settings.tags, "queue"), nullptr);
  ASSERT_THAT(sub_shader.passes, SizeIs(3));
  EXPECT_EQ(sub_shader.passes[0].name.text, "Forward");
  EXPECT_EQ(sub_shader.passes[1].kind, Pass::Kind::use_pass);
  EXPECT_EQ(sub_shader.passes[1].name.text, "Samples/Lit/SHADOWCASTER");
  EXPECT_EQ(sub_shader.passes[2].kind, Pass::Kind::grab_pass);
  EXPECT_EQ(sub_shader.passes[2].name.text, "_Grabbed");
}

TEST(Shader, EveryPlaceIsWhereItsTextStands) {
  const Shader shader = parsed(kLitSample);
  const auto expect_at = [&](const Name& name) {
    EXPECT_EQ(shader.text.substr(name.place.offset, name.text.size() + 1).find(name.text),
              shader.text[name.place.offset] == '"' ? 1u : 0u)
        << name.text;
    const std::string before = shader.text.substr(0, name.place.offset);
    EXPECT_EQ(name.place.line, 1 + std::count(before.begin(), before.end(), '\n')) << name.text;
    EXPECT_EQ(name.place.column, static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1) << name.text;
  };
  expect_at(shader.name);
  for (const Property& property : shader.properties) expect_at(property.name);
  for (const SubShader& sub_shader : shader.sub_shaders) {
    for (const Command& command : sub_shader.settings.commands) expect_at(command.name);
    for (const Pass& pass : sub_shader.passes) expect_at(pass.name);
  }
}

TEST(Shader, KeywordsAreReadWithoutRegardToCase) {
  const Shader shader = parsed(kLegacySample);
  EXPECT_THAT(shader.properties, SizeIs(2));
  EXPECT_THAT(shader.sub_shaders.at(0).programs, SizeIs(1));
  EXPECT_EQ(*find_tag(shader.sub_shaders[0].settings.tags, "Queue"), "Transparent");
}

TEST(Shader, LineEndingsAndAByteOrderMarkChangeNoPlace) {
  const std::string text = "Shader \"x\"\n{\n  SubShader { Pass { Cull Off } }\n}\n";
  for (const std::string ending : {"\r\n", "\r"}) {
    std::string other = "\xEF\xBB\xBF";
    for (const char c : text) other += c == '\n' ? ending : std::string(1, c);
    const Shader shader = parsed(other);
    EXPECT_EQ(shader.text, text);
    EXPECT_EQ(shader.sub_shaders.at(0).place.line, 3);
  }
}

TEST(Shader, CommentsMayNestOrNot) {
  EXPECT_THAT(messages("/* a /* b */ c */ Shader \"x\" { }"), IsEmpty());
  EXPECT_THAT(messages("/* a /* b */ Shader \"x\" { } /* c */"), IsEmpty());
  EXPECT_THAT(messages("Shader \"x\" { // }\n } // \"\n/**/"), IsEmpty());
  EXPECT_EQ(parsed("Shader \"a // b /* c\" { }").name.text, "a // b /* c");
}

TEST(Shader, StringsHaveNoEscapes) {
  EXPECT_EQ(parsed("Shader \"a\\\" { }").name.text, "a\\");
}

TEST(Properties, TypesAndDefaultsAreThoseWritten) {
  const std::vector<Property> properties = parsed(kLitSample).properties;
  ASSERT_THAT(properties, SizeIs(15));
  std::vector<std::string> types;
  types.reserve(properties.size());
  for (const Property& property : properties) types.push_back(property.type_name);
  EXPECT_THAT(types, ElementsAre("2D", "Color", "Float", "Int", "Range", "Range", "Vector", "2DArray", "Cube",
                                 "3D", "CubeArray", "Any", "Rect", "Integer", "Float"));
  EXPECT_THAT(properties[1].default_numbers, ElementsAre(1, .5, .25, 1));
  EXPECT_THAT(properties[2].default_numbers, ElementsAre(-.15));
  EXPECT_EQ(properties[3].display_name, "Cull (2 = Back)");
  EXPECT_THAT(properties[6].default_numbers, ElementsAre(0, -1, 2));
  EXPECT_THAT(properties[14].default_numbers, ElementsAre(7));
  EXPECT_EQ(properties[13].type, PropertyType::integer);
}

TEST(Properties, AttributesKeepTheirArguments) {
  const std::vector<Property> properties = parsed(kLitSample).properties;
  ASSERT_THAT(properties, SizeIs(15));
  ASSERT_THAT(properties[1].attributes, SizeIs(2));
  EXPECT_EQ(properties[1].attributes[1].name.text, "MainColor");
  EXPECT_EQ(properties[2].attributes.at(0).arguments, "_ALPHATEST_ON");
  EXPECT_EQ(properties[3].attributes.at(0).arguments, "UnityEngine.Rendering.CullMode");
  EXPECT_EQ(properties[14].attributes.at(0).arguments, "Parts (a, b) of \"x]y\"");
}

TEST(Properties, AnAttributeMayHoldAnOddQuoteOrSpanLines) {
  const Shader shader = parsed(
      "Shader \"x\" { Properties { [Header(5\" pipe)] _A (\"a\", Float) = 0\n[Enum(One, 1,\nTwo, 2)] _B "
      "(\"b\", "
      "Float) = 1 } }");
  EXPECT_EQ(shader.properties.at(0).attributes.at(0).arguments, "5\" pipe");
  EXPECT_EQ(shader.properties.at(1).attributes.at(0).arguments, "One, 1,\nTwo, 2");
}

TEST(Properties, ALabelMaySpanLines) {
  const Shader shader = parsed(
      "Shader \"x\" { Properties {\n_A (\"Mode--{\n1,2;\n}\", Float) = 0\n_B (\"B\", Float) = 1\n} SubShader "
      "{ } }");
  ASSERT_EQ(shader.properties.size(), 2U);
  EXPECT_EQ(shader.properties[0].display_name, "Mode--{\n1,2;\n}");
  EXPECT_EQ(shader.properties[1].name.place.line, 5);
}

TEST(Commands, SeveralOnALineArePartedByWhatEachTakes) {
  std::vector<std::string> text;
  for (const Command& command : commands_of(
           "ZTest Always Cull Off ZWrite[_ZWrite] Blend 1 One Zero Blend 2 Off BlendOp 0 Add, Max ColorMask "
           "RGB 3 ColorMask 0 ZClip True Offset 0,-1 Blend Off AlphaToMask On"))
    text.push_back(written(command));
  EXPECT_THAT(text, ElementsAre("ZTest Always", "Cull Off", "ZWrite [_ZWrite]", "Blend 1 One Zero",
                                "Blend 2 Off", "BlendOp 0 Add , Max", "ColorMask RGB 3", "ColorMask 0",
                                "ZClip True", "Offset 0 , -1", "Blend Off", "AlphaToMask On"));
}

TEST(Commands, BlocksHoldTheirOwnCommands) {
  const std::vector<Command> commands = commands_of(
      "Stencil { Ref 2 Comp [_Comp] PassFront Keep ZFailBack IncrSat }\n"
      "SetTexture [_M] { combine texture * previous DOUBLE, one - constant constantColor (1,1,1,.5) }");
  ASSERT_THAT(commands, SizeIs(2));
  std::vector<std::string> text;
  for (const Command& command : commands)
    for (const Command& inner : command.block) text.push_back(written(inner));
  EXPECT_THAT(text, ElementsAre("Ref 2", "Comp [_Comp]", "PassFront Keep", "ZFailBack IncrSat",
                                "combine texture * previous DOUBLE , one - constant",
                                "constantColor ( 1 , 1 , 1 , .5 )"));
}

TEST(Commands, AnUnknownOneIsAnErrorAndTheRestIsRead) {
  EXPECT_THAT(messages(in_pass("Culll Off\nZWrite Off")),
              ElementsAre("a:2:1: error: 'Culll' is not a command of ShaderLab: did you mean 'Cull'?"));
  EXPECT_THAT(messages(in_pass("Zippity 1, 2 { Any { thing } } ZWrite Off")),
              ElementsAre("a:2:1: error: 'Zippity' is not a command of ShaderLab"));
  EXPECT_THAT(messages(in_pass("Stencil { Reff 2 Comp Always }")),
              ElementsAre("a:2:11: error: 'Reff' is not a command of Stencil: did you mean 'Ref'?"));
  const ParsedShader result = parse_shader(in_pass("Culll Off\nZWrite Off"), "a");
  EXPECT_THAT(result.shader.sub_shaders.at(0).passes.at(0).settings.commands, SizeIs(1));
}

TEST(Commands, TakeTheirOwnValuesAlone) {
  EXPECT_THAT(messages(in_pass("Cull Bak")),
              ElementsAre("a:2:6: error: 'Bak' is not a value of Cull: did you mean 'Back'?"));
  EXPECT_THAT(messages(in_pass("Cull \"Back\"")),
              ElementsAre("a:2:6: error: write Cull Back without quotation marks"));
  EXPECT_THAT(
      messages(in_pass("Blend SrcAlpha MinusSrc, One Zero")),
      ElementsAre(HasSubstr("a:2:16: error: 'MinusSrc' is not a value of Blend: it takes One, Zero, ")));
  EXPECT_THAT(messages(in_pass("ZTest LessEqual ZWrite Yes BlendOp Plus ColorMask RGX\nAlphaToMask Maybe")),
              ElementsAre(HasSubstr("a:2:7: error: 'LessEqual' is not a value of ZTest"),
                          HasSubstr("a:2:24: error: 'Yes' is not a value of ZWrite: it takes On, Off"),
                          HasSubstr("a:2:36: error: 'Plus' is not a value of BlendOp"),
                          "a:2:51: error: 'RGX' is not a value of ColorMask: it takes 0 or letters of RGBA",
                          HasSubstr("a:3:13: error: 'Maybe' is not a value of AlphaToMask")));
  EXPECT_THAT(messages(in_pass("Stencil { Ref 1 Comp Alway Pass Replac ZFailBack Keep }")),
              ElementsAre("a:2:22: error: 'Alway' is not a value of Comp: did you mean 'Always'?",
                          "a:2:33: error: 'Replac' is not a value of Pass: did you mean 'Replace'?"));
}

TEST(Commands, WarnOfNumbersThatStandForNothing) {
  EXPECT_THAT(messages(in_pass("Stencil { Ref 300 ReadMask -1 WriteMask 255 Comp 9 Pass 8 }")),
              ElementsAre("a:2:15: warning: '300' is out of range: Ref takes 0 to 255",
                          "a:2:28: warning: '-1' is out of range: ReadMask takes 0 to 255",
                          "a:2:50: warning: '9' is out of range: Comp takes 0 to 8",
                          "a:2:57: warning: '8' is out of range: Pass takes 0 to 7"));
  EXPECT_THAT(messages(in_pass("Cull 9 ZTest 77 ZWrite 2 ColorMask 16")),
              ElementsAre("a:2:6: warning: '9' is out of range: Cull takes 0 to 2",
                          "a:2:14: warning: '77' is out of range: ZTest takes 0 to 8",
                          "a:2:24: warning: '2' is out of range: ZWrite takes 0 to 1",
                          "a:2:36: warning: '16' is out of range: ColorMask takes 0 to 15"));
  EXPECT_THAT(
      messages(in_pass("Cull 2 ZTest 8 ZWrite 1 ColorMask 15 3 Blend 7 10 10 Offset -100, 1e5 Stencil { Ref "
                       "[_Ref] Comp 8 Pass 7 }")),
      ElementsAre());
}

TEST(Commands, ThatLackANumberLeaveTheWordToTheNextCommand) {
  EXPECT_THAT(
      messages(in_pass("Offset 1 BlendOpp Add\nZWrite Off")),
      ElementsAre("a:2:10: error: expected a number for Offset, found 'BlendOpp'",
                  "a:2:10: error: 'BlendOpp' is not a command of ShaderLab: did you mean 'BlendOp'?"));
}

TEST(Commands, WhatUnityReadsAndNoReferenceHasIsAWarning) {
  EXPECT_THAT(
      messages(in_pass("ZTest On")),
      ElementsAre(
          "a:2:7: warning: 'On' is not a comparison, although Unity accepts it: it takes Never, Less, "
          "Equal, LEqual, Greater, NotEqual, GEqual, Always, Off, False, Disabled"));
  const std::string named = "Shader \"x\" { SubShader {\nName \"Face\" Tags { } Pass { Name \"Mine\" } } }";
  EXPECT_THAT(messages(named), ElementsAre("a:2:1: warning: this Name is in no Pass and names nothing"));
  EXPECT_EQ(parse_shader(named, "a").shader.sub_shaders.at(0).passes.at(0).name.text, "Mine");
}

TEST(Commands, ValuesAreReadInAnyCaseAndPropertiesAreNotJudged) {
  EXPECT_THAT(
      messages(in_pass("cull OFF ztest lequal ZTest Off ZClip false Blend 1 one [_D] BlendOp 0 Add, RevSub "
                       "ColorMask rgb 2 ColorMask 0 ColorMask [_M] Cull [_Cull] Conservative True\n"
                       "Stencil { Comp [_C] Pass incrsat Fail DecrWrap } Fog { Mode Exp2 }")),
      ElementsAre());
}

TEST(Warnings, NameTagsWhoseValueDoesNothing) {
  const auto tagged = [](const std::string& tag) {
    return messages("Shader \"x\" { SubShader { Tags {\n" + tag + " } } }");
  };
  EXPECT_THAT(
      tagged("\"Queue\" = \"Transparant+10\""),
      ElementsAre("a:2:11: warning: 'Transparant' is not a known value of the tag Queue: did you mean "
                  "'Transparent'?"));
  EXPECT_THAT(
      tagged("\"RenderPipeline\" = \"UniversalPipline\""),
      ElementsAre("a:2:20: warning: 'UniversalPipline' is not a known value of the tag RenderPipeline: "
                  "did you mean 'UniversalPipeline'?"));
  EXPECT_THAT(tagged("\"DisableBatching\" = \"Yes\""),
              ElementsAre("a:2:21: warning: 'Yes' is not a known value of the tag DisableBatching"));
  EXPECT_THAT(tagged("\"Queue\" = \"geometry - 5\" \"RenderPipeline\" = \"MyOwn\" "
                     "\"RenderPipeline\" = \"UniversalRenderPipeline\" \"RenderType\" = \"Grass\" "
                     "\"LightMode\" = \"MyPass\" \"IgnoreProjector\"=\"true\""),
              ElementsAre());
}

TEST(Warnings, SayWhatIsOdd) {
  EXPECT_THAT(messages("Shader \"x\" { Properties {\n_A(\"a\", Float) = 0\n_A(\"b\", Float) = 0 } }"),
              ElementsAre("a:3:1: warning: the property _A is already declared in line 2"));
  EXPECT_THAT(messages("Shader \"x\" { SubShader { Tags { \"a\"=\"b\", \"c\"=\"d\" } } }"),
              ElementsAre("a:1:40: warning: tags are written without a comma between them"));
  EXPECT_THAT(messages("Shader \"x\" { }\n}"),
              ElementsAre("a:2:1: warning: what follows the end of the Shader is not read"));
  EXPECT_THAT(messages("#line 5\nShader \"x\" { }"),
              ElementsAre("a:1:1: warning: '#line' outside a program is not read"));
  EXPECT_THAT(
      messages("Shader \"x\" {\nCGINCLUDE\nENDCG\nSubShader { Pass { HLSLPROGRAM\nENDHLSL } } }"),
      ElementsAre("a:2:1: warning: CGINCLUDE goes into CGPROGRAM blocks, of which this file has none"));
}

TEST(Warnings, AreNotRepeatedWithoutEnd) {
  std::string commands;
  for (int i = 0; i < 150; ++i) commands += "Zippity Off\n";
  const std::vector<std::string> said = messages(in_pass(commands));
  ASSERT_THAT(said, SizeIs(101));
  EXPECT_EQ(said.back(), "a: error: 50 further messages are left out");
}

TEST(Blocks, EndAtTheWordOutsideCommentsAndStrings) {
  const std::string code =
      " // ENDHLSL\n /* ENDHLSL ENDCG */ int ENDHLSL_ = 1, xENDHLSL; // HLSLPROGRAM\n \"ENDHLSL\" ";
  const Shader shader = parsed(in_pass("HLSLPROGRAM" + code + "endhlsl"));
  const CodeBlock& block = shader.sub_shaders.at(0).passes.at(0).programs.at(0);
  EXPECT_EQ(shader.text.substr(block.begin.offset, block.end.offset - block.begin.offset), code);
  EXPECT_EQ(block.end.line, 4);
  EXPECT_EQ(block.end.column, 12);
}

TEST(Blocks, IncludesMayStandBetweenAnyTwoTokens) {
  const Shader shader = parsed(
      "HLSLINCLUDE int a;\nENDHLSL Shader CGINCLUDE ENDCG \"x\" { SubShader { Tags GLSLINCLUDE ENDGLSL { } "
      "Cull "
      "HLSLINCLUDE\nENDHLSL Off } }");
  EXPECT_THAT(
      shader.includes,
      ElementsAre(Field(&CodeBlock::language, Language::hlsl), Field(&CodeBlock::language, Language::cg),
                  Field(&CodeBlock::language, Language::glsl),
                  AllOf(Field(&CodeBlock::language, Language::hlsl), Field(&CodeBlock::is_include, true))));
  EXPECT_EQ(written(shader.sub_shaders.at(0).settings.commands.at(0)), "Cull Off");
}

TEST(Diagnostics, ShowTheirLineUnlessItIsVeryLong) {
  EXPECT_EQ(parse_shader("Shader\n  17", "a").diagnostics.at(0).source_line, "  17");
  EXPECT_EQ(parse_shader("Shader " + std::string(500, ' ') + "17", "a").diagnostics.at(0).source_line, "");
}

}  // namespace
}  // namespace penumbra::shaderlab
