// Modules that are valid SPIR-V and no valid HLSL are refused at the line, and code that is never run is no
// error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader_files.h"
#include "shaders/compile.h"

namespace penumbra::shaders {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kResources =
    "Texture2D<float4> _Map; SamplerState sampler_Map; SamplerComparisonState _Compare; int _N; int2 "
    "_Texel;\n";

std::vector<std::string> errors(const std::string& text, hlsl::Stage stage) {
  CompileRequest request;
  request.file = "a";
  request.text = kResources + text;
  request.stage = stage;
  const CompileResult result = compile(request);
  EXPECT_EQ(result.spirv.empty(), !result.diagnostics.empty());
  std::vector<std::string> all;
  for (const hlsl::Diagnostic& said : result.diagnostics)
    all.push_back(std::to_string(said.line) + ": " + said.message);
  return all;
}

// `body` begins in line 3.
std::vector<std::string> fragment(const std::string& body) {
  return errors("float4 Main(float4 p : SV_Position) : SV_Target {\n" + body + "\n}\n",
                hlsl::Stage::fragment);
}
std::vector<std::string> vertex(const std::string& body, const std::string& before = "") {
  return errors(before + "float4 Main(float4 p : POSITION) : SV_Position {\n" + body + "\n}\n",
                hlsl::Stage::vertex);
}

TEST(Derivatives, AreOfFragmentProgramsAlone) {
  EXPECT_THAT(
      vertex("return _Map.Sample(sampler_Map, p.xy);"),
      ElementsAre("3: a texture is sampled with derivatives, which a vertex program does not have: use "
                  "SampleLevel or SampleGrad"));
  EXPECT_THAT(vertex("return _Map.SampleBias(sampler_Map, p.xy, 1);"),
              ElementsAre(HasSubstr("3: a texture is")));
  EXPECT_THAT(vertex("return _Map.SampleCmp(_Compare, p.xy, 1);"), ElementsAre(HasSubstr("3: a texture is")));
  EXPECT_THAT(vertex("return ddx(p);"),
              ElementsAre("3: ddx needs derivatives, which a vertex program does not have"));
  EXPECT_THAT(
      vertex("return _Map.CalculateLevelOfDetail(sampler_Map, p.xy);"),
      ElementsAre("3: CalculateLevelOfDetail needs derivatives, which a vertex program does not have"));
  EXPECT_THAT(
      vertex("return Read(p.xy);", "float4 Read(float2 uv) {\nreturn _Map.Sample(sampler_Map, uv); }\n"),
      ElementsAre(HasSubstr("3: a texture is sampled with derivatives")));
  EXPECT_THAT(
      errors("RWTexture2D<float4> _Out;\n[numthreads(8, 8, 1)] void Main(uint3 id : SV_DispatchThreadID) {\n"
             "_Out[id.xy] = _Map.Sample(sampler_Map, id.xy); }\n",
             hlsl::Stage::compute),
      ElementsAre(HasSubstr("4: a texture is sampled with derivatives, which a compute program")));
}

TEST(Derivatives, MayStandWhereNothingReadsThem) {
  const std::string read = "float4 Read(float2 uv) {\nreturn _Map.Sample(sampler_Map, uv); }\n";
  EXPECT_THAT(vertex("return _Map.SampleLevel(sampler_Map, p.xy, 0);", read), IsEmpty());
  EXPECT_THAT(vertex("float4 unused = Read(p.xy);\nif (false) p = Read(p.xy);\nreturn p;", read), IsEmpty());
  EXPECT_THAT(
      vertex("return _Map.SampleCmpLevelZero(_Compare, p.xy, 1) + _Map.SampleGrad(sampler_Map, 0, 0, 0);"),
      IsEmpty());
  EXPECT_THAT(fragment("return ddx(p) + _Map.Sample(sampler_Map, p.xy);"), IsEmpty());
}

TEST(TexelOffsets, AreConstantsFromMinus8To7) {
  EXPECT_THAT(fragment("return _Map.Sample(sampler_Map, p.xy, int2(0, 8));"),
              ElementsAre("3: the offset of a texture read is 8 texels, and must be from -8 to 7"));
  EXPECT_THAT(fragment("return _Map.SampleGrad(sampler_Map, p.xy, 0, 0, int2(-9, 0));"),
              ElementsAre("3: the offset of a texture read is -9 texels, and must be from -8 to 7"));
  EXPECT_THAT(fragment("return _Map.SampleCmpLevelZero(_Compare, p.xy, 0, int2(9, 0));"),
              ElementsAre(HasSubstr("3: the offset of a texture read is 9 texels")));
  EXPECT_THAT(fragment("return _Map.Load(int3(p.xy, 0), int2(8, 1));"),
              ElementsAre(HasSubstr("3: the offset of a texture read is 8 texels")));
  EXPECT_THAT(fragment("return _Map.Sample(sampler_Map, p.xy, _Texel);"),
              ElementsAre(HasSubstr("3: the offset of a texture read must be a constant from -8 to 7; if it "
                                    "depends on a loop counter")));
}

TEST(TexelOffsets, AreFreeForGatherAndMayBeWorkedOut) {
  EXPECT_THAT(
      fragment(
          "return _Map.Gather(sampler_Map, p.xy, int2(9, 0)) + _Map.Sample(sampler_Map, p.xy, int2(-8, 7));"),
      IsEmpty());
  EXPECT_THAT(
      fragment("float4 sum = 0; [unroll] for (int i = -2; i <= 2; ++i) sum += _Map.Sample(sampler_Map, p.xy, "
               "int2(i, 0));\nreturn sum;"),
      IsEmpty());
}

TEST(IntegerDivisions, ByAConstantZeroAreRefused) {
  EXPECT_THAT(fragment("return _N / 0;"), ElementsAre("3: an integer is divided by zero"));
  EXPECT_THAT(fragment("int2 a = _Texel % int2(1, 0);\nreturn a.xyxy;"),
              ElementsAre("3: an integer is divided by zero"));
  EXPECT_THAT(fragment("const uint zero = 3 - 3;\nreturn (uint)_N / zero;"),
              ElementsAre("4: an integer is divided by zero"));
}

TEST(IntegerDivisions, ByZeroAreNoErrorWhereTheyAreNeverMade) {
  EXPECT_THAT(
      fragment(
          "const int zero = 0;\nif (zero != 0) return _N / zero;\nint unused = _N / 0;\nreturn _N / 2.0 / "
          "0.0 + _N % 3;"),
      IsEmpty());
}

TEST(ComparisonSamplers, AreForReadsThatCompare) {
  EXPECT_THAT(fragment("return _Map.Sample(_Compare, p.xy);"),
              ElementsAre(HasSubstr("3: '_Compare' is a comparison sampler and this read does not compare")));
  EXPECT_THAT(fragment("return _Map.SampleCmp(sampler_Map, p.xy, 1);"),
              ElementsAre(HasSubstr("3: a method that compares takes a SamplerComparisonState: declare")));
}

TEST(LostTextures, AreReportedAtTheirLine) {
  EXPECT_THAT(fragment("Texture2D t;\nreturn t.Load(0);"),
              ElementsAre(HasSubstr("4: a texture is read uninitialised")));
}

// `body` begins in line 6.
std::vector<std::string> calling(const std::string& body) {
  return errors(
      "void F(inout float x) { x += 1; }\nvoid G(float a, out float2 b) { b = a; }\n"
      "struct S { float m; float4 n[2]; };\nfloat4 Main(float4 p : SV_Position) : SV_Target {\n" +
          body + "\n}\n",
      hlsl::Stage::fragment);
}

TEST(WrittenArguments, AreNoValues) {
  const auto told = [](const std::string& function, const std::string& argument) {
    return ElementsAre("6: '" + function + "' writes to its argument " + argument +
                       ", which is not an lvalue: pass a variable");
  };
  EXPECT_THAT(calling("F(1.0); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("F(p.x + 1); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("F(-p.x); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("const float k = 2; F(k); return 1;"), told("F", "1"));
  EXPECT_THAT(calling("G(1, float2(1, 2)); return 1;"), told("G", "2"));
}

// HLSL has no objection; glslang crashes.
TEST(WrittenArguments, OfAnotherTypeAreToldInsteadOfCrashing) {
  EXPECT_THAT(calling("int i = 1; F(i); return i;"),
              ElementsAre("6: 'F' writes to its argument 1, which has another type: pass a variable of the "
                          "parameter's type"));
}

TEST(WrittenArguments, AreVariablesAndTheirParts) {
  EXPECT_THAT(calling("float v = 1; F(v); float4 w = 1; F(w.y); F(w[_N]); float a[2] = { 1, 2 }; F(a[_N]);\n"
                      "S s = (S)0; F(s.m); F(s.n[_N].z); int i = 1; float2 g; G(i + 1, g); G(1, w.zy);\n"
                      "return v + w + a[0] + s.n[1] + i + g.xyxy;"),
              IsEmpty());
}

TEST(BitOperators, TakeIntegers) {
  const auto told = [](const std::string& op) {
    return ElementsAre("3: '" + op +
                       "' takes integers, and an operand is a float: convert it with (int), or read its bits "
                       "with asuint()");
  };
  EXPECT_THAT(fragment("return p.x & 1;"), told("&"));
  EXPECT_THAT(fragment("float2 f = p.xy | 1; return f.xyxy;"), told("|"));
  EXPECT_THAT(fragment("return p ^ p;"), told("^"));
  EXPECT_THAT(fragment("return p.x << _N;"), told("<<"));
  EXPECT_THAT(fragment("return p.x >> 1;"), told(">>"));
  EXPECT_THAT(fragment("p.x &= 1; return p;"), told("&"));
  EXPECT_THAT(
      fragment(
          "int i = (int)p.x & 1; uint2 u = asuint(p.xy) >> 3; i |= _N << 2; bool b = (p.x > 1) & (p.y > 2);\n"
          "return i + u.x + b;"),
      IsEmpty());
}

TEST(Loads, TakeTheCoordinatesOfTheirTexture) {
  const auto told = [](const std::string& type, const std::string& given) {
    return ElementsAre("4: this Load takes an " + type +
                       ", the last for the mip level, and its argument has " + given + " components");
  };
  const std::string main = "float4 Main(float4 p : SV_Position) : SV_Target {\n";
  EXPECT_THAT(errors("Texture2DArray<float4> _Layers;\n" + main + "return _Map.Load(int2(p.xy)); }",
                     hlsl::Stage::fragment),
              told("int3", "2"));
  EXPECT_THAT(errors("Texture2DArray<float4> _Layers;\n" + main + "return _Layers.Load(int3(p.xyz)); }",
                     hlsl::Stage::fragment),
              told("int4", "3"));
  EXPECT_THAT(
      errors("Texture2DMS<float4> _Samples; Buffer<float4> _Words; RWTexture2D<float4> _Image; Texture3D "
             "_Volume; Texture1D _Line;\n" +
                 main +
                 "return _Samples.Load(int2(p.xy), 1) + _Words.Load(1) + _Image.Load(int2(p.xy)) + "
                 "_Volume.Load(int4(p)) + _Line.Load(int2(p.xy)) + _Map.Load(int3(p.xy, 0)) + _Map[p.xy]; }",
             hlsl::Stage::fragment),
      IsEmpty());
}

TEST(Registers, AreOfOneResource) {
  const std::string main = "float4 Main(float4 p : SV_Position) : SV_Target {\nreturn ";
  const auto told = [](const std::string& names) {
    return ElementsAre("3: " + names +
                       " are used and have the same register: leave the registers out, as Unity binds by "
                       "name, or give each its own");
  };
  EXPECT_THAT(errors("Texture2D _A[2] : register(t3);\nTexture2D _B : register(t4);\n" + main +
                         "_A[0].Load(0) + _B.Load(0); }",
                     hlsl::Stage::fragment),
              told("'_B' and '_A'"));
  EXPECT_THAT(errors("cbuffer C : register(b1) { float c; }\ncbuffer D : register(b1) { float d; }\n" + main +
                         "c + d; }",
                     hlsl::Stage::fragment),
              told("'D' and 'C'"));
  EXPECT_THAT(errors("Texture2D _A : register(t3), _B : register(t3);\nTexture2D _C : register(t3, space1);\n"
                     "cbuffer C : register(b3) { float c; }\nSamplerState _S : register(s3);\n" +
                         main + "_A.Sample(_S, p.xy) + _C.Load(0) + c; }",
                     hlsl::Stage::fragment),
              IsEmpty())
      << "_B is not used";
}

std::vector<std::string> kernel(const std::string& threads, const std::string& shared,
                                const std::string& body) {
  return errors("RWBuffer<float> _Out; groupshared " + shared + ";\n[numthreads(" + threads +
                    ")]\nvoid Main(uint3 id : SV_GroupThreadID) { " + body + " }\n",
                hlsl::Stage::compute);
}

TEST(Groups, HaveAsManyThreadsAsDirect3DTakes) {
  const auto threads = [](const std::string& count) { return kernel(count, "float s", "_Out[id.x] = 1;"); };
  EXPECT_THAT(threads("32, 32, 2"),
              ElementsAre("3: [numthreads] makes groups of 2048 threads, and Direct3D takes 1024 at most"));
  EXPECT_THAT(threads("1, 1, 65"),
              ElementsAre("3: [numthreads] has 65 threads along z, and Direct3D takes 1 to 64"));
  EXPECT_THAT(threads("1, 0, 1"),
              ElementsAre("3: [numthreads] has 0 threads along y, and Direct3D takes 1 to 1024"));
  EXPECT_THAT(threads("1025, 1, 1"),
              ElementsAre("3: [numthreads] has 1025 threads along x, and Direct3D takes 1 to 1024"));
  EXPECT_THAT(threads("1024, 1, 1"), IsEmpty());
  EXPECT_THAT(threads("4, 4, 64"), IsEmpty());
}

TEST(Groups, Share32KiBAtMost) {
  const std::string body = "s[id.x].v = id.x; GroupMemoryBarrierWithGroupSync(); _Out[id.x] = s[id.y].v.x;";
  const std::string structure = "struct { float3 v; uint k; } s";
  EXPECT_THAT(
      kernel("64, 1, 1", structure + "[2049]", body),
      ElementsAre("2: the groupshared variables take 32784 bytes, and Direct3D has 32768 for a group"));
  EXPECT_THAT(kernel("64, 1, 1", structure + "[2048]", body), IsEmpty());
  EXPECT_THAT(kernel("64, 1, 1", "float4 s[4096]", "_Out[id.x] = 1;"), IsEmpty()) << "not used";
}

TEST(Macros, OfAnyNumberOfArgumentsNameTheRemedy) {
  EXPECT_THAT(
      errors("#define SUM(x, ...) F(x, __VA_ARGS__)\nfloat4 Main() : SV_Target { return 1; }\n",
             hlsl::Stage::fragment),
      ElementsAre("2: not supported here: macros with '...'; name the parameters, and write a macro for each "
                  "number of arguments"));
}

// Unity's compilers would take the overload for uint.
TEST(Overloads, ThatFitEquallyNameTheRemedy) {
  EXPECT_THAT(
      errors("int F(int a, int b) { return a; }\nuint F(uint a, uint b) { return a; }\nfloat4 Main() : "
             "SV_Target {\nreturn F(2u, -1); }\n",
             hlsl::Stage::fragment),
      ElementsAre("5: several overloads of 'F' fit these arguments: cast the arguments to the types of one"));
}

TEST(GroupsharedVariables, AreOfComputeProgramsAlone) {
  const std::string shared = "groupshared float Shared[4];\n";
  EXPECT_THAT(
      errors(shared + "float4 Main(float4 p : SV_Position) : SV_Target {\nShared[0] = p.x;\n"
                      "return Shared[int(p.y)]; }\n",
             hlsl::Stage::fragment),
      testing::Contains("4: a groupshared variable is used in a fragment program: only compute programs "
                        "have them"));
  EXPECT_THAT(errors(shared + "float4 Main(float4 p : SV_Position) : SV_Target { return p; }\n",
                     hlsl::Stage::fragment),
              IsEmpty());
}

TEST(Stages, HaveTheInstructionsOfTheirStage) {
  const std::string vertex = "float4 Main(float4 p : POSITION) : SV_Position {\n";
  EXPECT_THAT(errors(vertex + "clip(p.x); return p; }\n", hlsl::Stage::vertex),
              ElementsAre("3: clip() and discard end a pixel, and a vertex program has none: only fragment "
                          "programs have them"));
  EXPECT_THAT(errors("float4 Main(float4 p : SV_Position) : SV_Target {\nGroupMemoryBarrierWithGroupSync(); "
                     "return p; }\n",
                     hlsl::Stage::fragment),
              ElementsAre("3: a barrier waits for the threads of a group, and a fragment program has none: "
                          "only compute programs have barriers with sync"));
  EXPECT_THAT(errors("void Cut(float a) { clip(a); } " + vertex + "return p; }\n", hlsl::Stage::vertex),
              IsEmpty())
      << "not reached";
}

TEST(ReadOnlyBuffers, AreNotChanged) {
  const auto compute = [](const std::string& body) {
    return errors(
        "StructuredBuffer<uint> B; ByteAddressBuffer Y; RWStructuredBuffer<uint> W; RWByteAddressBuffer Z;\n"
        "[numthreads(1, 1, 1)] void Main() {\n" +
            body + "\n}\n",
        hlsl::Stage::compute);
  };
  const auto told = ElementsAre(
      "4: an Interlocked function changes a buffer that can only be read: declare it as an RW buffer");
  EXPECT_THAT(compute("InterlockedAdd(B[1], 1u); W[0] = B[1];"), told);
  EXPECT_THAT(compute("uint was; Y.InterlockedAdd(4, 1u, was); W[0] = was;"), told);
  EXPECT_THAT(compute("uint was; Z.InterlockedAdd(4, B[0], was); InterlockedMax(W[B[1]], was);"), IsEmpty());
}

TEST(InterlockedFunctions, ChangeMemoryThatIsShared) {
  const auto compute = [](const std::string& body) {
    return errors("RWBuffer<uint> _Out; groupshared uint Shared;\n[numthreads(1, 1, 1)] void Main() {\n" +
                      body + "\n}\n",
                  hlsl::Stage::compute);
  };
  EXPECT_THAT(
      compute("uint local = _Out[1]; InterlockedAdd(local, 2u); _Out[0] = local;"),
      ElementsAre("4: an Interlocked function changes a local variable: it takes groupshared variables "
                  "and elements of RW resources"));
  EXPECT_THAT(compute("uint was; InterlockedAdd(Shared, 2u, was); InterlockedMax(_Out[0], was);"), IsEmpty());
}

TEST(IntegerMatrices, AreNotInMemory) {
  const std::string body = "float4 Main(float4 p : SV_Position) : SV_Target {\nreturn _M[int(p.x)].xyxy; }\n";
  const std::string said =
      " is an integer matrix, which SPIR-V, GLSL and Metal cannot store in memory: declare an array of its "
      "rows, such as ";
  EXPECT_THAT(errors("cbuffer C { float a;\nint2x2 _M; };\n" + body, hlsl::Stage::fragment),
              ElementsAre("3: '_M'" + said + "int2 rows[2]"));
  EXPECT_THAT(errors("uint2x2 _M;\n" + body, hlsl::Stage::fragment),
              ElementsAre("2: '_M'" + said + "uint2 rows[2]"));
  EXPECT_THAT(errors("cbuffer C { int2x3 _M; };\n" + body, hlsl::Stage::fragment),
              ElementsAre("2: '_M'" + said + "int3 rows[2]"));
  EXPECT_THAT(errors("static const int2x2 _M = {1, 2, 3, 4};\n" + body, hlsl::Stage::fragment), IsEmpty());
}

TEST(HlslRules, SaysWhatACallOrAnAssignmentTakes) {
  const auto message = [](const std::string& statement) {
    return errors("float4 Main(float2 uv : TEXCOORD0) : SV_Target { " + statement + "\nreturn 1; }\n",
                  hlsl::Stage::fragment);
  };
  EXPECT_THAT(message("float z = _Map.SampleCmp(sampler_Map, uv, 0.5);"),
              ElementsAre(HasSubstr("2: a method that compares takes a SamplerComparisonState")));
  EXPECT_THAT(
      errors("float4 Main() : SV_Target { return Later(1); }\n\nfloat4 Later(float x) { return x; }\n",
             hlsl::Stage::fragment),
      ElementsAre(
          "2: 'Later' is declared only in line 4: move it before its first use, or declare it there"));
  EXPECT_THAT(
      errors("float4 Later(float x);\nfloat4 Main() : SV_Target { return Later(); }\n"
             "float4 Later(float x) { return x; }\n",
             hlsl::Stage::fragment),
      ElementsAre(HasSubstr("3: no function 'Later' takes these arguments; there is Later(float x)")));
  EXPECT_THAT(message("vec4 a = 1;"), ElementsAre("2: unknown type 'vec4'; HLSL has 'float4'"));
  EXPECT_THAT(message("float a = fract(uv.x);"), ElementsAre("2: unknown function 'fract'; HLSL has 'frac'"));
  EXPECT_THAT(message("float a = mod(uv.x, 2);"), ElementsAre("2: unknown function 'mod'; HLSL has 'fmod'"));
  EXPECT_THAT(message("float4 a = mul(uv, uv, 2);"), ElementsAre("2: mul takes two arguments"));
  EXPECT_THAT(message("string s = \"abc;"), ElementsAre(HasSubstr("2: this text has no closing '\"'")));
  EXPECT_THAT(message("bool b = uv.x > 0; b += 1;"), ElementsAre(HasSubstr("or the variable is a bool")));
}

}  // namespace
}  // namespace penumbra::shaders
