// A pass of the package's own .shader, compiled to run here: as it ships, and with its texels counted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "platform/worker_pool.h"
#include "shaders/package_shader.h"

namespace penumbra::resolve {

// One pass for one set of keywords.
struct CompiledScreenPass {
  std::string name;
  std::vector<std::uint32_t> vertex;
  std::vector<std::uint32_t> fragment;
  std::vector<std::uint32_t> counting;  // `fragment`, with its texels counted: shaders/counted_module.h
  std::string vertex_entry;
  std::string fragment_entry;
};

// In `process` as a shadow shader is (shadow_shader.h). Throws InputError for a pass that is not there, and
// for the compiler's errors.
CompiledScreenPass compile(const shaders::PackageShader& shader, const std::string& pass,
                           const std::vector<std::string>& keywords, bool reversed_z,
                           const platform::WorkerPool& process = {});

}  // namespace penumbra::resolve
