// Finds what #include names, in Unity's order, for glslang: package roots, then beside the including file,
// then the include directories. Knows the chain of files that are open, so that a cycle without guards ends
// in one message that names it. Internal to this room.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hlsl/source_text.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

class IncludeResolver final : public glslang::TShader::Includer {
 public:
  // Texts that were read are added to `sources`, which outlives the resolver.
  IncludeResolver(const CompileRequest& request, hlsl::SourceFiles& sources);

  IncludeResult* includeLocal(const char* header, const char* includer, std::size_t depth) override;
  IncludeResult* includeSystem(const char* header, const char* includer, std::size_t depth) override;
  void releaseInclude(IncludeResult* result) override;

  // Why the first #include that failed did.
  const std::optional<std::string>& failure() const { return failure_; }

 private:
  IncludeResult* open(const std::string& name);
  IncludeResult* fail(const std::string& problem);
  std::string text_to_read(const std::string& name);
  std::string with_overlays(const std::string& name, std::string text) const;
  std::string chain_to(const std::string& name) const;

  const CompileRequest& request_;
  hlsl::SourceFiles& sources_;
  std::set<std::string> read_once_;  // files that said `#pragma once`
  std::vector<std::string> open_;    // the main file, then every include being read
  std::optional<std::string> failure_;
};

// One file per include depth of an honest library; deeper is a cycle.
constexpr std::size_t max_include_depth = 100;

}  // namespace penumbra::shaders
