// Resolves #include in Unity's order (project/include_search.h). Tracks the chain of open files, so that an
// include cycle without guards ends in one message that lists it. Internal to this folder.
#pragma once

#include <set>

#include "hlsl/source_text.h"
#include "preprocessing/preprocessor.h"
#include "project/include_search.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

class IncludeResolver final : public preprocessing::Includes {
 public:
  // Texts that were read are added to `sources`. All arguments must outlive the resolver.
  IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources, SourceMemory& memory);

  preprocessing::IncludedFile enter(const std::string& asked, const std::string& includer) override;
  void leave() override { open_.pop_back(); }

  // Returns the candidates for an #include that did not exist, searched before the file that was found.
  const std::set<std::string>& absent() const { return absent_; }
  bool found_by_case() const { return found_by_case_; }

  // Returns the editor-only include of the first failure; empty if it is another file.
  const std::string& missing_editor_include() const { return missing_editor_include_; }
  // Returns warnings about includes that were found under a different spelling.
  const std::vector<hlsl::Diagnostic>& warnings() const { return warnings_; }

 private:
  std::string open_file(const std::string& name);
  void warn(const std::string& includer, const std::string& asked, const std::string& problem);
  std::string chain_to(const std::string& name) const;

  const CompileRequest& request_;
  project::IncludeRoots roots_;
  std::string roots_key_;
  hlsl::SourceFiles& sources_;
  SourceMemory& memory_;
  std::set<std::string> absent_;
  bool found_by_case_ = false;
  std::vector<std::string> open_;  // the main file, then every include being read
  std::string missing_editor_include_;
  std::vector<hlsl::Diagnostic> warnings_;
};

// No sensible library has deeper includes, so a deeper one is a cycle.
constexpr std::size_t max_include_depth = 100;

}  // namespace penumbra::shaders
