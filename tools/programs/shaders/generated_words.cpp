#include "shaders/generated_words.h"

#include "shaders/module_corrections.h"

namespace penumbra::shaders {

SpirvModule generated_words(const glslang::TIntermediate& tree, bool debug_lines,
                            spv::SpvBuildLogger& logger) {
  glslang::SpvOptions options;
  options.disableOptimizer = true;  // our code calls SPIRV-Tools
  options.generateDebugInfo = debug_lines;
  std::vector<unsigned int> words;
  glslang::GlslangToSpv(tree, words, &logger, &options);
  SpirvModule module(words.begin(), words.end());
  copy_scalar_conditions(module);
  truncate_remainders(module);
  make_whole_matrices_arrays(module);
  zero_statics(module);
  flatten_integer_inputs(module);
  drop_gather_bias(module);
  split_gathers(module);
  return module;
}

SpirvModule words_with_lines(const glslang::TIntermediate& tree, bool optimised, VulkanVersion vulkan) {
  spv::SpvBuildLogger messages;
  SpirvModule module = generated_words(tree, true, messages);
  std::vector<std::string> problems;
  if (optimised && !optimise(module, vulkan, problems)) return {};
  number_bindings(module);
  return module;
}

}  // namespace penumbra::shaders
