#include "preparation/semantic_names.h"

#include "hlsl/name_set.h"
#include "input/nearest_name.h"

namespace penumbra::preparation {

namespace {

using Names = std::vector<std::string>;

const Names& system_values() {
  static const Names names = hlsl::names_in(
      "SV_Barycentrics SV_ClipDistance SV_Coverage SV_CullDistance SV_CullPrimitive SV_Depth "
      "SV_DepthGreaterEqual SV_DepthLessEqual SV_DispatchThreadID SV_DomainLocation SV_GroupID "
      "SV_GroupIndex SV_GroupThreadID SV_GSInstanceID SV_InnerCoverage SV_InsideTessFactor "
      "SV_InstanceID SV_IsFrontFace SV_OutputControlPointID SV_Position SV_PrimitiveID "
      "SV_RenderTargetArrayIndex SV_SampleIndex SV_ShadingRate SV_StartInstanceLocation "
      "SV_StartVertexLocation SV_StencilRef SV_Target SV_TessFactor SV_VertexID SV_ViewID "
      "SV_ViewportArrayIndex");
  return names;
}

// The names include those of Direct3D 9 that Unity's compilers still accept.
const Names& fragment_outputs() {
  static const Names names = hlsl::names_in(
      "SV_Target SV_Depth SV_DepthGreaterEqual SV_DepthLessEqual SV_Coverage SV_StencilRef COLOR DEPTH");
  return names;
}

const Names& compute_inputs() {
  static const Names names{"SV_DispatchThreadID", "SV_GroupID", "SV_GroupIndex", "SV_GroupThreadID"};
  return names;
}

// Returns system values only; from the table of Microsoft's compiler (docs/DXIL.rst of DirectXShaderCompiler,
// "Signature points"), where some are treated as user-defined names. If it is empty, names are not checked.
const Names& stage_values(hlsl::Stage stage, bool input) {
  static const Names none;
  static const Names vertex_inputs = hlsl::names_in(
      "SV_VertexID SV_InstanceID SV_StartInstanceLocation SV_StartVertexLocation SV_ViewID SV_Position "
      "SV_RenderTargetArrayIndex SV_ViewportArrayIndex SV_ClipDistance SV_CullDistance SV_CullPrimitive "
      "SV_ShadingRate");
  static const Names vertex_outputs = hlsl::names_in(
      "SV_Position SV_RenderTargetArrayIndex SV_ViewportArrayIndex SV_ClipDistance SV_CullDistance "
      "SV_CullPrimitive SV_InstanceID SV_ShadingRate");
  static const Names fragment_inputs = hlsl::names_in(
      "SV_Position SV_RenderTargetArrayIndex SV_ViewportArrayIndex SV_ClipDistance SV_CullDistance "
      "SV_CullPrimitive SV_InstanceID SV_ShadingRate SV_PrimitiveID SV_IsFrontFace SV_SampleIndex "
      "SV_Coverage SV_InnerCoverage SV_Barycentrics SV_ViewID");
  if (stage == hlsl::Stage::vertex) return input ? vertex_inputs : vertex_outputs;
  return stage == hlsl::Stage::fragment && input ? fragment_inputs : none;
}

const Names& vertex_inputs() {
  static const Names names =
      hlsl::names_in("POSITION NORMAL TANGENT TEXCOORD COLOR BLENDWEIGHTS BLENDWEIGHT BLENDINDICES");
  return names;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

std::string without_index(const std::string& semantic) {
  const std::size_t last = semantic.find_last_not_of("0123456789");
  return last == std::string::npos ? std::string() : semantic.substr(0, last + 1);
}

bool is_one_of(const std::string& name, const Names& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& one) { return upper(one) == upper(name); });
}

std::string hint(const std::string& name, const Names& names) {
  const std::string nearest = name.size() > 40 ? std::string() : nearest_name(name, names);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// Returns the largest number of components of integer system values.
int whole_numbers(const std::string& key) {
  static constexpr hlsl::NameSet one("SV_COVERAGE", "SV_GROUPINDEX", "SV_GSINSTANCEID", "SV_INNERCOVERAGE",
                                     "SV_INSTANCEID", "SV_OUTPUTCONTROLPOINTID", "SV_PRIMITIVEID",
                                     "SV_RENDERTARGETARRAYINDEX", "SV_SAMPLEINDEX", "SV_STENCILREF",
                                     "SV_VERTEXID", "SV_VIEWID", "SV_VIEWPORTARRAYINDEX");
  static constexpr hlsl::NameSet three("SV_DISPATCHTHREADID", "SV_GROUPID", "SV_GROUPTHREADID");
  return one.contains(key) ? 1 : three.contains(key) ? 3 : 0;
}

}  // namespace

std::string semantic_key(std::string_view semantic) {
  return upper(without_index(std::string(semantic)));
}

std::string type_problem(const std::string& semantic, const NumberShape& type) {
  using Base = NumberShape::Base;
  if (!type.known()) return {};
  const std::string key = semantic_key(semantic);
  const bool whole = type.base == Base::integer || type.base == Base::natural;
  if (key == "SV_ISFRONTFACE")
    return type.is_scalar() && type.base != Base::real ? "" : "is a bool: declare it as one";
  const int count = whole_numbers(key);
  if (count == 0 || (whole && !type.is_matrix() && type.columns <= count)) return {};
  return count == 1 ? "is an integer: declare it as uint"
                    : "is a vector of three integers: declare it as uint3, uint2 or uint";
}

std::string system_value_of(const std::string& semantic, hlsl::Stage stage, bool input) {
  const std::string name = upper(without_index(semantic));
  const std::string index = semantic.substr(name.size());
  if (stage == hlsl::Stage::vertex && !input && name == "POSITION") return "SV_Position" + index;
  if (stage != hlsl::Stage::fragment) return {};
  if (input) return name == "VPOS" ? "SV_Position" + index : std::string();
  return name == "COLOR" ? "SV_Target" + index : name == "DEPTH" ? "SV_Depth" + index : std::string();
}

std::string semantic_problem(const std::string& semantic, hlsl::Stage stage, bool input) {
  const std::string name = without_index(semantic);
  if (name.empty()) return {};
  if (upper(name).starts_with("SV_") && !is_one_of(name, system_values()))
    return "is not a system value of HLSL" + hint(name, system_values());
  if (stage == hlsl::Stage::fragment && !input && !is_one_of(name, fragment_outputs()))
    return "is not an output of a fragment program" + hint(name, fragment_outputs());
  const std::string index = semantic.substr(name.size());
  if (upper(name) == "SV_TARGET" && (index.size() > 1 || index > "7"))
    return "does not exist: the targets are SV_Target0 to SV_Target7";
  if (stage == hlsl::Stage::compute && input && !is_one_of(name, compute_inputs()))
    return "is not an input of a compute program, which has " + listed(compute_inputs());
  const Names& values = stage_values(stage, input);
  if (!upper(name).starts_with("SV_") || values.empty() || is_one_of(name, values)) return {};
  return std::string("is not an ") + (input ? "input" : "output") + " of a " + hlsl::stage_name(stage) +
         " program";
}

// glslang gives up on clip and cull distances of these stages.
std::string distance_problem(const std::string& semantic, hlsl::Stage stage, bool input) {
  static const Names distances{"SV_ClipDistance", "SV_CullDistance"};
  const std::string name = without_index(semantic);
  if (!is_one_of(name, distances)) return {};
  if (stage == hlsl::Stage::geometry && input)
    return "cannot be read in a geometry program here: pass the distance in a TEXCOORD, and write " + name +
           " in the geometry program";
  if (stage == hlsl::Stage::hull || stage == hlsl::Stage::domain)
    return std::string("is not supported in a ") + hlsl::stage_name(stage) + " program";
  return {};
}

// Only of names that resemble an attribute's.
std::string attribute_problem(const std::string& semantic) {
  const std::string name = without_index(semantic);
  if (name.empty() || upper(name).starts_with("SV_") || is_one_of(name, vertex_inputs())) return {};
  const std::string meant = hint(name, vertex_inputs());
  return meant.empty() ? "" : "is not a vertex attribute of Unity's meshes" + meant;
}

}  // namespace penumbra::preparation
