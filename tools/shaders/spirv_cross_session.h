// One SPIR-V module in SPIRV-Cross's C API, freed at the end of its scope. Internal to this room.
#pragma once

#include <spirv_cross/spirv_cross_c.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace penumbra::shaders {

class SpirvCrossSession {
 public:
  // Throws std::invalid_argument when the words are no SPIR-V module, or not one for this back end.
  SpirvCrossSession(const std::vector<std::uint32_t>& spirv, spvc_backend backend) {
    if (spirv.size() < 5 || spirv[0] != SpvMagicNumber) throw std::invalid_argument("not a SPIR-V module");
    if (spvc_context_create(&context_) != SPVC_SUCCESS) throw std::bad_alloc();
    spvc_parsed_ir module = nullptr;
    if (spvc_context_parse_spirv(context_, spirv.data(), spirv.size(), &module) != SPVC_SUCCESS ||
        spvc_context_create_compiler(context_, backend, module, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                     &compiler_) != SPVC_SUCCESS) {
      const std::string reason = last_error();
      spvc_context_destroy(context_);
      throw std::invalid_argument("not a SPIR-V module SPIRV-Cross can read: " + reason);
    }
  }
  ~SpirvCrossSession() { spvc_context_destroy(context_); }
  SpirvCrossSession(const SpirvCrossSession&) = delete;
  SpirvCrossSession& operator=(const SpirvCrossSession&) = delete;

  spvc_compiler compiler() const { return compiler_; }
  std::string last_error() const { return spvc_context_get_last_error_string(context_); }

  void require(spvc_result result) const {
    if (result != SPVC_SUCCESS) throw std::invalid_argument(last_error());
  }

 private:
  spvc_context context_ = nullptr;
  spvc_compiler compiler_ = nullptr;
};

}  // namespace penumbra::shaders
