// HLSL to SPIR-V by glslang in process, with Unity's include rules and exact file:line:column messages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "hlsl/stage.h"
#include "hlsl/token_place.h"
#include "project/package_root.h"
#include "shaders/vulkan_version.h"

namespace penumbra::shaders {

using project::PackageRoot;

struct CompileRequest {
  std::filesystem::path file;  // names the source in messages; read from disk unless text is given
  std::optional<std::string> text;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::filesystem::path project;     // "#include "Assets/..." resolves under it; empty: no project
  std::filesystem::path cginc_root;  // the Unity editor's CGIncludes; empty: not at hand
  // The stage in which what Unity's compilers accept and glslang does not is rewritten
  // (preparation/prepare.h). The library's own shaders do without.
  bool prepare = false;
  bool optimise = true;      // legalise, inline and optimise; false keeps the function structure and OpName
  bool debug_lines = false;  // OpLine with file and line before the instructions of each statement
  bool keep_unoptimised = false;               // CompileResult::unoptimised and legalised
  VulkanVersion vulkan = VulkanVersion::v1_1;  // that the module is for
  hlsl::TokenPlace entry_place{};              // of the #pragma that names the entry point; no line: of none
  bool half_is_16_bits = false;  // half and min16float are 16 bits wide (capability Float16), else 32
  bool dxc = false;  // #pragma use_dxc: what Unity's other compiler (FXC) refuses and DXC takes is taken
};

// A source after includes and macros, and where it is wanted after preparation.
struct PreprocessedSource {
  std::string text;  // with #line directives; empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;
  hlsl::SourceFiles sources;                        // every text that was read, by the name messages call it
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  // Looked for and not there, before the file that was: one that appears would be read instead.
  std::vector<std::filesystem::path> absent{};
  bool found_by_case = false;  // an #include was found in another case: what else its folder holds matters
  // The include that ended the compilation, when it is one that ships with the Unity editor and in no package
  // (project/editor_includes.h): a report counts these apart from shaders that are wrong.
  std::string missing_editor_include{};
};

class SourceMemory;  // source_memory.h: files read once for many compilations

struct CompileResult {
  std::vector<std::uint32_t> spirv;  // empty when a diagnostic is an error
  // The same shader before optimisation and with debug_lines, and legalised (inlined, in SSA form) but not
  // yet optimised; empty unless kept, or when `spirv` is.
  std::vector<std::uint32_t> unoptimised;
  std::vector<std::uint32_t> legalised;
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  std::string missing_editor_include{};             // as in PreprocessedSource
  hlsl::SourceFiles sources;                        // the texts behind all names in messages and OpLine
};

// None ever throws for a bad shader; expand() and what calls it throw InputError when `file` itself cannot be
// read. Reentrant. A module that comes out has passed SPIR-V validation for `vulkan`.
PreprocessedSource expand(const CompileRequest& request, SourceMemory& memory);  // includes and macros
void prepare(const CompileRequest& request, PreprocessedSource& expanded);       // if the request says so
PreprocessedSource preprocess(const CompileRequest& request);                    // both
CompileResult compile(const CompileRequest& request, PreprocessedSource source);
CompileResult compile(const CompileRequest& request);  // all three

// All that is said of a preprocessed source until its tree is linked, of functions that its entry point does
// not reach as well: where none is an error, the front end takes it.
std::vector<hlsl::Diagnostic> front_end_messages(const CompileRequest& request,
                                                 const PreprocessedSource& source);

}  // namespace penumbra::shaders
