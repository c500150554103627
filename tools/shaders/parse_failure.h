// From glslang's log to what a person should read. Internal to this room.
//
// Rule: of a failed parse the first error is reported and the rest is dropped. glslang's HLSL parser does not
// recover: after an error it gives up one production after the other, each with a message of its own, most of
// them at the wrong file. Warnings are all kept, once each.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::shaders {

// One line of the log: "ERROR: file:line: 'token' : message".
struct LogLine {
  hlsl::Severity severity = hlsl::Severity::error;
  std::string file;
  int line = 0;
  std::string token;
  std::string message;
};

std::vector<LogLine> parse_log(std::string_view log, const hlsl::SourceFiles& sources);

// What the diagnosis of a failure may draw on.
struct ParseFailure {
  std::string_view log;
  std::string main_file;
  std::optional<std::string> include_failure;
  std::string preprocessed;  // glslang's own preprocessor output, may be empty
};

hlsl::Diagnostic first_error(const ParseFailure& failure, const hlsl::SourceFiles& sources);
std::vector<hlsl::Diagnostic> warnings(std::string_view log, const hlsl::SourceFiles& sources);

// 1-based column of the token where it stands alone and only once in the line, else 0.
int column_of(std::string_view token, std::string_view line);

}  // namespace penumbra::shaders
