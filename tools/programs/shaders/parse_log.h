// glslang's log, line by line. Internal to this folder.
#pragma once

#include "hlsl/diagnostic.h"
#include "hlsl/source_text.h"

namespace penumbra::shaders {

// A line of the log: "ERROR: file:line: 'token' : message".
struct LogLine {
  hlsl::Severity severity = hlsl::Severity::error;
  std::string file;
  int line = 0;
  std::string token;
  std::string message;
};

std::vector<LogLine> parse_log(std::string_view log, const hlsl::SourceFiles& sources);

// Returns the 1-based column of the token if it occurs exactly once in the line as a whole token, else 0.
int column_of(std::string_view token, std::string_view line);

}  // namespace penumbra::shaders
