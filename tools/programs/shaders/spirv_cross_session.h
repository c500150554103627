// SPIR-V modules in SPIRV-Cross's C API. Internal to this folder.
#pragma once

#include <spirv_cross/spirv_cross_c.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace penumbra::shaders {

// A parsed module; it must outlive its sessions.
class SpirvCrossModule {
 public:
  // Throws std::invalid_argument when the words are no SPIR-V module.
  explicit SpirvCrossModule(const std::vector<std::uint32_t>& spirv) {
    if (spirv.size() < 5 || spirv[0] != SpvMagicNumber) throw std::invalid_argument("not a SPIR-V module");
    if (spvc_context_create(&context_) != SPVC_SUCCESS) throw std::bad_alloc();
    if (spvc_context_parse_spirv(context_, spirv.data(), spirv.size(), &module_) != SPVC_SUCCESS) {
      const std::string reason = last_error();
      spvc_context_destroy(context_);
      throw std::invalid_argument("not a SPIR-V module SPIRV-Cross can read: " + reason);
    }
  }
  ~SpirvCrossModule() { spvc_context_destroy(context_); }
  SpirvCrossModule(const SpirvCrossModule&) = delete;
  SpirvCrossModule& operator=(const SpirvCrossModule&) = delete;

 private:
  friend class SpirvCrossSession;

  std::string last_error() const { return spvc_context_get_last_error_string(context_); }

  spvc_context context_ = nullptr;
  spvc_parsed_ir module_ = nullptr;
};

// A back end that processes the module.
class SpirvCrossSession {
 public:
  // Throws std::invalid_argument when the module is not one for this back end.
  SpirvCrossSession(const SpirvCrossModule& module, spvc_backend backend) : module_(module) {
    require(spvc_context_create_compiler(module.context_, backend, module.module_, SPVC_CAPTURE_MODE_COPY,
                                         &compiler_));
  }

  spvc_compiler compiler() const { return compiler_; }
  std::string last_error() const { return module_.last_error(); }

  void require(spvc_result result) const {
    if (result != SPVC_SUCCESS) throw std::invalid_argument(last_error());
  }

 private:
  const SpirvCrossModule& module_;
  spvc_compiler compiler_ = nullptr;  // the module's context frees it
};

}  // namespace penumbra::shaders
