// Reads the list of techniques.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "techniques/graph_emit.h"
#include "techniques/parameter_emit.h"
#include "techniques/technique_list.h"

namespace penumbra::fuzz {

void targets::technique_list(std::string_view bytes) {
  static const ScratchFolder folder;
  for (const char* named : {"a.hlsl", "a.shader", "a.compute"}) folder.write(named, "");
  const std::filesystem::path file = folder.write("fuzzed.technique.json", bytes);
  read([&] {
    const techniques::TechniqueList list = techniques::read_technique_list(file);
    for (const techniques::ParameterStruct& parameters : list.structs) {
      techniques::emit_hlsl(parameters);
      techniques::emit_csharp(parameters);
    }
    techniques::graph_rows(list);
    for (const techniques::Technique& technique : list.techniques)
      require(list.find(technique.name).name == technique.name, "a technique is found by its name");
  });
}

}  // namespace penumbra::fuzz
