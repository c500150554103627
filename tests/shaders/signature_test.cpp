// Tests what the signature of an entry point says, of every stage.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;

// The element written as "TEXCOORD0 float2" or "out COLOR1 uint4 x3": an array or a matrix takes several.
std::string described(const SignatureElement& element) {
  const char* const types[] = {"float", "int", "uint", "other"};
  std::string text = element.output ? "out " : "";
  if (element.per_patch) text += "patch ";
  text += element.semantic + " " + types[static_cast<int>(element.type)];
  if (element.components > 0) text += std::to_string(element.components);
  if (element.count > 1) text += " x" + std::to_string(element.count);
  if (element.location < 0) text += " built-in";
  if (element.read) text += " read";
  if (element.line > 0) text += " at " + element.file + ":" + std::to_string(element.line);
  return text;
}

std::vector<std::string> signature(const std::string& hlsl, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "stages.hlsl";
  request.text = hlsl;
  request.stage = stage;
  request.prepare = true;
  const CompileResult result = compile(request);
  EXPECT_FALSE(result.spirv.empty()) << hlsl << "\n"
                                     << (result.diagnostics.empty()
                                             ? ""
                                             : hlsl::format(result.diagnostics.front()));
  std::vector<std::string> all;
  for (const SignatureElement& element : result.signature) all.push_back(described(element));
  return all;
}

constexpr const char* vertex_struct =
    "struct V { float4 p : SV_POSITION; float2 uv : TexCoord; nointerpolation uint id : Id; float3 n[2] : "
    "NORMAL2;\n"
    "float4x4 m : MAT; };\n";

TEST(Signature, OutputsHaveTypesAndPlaces) {
  EXPECT_THAT(
      signature(
          std::string(vertex_struct) +
              "V Main(float4 p : POSITION, uint i : SV_VertexID) { V o = (V)0; o.p = p + i; return o; }",
          hlsl::Stage::vertex),
      ElementsAre("out SV_POSITION float4 built-in at stages.hlsl:1", "out TEXCOORD0 float2 at stages.hlsl:1",
                  "out ID0 uint1 at stages.hlsl:1", "out NORMAL2 float3 at stages.hlsl:1",
                  "out NORMAL3 float3 at stages.hlsl:1", "out MAT0 float x4 at stages.hlsl:2",
                  "POSITION0 float4 read at stages.hlsl:3", "SV_VERTEXID uint1 built-in at stages.hlsl:3"));
}

TEST(Signature, InputsAreReadByWhatRemainsOfTheProgram) {
  EXPECT_THAT(
      signature("float4 Main(float2 uv : TEXCOORD4, int id : Id, float dead : DEAD, float unused : UNUSED,\n"
                "float3 list[2] : LIST1) : SV_Target { float d = 2 * dead; return uv.x + id + list[id].x; }",
                hlsl::Stage::fragment),
      ElementsAre("out SV_TARGET float4 at stages.hlsl:2", "TEXCOORD4 float2 read at stages.hlsl:1",
                  "ID0 int1 read at stages.hlsl:1", "DEAD0 float1 at stages.hlsl:1",
                  "UNUSED0 float1 at stages.hlsl:1", "LIST1 float3 x2 read at stages.hlsl:2"));
}

// Control points and vertices are arrays around the values of one.
TEST(Signature, GeometryAndTessellationHaveThoseOfOneVertex) {
  const std::string two = "struct V { float4 p : SV_POSITION; float3 list[2] : LIST; };\n";
  const std::string patch =
      two + "struct F { float e[3] : SV_TessFactor; float i : SV_InsideTessFactor; float3 x : EXTRA; };\n";
  const std::vector<std::string> of_vertex{"LIST0 float3", "LIST1 float3"};
  const auto has = [](const std::vector<std::string>& all, const std::string& begin) {
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& one) { return one.starts_with(begin); });
  };
  const auto geometry =
      signature(two +
                    "[maxvertexcount(3)] void Main(triangle V t[3], inout TriangleStream<V> s)\n"
                    "{ for (int i = 0; i < 3; i++) s.Append(t[i]); }",
                hlsl::Stage::geometry);
  const auto hull =
      signature(patch +
                    "F Patch(InputPatch<V, 3> p) { F f; f.e[0] = f.e[1] = f.e[2] = 1; f.i = 1; f.x = "
                    "p[0].p.xyz; return f; }\n"
                    "[domain(\"tri\")] [partitioning(\"integer\")] [outputtopology(\"triangle_cw\")]\n"
                    "[patchconstantfunc(\"Patch\")] [outputcontrolpoints(3)]\n"
                    "V Main(InputPatch<V, 3> p, uint id : SV_OutputControlPointID) { return p[id]; }",
                hlsl::Stage::hull);
  const auto domain =
      signature(patch +
                    "[domain(\"tri\")] V Main(F f, const OutputPatch<V, 3> p, float3 b : SV_DomainLocation)\n"
                    "{ V o = p[0]; o.list[0] += f.x; return o; }",
                hlsl::Stage::domain);
  for (const std::string& value : of_vertex)
    for (const std::vector<std::string>& all : {geometry, hull, domain}) {
      EXPECT_TRUE(has(all, value)) << testing::PrintToString(all);
      EXPECT_TRUE(has(all, "out " + value)) << testing::PrintToString(all);
    }
  EXPECT_TRUE(has(hull, "out patch EXTRA0 float3"));
  EXPECT_TRUE(has(domain, "patch EXTRA0 float3 read"));
}

}  // namespace
}  // namespace penumbra::shaders
