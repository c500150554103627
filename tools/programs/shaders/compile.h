// HLSL to SPIR-V by glslang in process, with Unity's include rules and exact file:line:column messages.
#pragma once

#include <utility>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "hlsl/stage.h"
#include "hlsl/token_place.h"
#include "preparation/semantic_names.h"
#include "project/package_root.h"
#include "shaders/stage_signature.h"
#include "shaders/vulkan_version.h"

namespace penumbra::shaders {

using project::PackageRoot;

struct CompileRequest {
  std::filesystem::path file;  // names the source in messages; read from disk unless text is given
  hlsl::SharedText text;
  // For a text that this program writes itself, the user's file that it is written for, into whose tree
  // includes may lead (project/include_bounds.h); else empty. `file` is then a mere name, and no place on the
  // disk.
  std::optional<std::filesystem::path> written_for{};
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::filesystem::path project;     // "#include "Assets/..." resolves under it; empty if there is no project
  std::filesystem::path cginc_root;  // the Unity editor's CGIncludes; empty if they are not available
  // If true, HLSL that Unity's compilers accept and glslang does not is rewritten (preparation/prepare.h).
  // The library's own shaders compile without it; glslang then warns of [fastopt].
  bool prepare = false;
  bool optimise = true;      // legalise, inline and optimise; false keeps the function structure and OpName
  bool debug_lines = false;  // OpLine with file and line before the instructions of each statement
  bool keep_unoptimised = false;               // keeps CompileResult::unoptimised and legalised
  VulkanVersion vulkan = VulkanVersion::v1_1;  // the module's environment
  hlsl::TokenPlace entry_place{};  // place of the #pragma that names the entry point; line 0 means none
  bool half_is_16_bits = false;    // half and min16float are 16 bits wide (capability Float16), else 32
  bool dxc = false;  // #pragma use_dxc: HLSL that DXC accepts and FXC, Unity's default, rejects is accepted
  bool rasterized = true;  // a vertex program's output goes to the rasterizer: no hull or geometry program
};

// A source after includes and macros, and after preparation if requested.
struct PreprocessedSource {
  std::string text;  // has #line directives; empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;
  hlsl::SourceFiles sources;                        // every text that was read, by its name in diagnostics
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  // The candidates that did not exist, searched before the file that was found: one that appears would take
  // precedence.
  std::vector<std::filesystem::path> absent{};
  bool found_by_case =
      false;  // an #include matched only case-insensitively: other files in its folder matter
  // The include that ended the compilation, if it is one that ships only with the Unity editor
  // (project/editor_includes.h): reports count these separately from errors of the shader.
  std::string missing_editor_include{};
  // The semantics of the entry point, where the source is prepared.
  std::vector<preparation::SemanticPlace> semantics{};
};

class SourceMemory;  // source_memory.h: files read once for many compilations

// Errors in one target of cross_compile.h, of a module that SPIR-V can express.
struct TargetDiagnostics {
  std::string target;
  std::vector<hlsl::Diagnostic> diagnostics;
};

struct CompileResult {
  std::vector<std::uint32_t> spirv;  // empty when a diagnostic is an error
  // The same shader before optimisation and with debug_lines, and legalised (inlined, in SSA form) but not
  // yet optimised. Both are empty unless kept, or when `spirv` is.
  std::vector<std::uint32_t> unoptimised;
  std::vector<std::uint32_t> legalised;
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<TargetDiagnostics> of_targets;
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  std::string missing_editor_include{};             // see PreprocessedSource
  hlsl::SourceFiles sources;                        // the texts of all file names in messages and OpLine
  Signature signature;                              // the entry point's; empty when there is no module
};

// These functions do not throw for an invalid shader; expand() and its callers throw InputError if `file`
// itself cannot be read. Reentrant. A returned module has passed SPIR-V validation for `vulkan`.
// Expands includes and macros.
PreprocessedSource expand(const CompileRequest& request, SourceMemory& memory);
// Prepares it if the request says so.
void prepare(const CompileRequest& request, PreprocessedSource& expanded);
PreprocessedSource preprocess(const CompileRequest& request);  // does both
CompileResult compile(const CompileRequest& request, PreprocessedSource source);
CompileResult compile(const CompileRequest& request);  // does all three

// Returns all warnings and the first error of a preprocessed source up to linking, including those in
// functions that its entry point does not reach.
std::vector<hlsl::Diagnostic> front_end_messages(const CompileRequest& request,
                                                 const PreprocessedSource& source);

// The versions of the compilers that produce SPIR-V: different versions may produce different code.
std::string compiler_version();  // "glslang 12.0.0, SPIRV-Tools v2023.1"

}  // namespace penumbra::shaders
