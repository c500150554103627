// Reads a text without includes.
#pragma once

#include <sstream>
#include <string>

#include "preprocessing/preprocessor.h"

namespace penumbra::preprocessing {

// Returns the text without #line directives, or the first error as "line:column: message".
inline std::string read_text(const std::string& text) {
  class NoIncludes final : public Includes {
   public:
    IncludedFile enter(const std::string& asked, const std::string&) override {
      return {{}, nullptr, "'" + asked + "' is not there"};
    }
    void leave() override {}
  };
  NoIncludes none;
  Preprocessor preprocessor;
  const CutSource given = preprocessor.cut("");
  const CutSource source = preprocessor.cut(text);
  const Preprocessed read = preprocessor.run(given, source, "main.hlsl", none);
  for (const hlsl::Diagnostic& said : read.diagnostics)
    if (said.severity == hlsl::Severity::error)
      return std::to_string(said.line) + ":" + std::to_string(said.column) + ": " + said.message;
  std::string without_directives;
  std::istringstream lines(read.text);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#line")) without_directives += line + "\n";
  return without_directives;
}

}  // namespace penumbra::preprocessing
