// The list of techniques.
#include "fuzz/fuzz_input.h"
#include "shaders/technique_list.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace penumbra;
  static const fuzz::ScratchFolder folder;
  const std::filesystem::path file = folder.write("techniques.json", fuzz::text_of(data, size));
  fuzz::read([&] {
    const shaders::TechniqueList list = shaders::read_technique_list(file);
    shaders::emit_parameter_structs_hlsl(list);
    for (const shaders::Technique& technique : list.techniques)
      fuzz::require(list.find(technique.name).name == technique.name, "a technique is found by its name");
  });
  return 0;
}
