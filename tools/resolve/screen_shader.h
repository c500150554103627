// A pass of the package's own .shader, compiled to run here: as it ships, and counting its fetches.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platform/worker_pool.h"
#include "shaders/package_shader.h"

namespace penumbra::resolve {

// One pass for one set of keywords. `counting` is a fragment shader that returns what the pass writes to its
// red channel and, in green, the fetches it took.
struct CompiledScreenPass {
  std::string name;
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;
  std::vector<std::uint32_t> counting;
  std::string vertex_entry;
  std::string fragment_entry;
  static constexpr const char* counting_entry = "PenumbraCountFetches";
};

// In `process` as a shadow shader is (shadow_shader.h). Throws InputError for a pass that is not there, for
// the compiler's errors, and for a pass that reads a texture past the counting macros.
CompiledScreenPass compile(const shaders::PackageShader& shader, const std::string& pass,
                           const std::vector<std::string>& keywords, bool reversed_z,
                           const platform::WorkerPool& process = {});

}  // namespace penumbra::resolve
