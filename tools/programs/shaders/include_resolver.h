// Resolves #include in Unity's order (project/include_search.h), for either preprocessor. Tracks the chain of
// open files, so that an include cycle without guards ends in one message that lists it. Internal to this
// folder.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include "hlsl/source_text.h"
#include "preparation/macro_arguments.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

struct SourceToExpand;

class IncludeResolver final : public glslang::TShader::Includer, public preprocessing::Includes {
 public:
  // Texts that were read are added to `sources`. All arguments must outlive the resolver.
  IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources, SourceMemory& memory,
                  const preparation::MacroArguments& arguments, std::set<std::string> undefined_by_main_file);

  IncludeResult* includeLocal(const char* header, const char* includer, std::size_t depth) override;
  IncludeResult* includeSystem(const char* header, const char* includer, std::size_t depth) override;
  void releaseInclude(IncludeResult* result) override;

  // Used for a request that is prepared.
  std::optional<preprocessing::IncludedFile> enter(const std::string& asked,
                                                   const std::string& includer) override;
  void leave() override { open_.pop_back(); }

  // Returns the candidates for an #include that did not exist, searched before the file that was found.
  const std::set<std::string>& absent() const { return absent_; }
  bool found_by_case() const { return found_by_case_; }

  // Returns why the first failed #include failed.
  const std::optional<std::string>& failure() const { return failure_; }

  // Returns the editor-only include of the first failure; empty if it is another file.
  const std::string& missing_editor_include() const { return missing_editor_include_; }
  // Returns warnings about includes that were found under a different spelling.
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
  std::set<std::string> undefined_;  // macros that a file read so far undefines: not usable as guards
  std::set<std::string> absent_;
  bool found_by_case_ = false;
  std::vector<std::string> open_;  // the main file, then every include being read
  std::optional<std::string> failure_;
  std::string missing_editor_include_;
  std::vector<hlsl::Diagnostic> warnings_;
};

// No sensible library has deeper includes, so a deeper one is a cycle.
constexpr std::size_t max_include_depth = 100;

}  // namespace penumbra::shaders
