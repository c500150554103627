#include "validation/source_variants.h"

#include <algorithm>
#include <map>
#include <utility>

#include "shaders/package_shader.h"
#include "techniques/technique_call.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {
namespace {

constexpr const char* fragment_entry = R"(
ShadowTile _PenumbraTile;

float4 Fragment(float4 position : SV_Position, float3 shadowCoord : TEXCOORD0, float2 depthGradient : TEXCOORD1,
                nointerpolation float2 rotation : TEXCOORD2, nointerpolation int cascade : TEXCOORD3) : SV_Target
{
    ShadowReceiver receiver;
    receiver.shadowCoord = shadowCoord;
    receiver.depthGradient = depthGradient;
    receiver.rotation = rotation;
    return ResolveTechnique(receiver, _PenumbraTile, cascade);
}
)";

constexpr const char* compute_entry = R"(
ShadowTile _PenumbraTile;
StructuredBuffer<float4> _PenumbraShadowCoord;
StructuredBuffer<float4> _PenumbraGradientRotation;
RWStructuredBuffer<float> _PenumbraVisibility;

[numthreads(64, 1, 1)]
void Compute(uint3 id : SV_DispatchThreadID)
{
    ShadowReceiver receiver;
    receiver.shadowCoord = _PenumbraShadowCoord[id.x].xyz;
    receiver.depthGradient = _PenumbraGradientRotation[id.x].xy;
    receiver.rotation = _PenumbraGradientRotation[id.x].zw;
    _PenumbraVisibility[id.x] = ResolveTechnique(receiver, _PenumbraTile, int(_PenumbraShadowCoord[id.x].w));
}
)";

shaders::CompileRequest base_request(const ValidationRequest& request,
                                     const std::vector<std::string>& keywords) {
  shaders::CompileRequest compile;
  compile.defines = request.defines;
  for (const std::string& keyword : keywords) compile.defines.emplace_back(keyword, "1");
  compile.package_roots = request.package_roots;
  compile.include_directories = request.include_directories;
  return compile;
}

SourceVariant technique_variant(const ValidationRequest& request, const techniques::Technique& technique,
                                hlsl::Stage stage, const std::vector<std::string>& keywords) {
  const techniques::TechniqueList& list = *request.techniques;
  SourceVariant variant;
  variant.technique = &technique;
  variant.unit.technique = technique.name;
  variant.unit.keywords = keywords;
  variant.unit.file = (list.package / technique.file()).lexically_normal().string();
  variant.unit.lint = request.lint;
  shaders::CompileRequest& compile = variant.unit.compile;
  compile = base_request(request, keywords);
  for (const std::filesystem::path& folder : list.include_directories())
    compile.include_directories.push_back(folder);
  compile.written_for = variant.unit.file;
  const std::string manifest = std::filesystem::path(technique.where).filename().string();
  compile.file =
      "technique " + technique.name + " of " + manifest + " (" + hlsl::stage_name(stage) + " entry)";
  compile.text = techniques::emit_technique_call(list, technique).source() +
                 (stage == hlsl::Stage::fragment ? fragment_entry : compute_entry);
  compile.entry = stage == hlsl::Stage::fragment ? "Fragment" : "Compute";
  compile.stage = stage;
  return variant;
}

std::vector<std::string> with_own_keywords(const techniques::Technique& technique,
                                           std::vector<std::string> keywords) {
  for (const std::string& keyword : technique.keywords)
    if (std::find(keywords.begin(), keywords.end(), keyword) == keywords.end()) keywords.push_back(keyword);
  return keywords;
}

std::vector<SourceVariant> technique_variants(const ValidationRequest& request,
                                              const techniques::Technique& technique,
                                              const std::vector<std::string>& keywords) {
  std::vector<SourceVariant> variants = pass_variants(request, technique, keywords);
  if (technique.graph.filter_pass() != nullptr)
    for (const hlsl::Stage stage : {hlsl::Stage::fragment, hlsl::Stage::compute})
      variants.push_back(technique_variant(request, technique, stage, keywords));
  return variants;
}

// Adds one for each version of Vulkan that the request's targets are for.
void add_for_targets(const ValidationRequest& request, SourceVariant variant,
                     std::vector<SourceVariant>& variants) {
  for (auto& [vulkan, targets] : by_vulkan_version(request.targets)) {
    variant.unit.compile.vulkan = vulkan;
    variant.unit.targets = std::move(targets);
    variants.push_back(variant);
  }
}

}  // namespace

std::vector<SourceVariant> source_variants(const ValidationRequest& request) {
  std::vector<SourceVariant> variants;
  const auto add = [&](const techniques::Technique& technique) {
    for (const std::vector<std::string>& keywords : technique.keyword_sets)
      for (SourceVariant& variant :
           technique_variants(request, technique, with_own_keywords(technique, keywords)))
        add_for_targets(request, std::move(variant), variants);
  };
  if (request.techniques)
    for (const techniques::Technique& technique : request.techniques->techniques) add(technique);
  for (const ShaderToValidate& shader : request.files) {
    for (const std::vector<std::string>& keywords : shader.keyword_sets) {
      SourceVariant variant;
      variant.unit.file = shader.file.string();
      variant.unit.keywords = keywords;
      variant.unit.lint = request.lint;
      variant.unit.compile = base_request(request, keywords);
      variant.unit.compile.file = shader.file;
      variant.unit.compile.entry = shader.entry;
      variant.unit.compile.stage = shader.stage;
      add_for_targets(request, std::move(variant), variants);
    }
  }
  return variants;
}

std::vector<SourceVariant> pass_variants(const ValidationRequest& request,
                                         const techniques::Technique& technique,
                                         const std::vector<std::string>& keywords) {
  const bool reversed_z = std::find(keywords.begin(), keywords.end(), "UNITY_REVERSED_Z") != keywords.end();
  std::vector<std::string> on = keywords;
  on.insert(on.end(), technique.graph.keywords.begin(), technique.graph.keywords.end());
  std::map<std::filesystem::path, shaders::PackageShader> parsed;
  const auto variant_of = [&](const techniques::GraphPass& pass, shaders::CompileRequest compile) {
    SourceVariant variant;
    variant.technique = &technique;
    variant.unit.technique = technique.name;
    variant.unit.keywords = keywords;
    variant.unit.file = (request.techniques->package / pass.file).lexically_normal().string();
    variant.unit.pass = pass.program;
    variant.unit.lint = request.lint;
    variant.unit.compile = std::move(compile);
    variant.unit.compile.defines.insert(variant.unit.compile.defines.end(), request.defines.begin(),
                                        request.defines.end());
    return variant;
  };
  std::vector<SourceVariant> variants;
  for (const techniques::GraphPass& pass : technique.graph.passes) {
    if (pass.kind == techniques::PassKind::filter) continue;
    const std::filesystem::path file = (request.techniques->package / pass.file).lexically_normal();
    if (pass.kind == techniques::PassKind::compute) {
      variants.push_back(variant_of(
          pass, shaders::kernel_request(file, pass.program, on, reversed_z, request.package_roots)));
      continue;
    }
    const shaders::PackageShader& shader =
        parsed.try_emplace(file, file, request.package_roots).first->second;
    std::vector<std::vector<std::string>> keyword_sets{on};
    if (pass.kind == techniques::PassKind::casters &&
        !shader.declared(pass.program, {techniques::alpha_test_keyword}).empty()) {
      keyword_sets.push_back(on);
      keyword_sets.back().emplace_back(techniques::alpha_test_keyword);
    }
    for (std::size_t i = 0; i < keyword_sets.size(); ++i)
      for (const hlsl::Stage stage : {hlsl::Stage::vertex, hlsl::Stage::fragment}) {
        variants.push_back(
            variant_of(pass, shader.request(pass.program, stage, keyword_sets[i], reversed_z)));
        if (i > 0) variants.back().unit.keywords.emplace_back(techniques::alpha_test_keyword);
      }
  }
  return variants;
}

}  // namespace penumbra::validation
