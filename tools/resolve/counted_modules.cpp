#include "resolve/counted_modules.h"

#include "input/input_error.h"
#include "platform/data_directory.h"
#include "shaders/image_instructions.h"

namespace penumbra::resolve {
namespace {

constexpr const char* kCountingPrefix = "PenumbraCounted";

// Of what the compiler does not know.
std::string way_out_of(const std::string& messages, const MissingName& needed) {
  if (messages.find("'" + needed.name + "'") != std::string::npos) return needed.way_out;
  for (const char* macro : {"'TEXTURE2D_ARRAY'", "'TEXTURECUBE'", "'TEXTURECUBE_ARRAY'", "'TEXTURE3D'"}) {
    if (messages.find(macro) != std::string::npos) return "only 2D textures are provided: TEXTURE2D";
  }
  return "";
}

}  // namespace

void count_fetches(shaders::CompileRequest& request) {
  const std::filesystem::path counting =
      platform::data_directory() / "tools" / "resolve" / "shaders" / "CountingPlatform.hlsl";
  request.defines.emplace_back("PENUMBRA_COUNT_FETCHES", "1");
  request.include_directories.push_back(platform::data_directory() / "ShaderLibrary");  // they include it
  for (const char* api : {"/Platform/Platform.hlsl", "/API/D3D11.hlsl", "/API/Vulkan.hlsl", "/API/Metal.hlsl",
                          "/API/GLCore.hlsl"}) {
    request.overlays.push_back({api, counting});
  }
}

std::vector<std::uint32_t> compile_or_throw(const shaders::CompileRequest& request,
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
  if (!hlsl::has_errors(result.diagnostics)) return std::move(result.spirv);
  std::string messages;
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.severity == hlsl::Severity::error)
      messages += (messages.empty() ? "" : "\n") + hlsl::format(diagnostic);
  }
  const std::string way_out = needed == nullptr ? "" : way_out_of(messages, *needed);
  throw InputError(request.file.string(), "does not compile:",
                   messages + (way_out.empty() ? "" : "\n  " + way_out));  // lines stay lines there alone
}

// The module that shows which function reads keeps its functions.
void refuse_uncounted_fetches(shaders::CompileRequest counting, const std::string& shader) {
  counting.optimise = false;
  counting.debug_lines = true;
  const std::vector<shaders::ImageInstruction> uncounted =
      shaders::image_instructions_outside(compile_or_throw(counting), kCountingPrefix);
  if (uncounted.empty()) return;
  const shaders::ImageInstruction& first = uncounted.front();
  throw InputError(first.line == 0 ? shader : first.file + ":" + std::to_string(first.line),
                   "function '" + first.function + "' reads a texture without the sampling macros (" +
                       first.opcode + "), so its fetches cannot be counted",
                   "use SAMPLE_TEXTURE2D_SHADOW, LOAD_TEXTURE2D_LOD, GATHER_RED_TEXTURE2D or similar");
}

}  // namespace penumbra::resolve
