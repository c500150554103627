#include "shaders/compiler_version.h"

#include <glslang/Public/ShaderLang.h>

#include <spirv-tools/libspirv.hpp>

namespace penumbra::shaders {

std::string compiler_version() {
  const glslang::Version version = glslang::GetVersion();
  const std::string tools = spvSoftwareVersionString();
  return "glslang " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.patch) + ", SPIRV-Tools " + tools.substr(0, tools.find(' '));
}

}  // namespace penumbra::shaders
