// Reads the list of techniques.
#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "techniques/feature_tables.h"
#include "techniques/parameter_emit.h"
#include "techniques/technique_list.h"

namespace penumbra::fuzz {
namespace {

// The package that a manifest's "library" may name.
constexpr const char* kLibrary = R"({"order": 1,
  "structs": [{"name": "P", "doc": "d", "fields": [
    {"name": "taps", "type": "int", "unit": "1", "doc": "d", "range": [1, 9], "default": 3}]}],
  "graphs": [{"name": "blur", "passes": [
    {"name": "F", "kind": "filter", "filter": {"file": "../a.hlsl", "function": "F", "parameters": "P"}}]}],
  "techniques": [{"name": "box", "title": "Box", "family": "box", "source": "Nobody 1900", "graph": "blur"}]})";

}  // namespace

void targets::technique_list(std::string_view bytes) {
  static const ScratchFolder folder;
  for (const char* named : {"a.hlsl", "a.shader", "a.compute"}) folder.write(named, "");
  folder.write("package.json", "{}");
  folder.write("Shaders/Library.technique.json", kLibrary);
  const std::filesystem::path file = folder.write("fuzzed.technique.json", bytes);
  read([&] {
    const techniques::TechniqueList list = techniques::read_technique_list(file);
    for (const techniques::ParameterStruct& parameters : list.structs) techniques::emit_hlsl(parameters);
    techniques::emit_csharp(list.structs, "FuzzedParameters");
    techniques::graph_rows(list);
    for (const techniques::Technique& technique : list.techniques)
      require(list.find(technique.name).name == technique.name, "a technique is found by its name");
  });
}

}  // namespace penumbra::fuzz
