// The rules for a whole shader: constant buffers that the SRP Batcher requires to be identical in every pass,
// variables that do not fit their properties, and keywords that never change the compiled code.
//
// SRP Batcher: https://docs.unity3d.com/Manual/SRPBatcher-Materials.html ("all material properties in a
// single constant buffer named UnityPerMaterial"); the same layout in every pass of a SubShader. Keywords:
// https://docs.unity3d.com/Manual/shader-keywords.html (every declared keyword multiplies the variants).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"

namespace penumbra::lint {

struct ConstantBufferMember {
  std::string name;
  std::uint32_t offset = 0;  // bytes, in glslang's layout: a member after an array starts a new register
  std::uint64_t size = 0;    // bytes, without padding after the last element

  bool operator==(const ConstantBufferMember&) const = default;
};

struct ConstantBuffer {
  std::string name;  // "$Global" for uniforms outside of every cbuffer
  std::uint64_t size = 0;
  std::vector<ConstantBufferMember> members;
};

// Returns all constant buffers that an unoptimised module declares, used or not. Throws std::invalid_argument
// for words that are not SPIR-V.
std::vector<ConstantBuffer> constant_buffers(const std::vector<std::uint32_t>& spirv);

// A compiled stage of a pass.
struct PassStage {
  std::string pass;  // its name, for messages
  hlsl::Stage stage = hlsl::Stage::fragment;
  std::vector<std::string> keywords;
  std::vector<ConstantBuffer> buffers;
};

struct NamedPlace {
  std::string name;
  int line = 0;
  int column = 0;
  std::string file{};  // if empty, the shader's own file
};

// A number, colour or vector of the Properties block.
struct MaterialProperty {
  std::string name;
  int line = 0;
  int column = 0;
  std::string type{};  // "Color", "Vector" or, as written, a type of one number
};

// A SubShader.
struct ShaderToLint {
  std::string file;
  std::vector<MaterialProperty> properties;
  std::vector<PassStage> stages;
};

// Rule srp-batcher: properties outside of UnityPerMaterial, and differing layouts of it. A stage without
// UnityPerMaterial is not compared. Engine properties (unity_*) outside of UnityPerDraw are not checked.
std::vector<hlsl::Diagnostic> srp_batcher_findings(const ShaderToLint& shader);

// Rule property-type: a colour or a vector whose variable is one number, of which its first component becomes
// the value (https://docs.unity3d.com/6000.0/Documentation/Manual/SL-PropertiesInPrograms.html).
std::vector<hlsl::Diagnostic> property_type_findings(const ShaderToLint& shader);

// The result of preprocessing or compiling one variant.
struct VariantText {
  std::vector<std::string> keywords;  // the keywords that are on
  std::string hash;                   // equal for equal results
  // The entry point and the graphics API: only variants of the same source are compared.
  std::string source{};
};

struct ProgramKeywords {
  std::string file;
  std::string program;               // its pass, for messages
  std::vector<NamedPlace> declared;  // the keywords of its pragmas, without "_"
  std::vector<VariantText> variants;
};

// Rule unused-keyword: a keyword is unused if every pair of variants that differ only in it has equal results
// and there is such a pair. Keywords that no pair tests are not reported.
std::vector<hlsl::Diagnostic> unused_keyword_findings(const ProgramKeywords& program);

}  // namespace penumbra::lint
