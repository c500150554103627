// Finds what #include names, in Unity's order (project/include_search.h), for
// either preprocessor. Knows the chain of
// files that are open, so that a cycle without guards ends in one message that names it. Internal to this
// room.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hlsl/source_text.h"
#include "preparation/macro_arguments.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

struct SourceToExpand;

class IncludeResolver final : public glslang::TShader::Includer, public preprocessing::Includes {
 public:
  // Texts that were read are added to `sources`, which outlives the resolver, as all else given here does.
  IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources, SourceMemory& memory,
                  const preparation::MacroArguments& arguments, std::set<std::string> undefined_by_main_file);

  IncludeResult* includeLocal(const char* header, const char* includer, std::size_t depth) override;
  IncludeResult* includeSystem(const char* header, const char* includer, std::size_t depth) override;
  void releaseInclude(IncludeResult* result) override;

  // Of a request that is prepared.
  std::optional<preprocessing::IncludedFile> enter(const std::string& asked,
                                                   const std::string& includer) override;
  void leave() override { open_.pop_back(); }

  // What an #include could have named, and what was not there, before the file that was.
  const std::set<std::string>& absent() const { return absent_; }
  bool found_by_case() const { return found_by_case_; }

  // Why the first #include that failed did.
  const std::optional<std::string>& failure() const { return failure_; }

  // The editor-only include that the first failure is about; empty when it is about another.
  const std::string& missing_editor_include() const { return missing_editor_include_; }
  // Includes that were found, but not by their own spelling.
  const std::vector<hlsl::Diagnostic>& warnings() const { return warnings_; }

 private:
  std::optional<std::string> open(const std::string& asked, const std::string& includer);
  bool open_file(const std::string& name);
  void warn(const std::string& includer, const std::string& asked, const std::string& problem);
  bool fail(const std::string& problem);
  const SourceToExpand* to_read(const std::string& name);
  std::string text_to_read(const std::string& name);
  std::string chain_to(const std::string& name) const;

  const CompileRequest& request_;
  project::IncludeRoots roots_;
  std::string roots_key_;
  hlsl::SourceFiles& sources_;
  SourceMemory& memory_;
  const preparation::MacroArguments& arguments_;
  std::set<std::string> read_;
  std::set<std::string> undefined_;  // macros that a file read so far undefines: guards no more
  std::set<std::string> absent_;
  bool found_by_case_ = false;
  std::vector<std::string> open_;  // the main file, then every include being read
  std::optional<std::string> failure_;
  std::string missing_editor_include_;
  std::vector<hlsl::Diagnostic> warnings_;
};

// One file per include depth of an honest library; deeper is a cycle.
constexpr std::size_t max_include_depth = 100;

}  // namespace penumbra::shaders
