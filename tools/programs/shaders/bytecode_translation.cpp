#include "shaders/bytecode_reflection.h"

#include <vkd3d_shader.h>

#include <cstring>
#include <stdexcept>

#include "shaders/bytecode_module.h"

namespace penumbra::shaders {

namespace {

vkd3d_shader_descriptor_type descriptor_type(RegisterKind kind) {
  switch (kind) {
    case RegisterKind::constants:
      return VKD3D_SHADER_DESCRIPTOR_TYPE_CBV;
    case RegisterKind::texture:
      return VKD3D_SHADER_DESCRIPTOR_TYPE_SRV;
    case RegisterKind::writable:
      return VKD3D_SHADER_DESCRIPTOR_TYPE_UAV;
    case RegisterKind::sampler:
      break;
  }
  return VKD3D_SHADER_DESCRIPTOR_TYPE_SAMPLER;
}

std::vector<vkd3d_shader_resource_binding> bindings_of(const std::vector<BytecodeResource>& resources) {
  std::vector<vkd3d_shader_resource_binding> bindings;
  for (const BytecodeResource& resource : resources) {
    vkd3d_shader_resource_binding binding{};
    binding.type = descriptor_type(resource.registers);
    binding.register_index = resource.index;
    binding.shader_visibility = VKD3D_SHADER_VISIBILITY_ALL;
    const bool buffer = resource.buffer || resource.registers == RegisterKind::constants;
    binding.flags = buffer ? VKD3D_SHADER_BINDING_FLAG_BUFFER : VKD3D_SHADER_BINDING_FLAG_IMAGE;
    binding.binding = {0, static_cast<unsigned>(bindings.size()), 1};
    bindings.push_back(binding);
  }
  return bindings;
}

// vkd3d prints what it skips, such as the type of a texture, which the declaration also has.
void silence_once() {
#ifndef _WIN32
  static const int done = ::setenv("VKD3D_SHADER_DEBUG", "none", 0);  // NOLINT(concurrency-mt-unsafe)
  static_cast<void>(done);
#endif
}

}  // namespace

bool translates_bytecode() {
  return true;
}

SpirvModule translated_bytecode(const std::string& bytecode, const std::vector<BytecodeResource>& resources) {
  silence_once();
  const std::vector<vkd3d_shader_resource_binding> bindings = bindings_of(resources);
  vkd3d_shader_interface_info interface {};
  interface.type = VKD3D_SHADER_STRUCTURE_TYPE_INTERFACE_INFO;
  interface.bindings = bindings.data();
  interface.binding_count = static_cast<unsigned>(bindings.size());
  const vkd3d_shader_compile_option option{VKD3D_SHADER_COMPILE_OPTION_BUFFER_UAV,
                                           VKD3D_SHADER_COMPILE_OPTION_BUFFER_UAV_STORAGE_BUFFER};
  vkd3d_shader_compile_info info{};
  info.type = VKD3D_SHADER_STRUCTURE_TYPE_COMPILE_INFO;
  info.next = &interface;
  info.source = {bytecode.data(), bytecode.size()};
  info.source_type = VKD3D_SHADER_SOURCE_DXBC_TPF;
  info.target_type = VKD3D_SHADER_TARGET_SPIRV_BINARY;
  info.options = &option;
  info.option_count = 1;
  info.log_level = VKD3D_SHADER_LOG_ERROR;
  vkd3d_shader_code code{};
  char* messages = nullptr;
  const int result = vkd3d_shader_compile(&info, &code, &messages);
  const std::string said = messages == nullptr ? "" : messages;
  vkd3d_shader_free_messages(messages);
  if (result < 0)
    throw std::invalid_argument("vkd3d-shader does not translate the bytecode" +
                                (said.empty() ? "" : ": " + said));
  SpirvModule module(code.size / sizeof(std::uint32_t));
  std::memcpy(module.data(), code.code, module.size() * sizeof(std::uint32_t));
  vkd3d_shader_free_shader_code(&code);
  return module;
}

}  // namespace penumbra::shaders
