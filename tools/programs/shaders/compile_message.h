// Serialises requests, diagnostics and signatures, for compiling workers and for cache entries.
#pragma once

#include <vector>

#include "hlsl/diagnostic.h"
#include "platform/byte_stream.h"
#include "shaders/compile.h"

namespace penumbra::shaders {

void write(platform::ByteWriter& out, const CompileRequest& request);
void write(platform::ByteWriter& out, const std::vector<hlsl::Diagnostic>& diagnostics);
void write(platform::ByteWriter& out, const Signature& signature);

// Damaged input puts the reader into its error state.
CompileRequest read_compile_request(platform::ByteReader& in);
std::vector<hlsl::Diagnostic> read_diagnostics(platform::ByteReader& in);
Signature read_signature(platform::ByteReader& in);

}  // namespace penumbra::shaders
