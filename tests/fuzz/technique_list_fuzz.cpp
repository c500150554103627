// The list of techniques.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "shaders/technique_list.h"

namespace penumbra::fuzz {

void targets::technique_list(std::string_view bytes) {
  static const ScratchFolder folder;
  const std::filesystem::path file = folder.write("techniques.json", bytes);
  read([&] {
    const shaders::TechniqueList list = shaders::read_technique_list(file);
    shaders::emit_parameter_structs_hlsl(list);
    for (const shaders::Technique& technique : list.techniques)
      require(list.find(technique.name).name == technique.name, "a technique is found by its name");
  });
}

}  // namespace penumbra::fuzz
