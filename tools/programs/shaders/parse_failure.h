// From glslang's log to what a person should read. Internal to this room.
//
// Rule: of one parse the first error is reported and the rest is dropped (error_recovery.h finds the others).
// glslang's HLSL parser does not recover: after an error it gives up one production after the other, each
// with a message of its own, most of them at the wrong file. Warnings are all kept, once each. glslang tells
// lines alone; the column comes from reading the expanded text again with one token a line
// (hlsl/token_place.h).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"
#include "hlsl/token_place.h"

namespace penumbra::shaders {

// What the diagnosis of a failure may draw on.
struct ParseFailure {
  std::string_view log;
  std::string main_file;
  std::optional<std::string> include_failure;
  std::string preprocessed;  // glslang's own preprocessor output, may be empty
  std::function<std::string(const std::string& text)> log_of;  // of the same shader with another text
};

struct PlacedError {
  hlsl::Diagnostic diagnostic;
  // Which token of the preprocessed text the parser stopped at; nothing when it is not known, and when what
  // is wrong is not around it (a bracket that is never closed).
  std::optional<std::size_t> token;
};

PlacedError placed_error(const ParseFailure& failure, const hlsl::SourceFiles& sources);
hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources);

// The entry point, and where it is named; a place without a line: nowhere.
struct NamedEntry {
  const std::string& name;
  const hlsl::TokenPlace& place;
};
hlsl::Diagnostic link_error(const ParseFailure& failure, const NamedEntry& entry,
                            const hlsl::SourceFiles& sources);
std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources);

}  // namespace penumbra::shaders
