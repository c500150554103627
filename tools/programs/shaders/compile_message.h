// Serialises requests, diagnostics and signatures, for compiling workers and for cache entries.
#pragma once

#include "hlsl/diagnostic.h"
#include "platform/byte_stream.h"
#include "platform/worker_pool.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

void write(platform::ByteWriter& out, const CompileRequest& request);
void write(platform::ByteWriter& out, const std::vector<hlsl::Diagnostic>& diagnostics);
void write(platform::ByteWriter& out, const Signature& signature);

// Damaged input puts the reader into its error state.
CompileRequest read_compile_request(platform::ByteReader& in);
std::vector<hlsl::Diagnostic> read_diagnostics(platform::ByteReader& in);
Signature read_signature(platform::ByteReader& in);

// The diagnostic for a compiling worker that has crashed, hung or exceeded a limit.
struct CompilerFailure {
  std::string problem;  // "the compiler crashed with SIGSEGV", and the end of its output
  std::string remedy;
  bool limited = false;  // true if it exceeded a limit of time or memory
};

// Describes an outcome without a response.
CompilerFailure compiler_failure(const platform::WorkerOutcome& outcome);

}  // namespace penumbra::shaders
