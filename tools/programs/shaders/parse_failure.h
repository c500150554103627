// Turns glslang's log into diagnostics, in glslang's words. Internal to this folder.
//
// The first error of a parse is reported and the rest is dropped: glslang's HLSL parser does not recover, so
// that an error is followed by one of each production that it abandons, most of them in the wrong file. All
// warnings are kept, once each. glslang reports only lines; the column is found by parsing the expanded text
// again with one token per line (hlsl/token_place.h).
#pragma once

#include <functional>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "hlsl/token_place.h"

namespace penumbra::shaders {

// The input for diagnosing a failure.
struct ParseFailure {
  std::string_view log;
  std::string main_file;
  std::string preprocessed;
  // Returns the log of the same shader with another text.
  std::function<std::string(const std::string& text)> log_of;
};

// Returns true if the log has an error: "INTERNAL ERROR" and "UNIMPLEMENTED" also occur with a success
// status.
bool has_error(std::string_view log, const hlsl::SourceFiles& sources);

hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources);

// The entry point, and the place that names it; line 0 means none.
struct NamedEntry {
  const std::string& name;
  const hlsl::TokenPlace& place;
};
hlsl::Diagnostic link_error(const ParseFailure& failure, const NamedEntry& entry,
                            const hlsl::SourceFiles& sources);
std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
