// Tests the programs and variants of a shader's own text and of what it includes.
#include "validation/shader_sources.h"

#include <gtest/gtest.h>

#include "shaders/shader_files.h"

namespace penumbra::validation {
namespace {

TEST(ShaderSources, IncludedPragmasAreFoundBesideTheShader) {
  const shaders::ShaderFiles files;
  files.write("package.json", "");
  files.write("shared/Both.hlsl", "#include_with_pragmas \"Keywords.hlsl\"\n");
  files.write("own/Keywords.hlsl", "#pragma multi_compile _ WIDE\n");
  files.write("own/K.compute", "#pragma kernel K\n#include_with_pragmas \"../shared/Both.hlsl\"\n");
  SourceOptions options;
  options.platforms = {{{}, {"spirv"}}};
  ShaderSources sources(options);
  sources.add({files.path("own/K.compute"), "K.compute"});
  EXPECT_EQ(sources.units().size(), 2U);
}

}  // namespace
}  // namespace penumbra::validation
