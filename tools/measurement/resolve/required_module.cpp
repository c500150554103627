#include "resolve/required_module.h"

#include <algorithm>

#include "input/input_error.h"
#include "shaders/pipeline_interface.h"

namespace penumbra::resolve {
namespace {

// Of what the compiler does not know.
std::string way_out_of(const std::string& messages, const MissingName& needed) {
  if (messages.find("'" + needed.name + "'") != std::string::npos) return needed.way_out;
  for (const char* macro : {"'TEXTURE2D_ARRAY'", "'TEXTURECUBE'", "'TEXTURECUBE_ARRAY'", "'TEXTURE3D'"}) {
    if (messages.find(macro) != std::string::npos) return "only 2D textures are provided: TEXTURE2D";
  }
  return "";
}

void require_success(const shaders::CompileRequest& request, const shaders::CompileResult& result,
                     const MissingName* needed = nullptr) {
  if (!hlsl::has_errors(result.diagnostics)) return;
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.severity == hlsl::Severity::error)
      messages += (messages.empty() ? "" : "\n") + hlsl::format(diagnostic);
  }
  const std::string way_out = needed == nullptr ? "" : way_out_of(messages, *needed);
  throw InputError(request.file.string(), "does not compile:",
                   messages + (way_out.empty() ? "" : "\n  " + way_out));  // lines stay lines there alone
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
  require_success(request, result, needed);
  return std::move(result.spirv);
}

VertexModule required_vertex_module(const shaders::CompileRequest& request) {
  shaders::CompileResult result = shaders::compile(request);
  require_success(request, result);
  VertexModule module{std::move(result.spirv), {}};
  for (const shaders::StageLocation& input :
       shaders::pipeline_interface(module.spirv, request.entry).inputs) {
    const auto element = std::find_if(
        result.signature.begin(), result.signature.end(), [&](const shaders::SignatureElement& declared) {
          return !declared.output && declared.location == static_cast<int>(input.location);
        });
    module.inputs[input.location] = element == result.signature.end() ? "" : element->semantic;
  }
  return module;
}

}  // namespace penumbra::resolve
