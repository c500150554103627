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

namespace penumbra::shaders {

// "#include "Packages/<name>/..." resolves under directory.
struct PackageRoot {
  std::string name;  // for example com.unity.render-pipelines.core
  std::filesystem::path directory;
};

// After the file whose resolved path ends in `suffix` has been included, the text of `file` follows it: how
// the fetch-counting macros replace a pipeline's own without touching its sources.
struct IncludeOverlay {
  std::string suffix;
  std::filesystem::path file;
};

struct CompileRequest {
  std::filesystem::path file;  // names the source in messages; read from disk unless text is given
  std::optional<std::string> text;
  std::string entry = "Main";
  hlsl::Stage stage = hlsl::Stage::compute;
  std::vector<std::pair<std::string, std::string>> defines;
  std::vector<PackageRoot> package_roots;
  std::vector<std::filesystem::path> include_directories;
  std::vector<IncludeOverlay> overlays;
  // The stage in which what Unity's compilers accept and glslang does not is said in another way
  // (preparation/prepare.h). The library's own shaders do without.
  bool prepare = false;
  bool optimise = true;  // legalise, inline and optimise; false keeps the function structure and OpName
};

// What the parser reads: the source after includes, macros and preparation.
struct PreprocessedSource {
  std::string text;  // with #line directives; empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;
  hlsl::SourceFiles sources;                        // every text that was read, by the name messages call it
  std::vector<std::filesystem::path> dependencies;  // every file that was read
};

struct CompileResult {
  std::vector<std::uint32_t> spirv;  // empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::filesystem::path> dependencies;  // every file that was read
};

// Neither ever throws for a bad shader; preprocess() throws InputError only when `file` itself cannot be
// read. Reentrant. A module that comes out has passed SPIR-V validation for Vulkan 1.1.
PreprocessedSource preprocess(const CompileRequest& request);
CompileResult compile(const CompileRequest& request, PreprocessedSource source);
CompileResult compile(const CompileRequest& request);  // both

}  // namespace penumbra::shaders
