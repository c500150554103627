#include "resolve/required_module.h"

#include <algorithm>

#include "input/input_error.h"
#include "shaders/pipeline_interface.h"

namespace penumbra::resolve {
namespace {

// Returns the way out for what the compiler does not know.
std::string remedy_of(const std::string& messages, const MissingName& needed) {
  if (messages.find("'" + needed.name + "'") != std::string::npos) return needed.remedy;
  for (const char* macro : {"'TEXTURE2D_ARRAY'", "'TEXTURECUBE'", "'TEXTURECUBE_ARRAY'", "'TEXTURE3D'"}) {
    if (messages.find(macro) != std::string::npos) return "only 2D textures are provided: TEXTURE2D";
  }
  return "";
}

void require_success(const shaders::CompileRequest& request, const std::vector<hlsl::Diagnostic>& diagnostics,
                     const MissingName* needed = nullptr) {
  if (!hlsl::has_errors(diagnostics)) return;
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == hlsl::Severity::error)
      messages += (messages.empty() ? "" : "\n") + hlsl::format(diagnostic);
  }
  const std::string remedy = needed == nullptr ? "" : remedy_of(messages, *needed);
  // The messages are the way out of the error, because only there do lines stay lines.
  throw InputError(request.file.string(),
                   "does not compile:", messages + (remedy.empty() ? "" : "\n  " + remedy));
}

}  // namespace

std::vector<std::uint32_t> required_module(const shaders::CompileRequest& request,
                                           std::vector<std::string>* notes, const MissingName* needed,
                                           hlsl::SourceFiles* sources,
                                           std::vector<std::uint32_t>* unoptimised) {
  shaders::CompileResult result = shaders::compile(request);
  if (unoptimised != nullptr) *unoptimised = std::move(result.unoptimised);
  if (sources != nullptr) *sources = result.sources;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    if (notes != nullptr && diagnostic.severity == hlsl::Severity::note) {
      notes->push_back(hlsl::format(diagnostic));
    }
  }
  require_success(request, result.diagnostics, needed);
  return std::move(result.spirv);
}

std::string required_text(const shaders::CompileRequest& request, hlsl::SourceFiles* sources) {
  shaders::CompileRequest unprepared = request;
  unprepared.prepare = false;
  shaders::PreprocessedSource source = shaders::preprocess(unprepared);
  require_success(request, source.diagnostics);
  if (sources != nullptr) *sources = std::move(source.sources);
  return std::move(source.text);
}

VertexModule required_vertex_module(const shaders::CompileRequest& request) {
  shaders::CompileResult result = shaders::compile(request);
  require_success(request, result.diagnostics);
  return vertex_module(std::move(result.spirv), result.signature, request.entry);
}

VertexModule vertex_module(std::vector<std::uint32_t> spirv, const shaders::Signature& signature,
                           const std::string& entry) {
  VertexModule module{std::move(spirv), {}};
  for (const shaders::StageLocation& input : shaders::pipeline_interface(module.spirv, entry).inputs) {
    const auto element =
        std::find_if(signature.begin(), signature.end(), [&](const shaders::SignatureElement& declared) {
          return !declared.output && declared.location == static_cast<int>(input.location);
        });
    module.inputs[input.location] = element == signature.end() ? "" : element->semantic;
  }
  return module;
}

}  // namespace penumbra::resolve
