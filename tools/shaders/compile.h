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
  // One body for overloads that differ in precision alone, as Unity's libraries have them
  // (precision_twins.h); without it they are "already has a body". Each body that goes is a note.
  bool merge_precision_twins = false;
  bool optimise = true;  // legalise, inline and optimise; false keeps the function structure and OpName
  bool debug_lines = false;  // OpLine with file and line before the instructions of each statement
};

struct CompileResult {
  std::vector<std::uint32_t> spirv;  // empty when a diagnostic is an error
  std::vector<hlsl::Diagnostic> diagnostics;
  std::vector<std::filesystem::path> dependencies;  // every file that was read
  hlsl::SourceFiles sources;                        // the texts behind all names in messages and OpLine
};

// Never throws for a bad shader; throws InputError only when `file` itself cannot be read. Reentrant. The
// result has passed SPIR-V validation for Vulkan 1.1.
CompileResult compile(const CompileRequest& request);

}  // namespace penumbra::shaders
