#include "validation/variant_name.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "input/input_error.h"
#include "input/nearest_name.h"
#include "validation/spirv_target.h"

namespace penumbra::validation {

namespace {

struct NamedEntry {
  const SourceProgram* program = nullptr;
  std::size_t index = 0;  // the index for ShaderSources::entry_unit()
  std::string function;
  std::string title;  // "Forward/Frag"
};

bool makes_spirv(const SourceProgram& program) {
  return std::any_of(program.targets.begin(), program.targets.end(), is_spirv_target);
}

// Returns one entry for each graphics API, those for SPIR-V first.
std::vector<NamedEntry> all_entries(const ShaderSources& sources) {
  std::vector<NamedEntry> entries;
  const auto add = [&entries](const SourceProgram& program, const std::string& function, std::size_t index) {
    entries.push_back(
        {&program, index, function, program.pass.empty() ? function : program.pass + "/" + function});
  };
  for (const SourceProgram& program : sources.programs()) {
    std::size_t index = 0;
    for (const auto& [function, stage] : program.entries) add(program, function, index++);
    for (const variants::Kernel& kernel : program.kernels) add(program, kernel.function, index++);
  }
  std::stable_partition(entries.begin(), entries.end(),
                        [](const NamedEntry& entry) { return makes_spirv(*entry.program); });
  return entries;
}

// Returns the first of an entry point's entries for several graphics APIs.
std::vector<NamedEntry> fitting(const std::vector<NamedEntry>& entries, const VariantName& name) {
  std::vector<NamedEntry> list;
  for (const NamedEntry& entry : entries) {
    const bool fits = (name.pass.empty() || name.pass == entry.program->pass) &&
                      (name.entry.empty() || name.entry == entry.function);
    const bool is_new = std::none_of(list.begin(), list.end(), [&](const NamedEntry& other) {
      return other.program->file == entry.program->file && other.title == entry.title &&
             other.program->sub_shader == entry.program->sub_shader;
    });
    if (fits && is_new) list.push_back(entry);
  }
  return list;
}

std::string spelt(const VariantName& name) {
  return name.pass.empty() ? name.entry : name.pass + "/" + name.entry;
}

NamedEntry find_entry(const ShaderSources& sources, const VariantName& name) {
  const std::vector<NamedEntry> all = all_entries(sources);
  const std::vector<NamedEntry> found = fitting(all, name);
  if (all.empty())
    throw InputError("--explain", "there is no entry point '" + spelt(name) + "', nor any other",
                     "the messages above say which files could not be read; others name no entry point");
  if (found.empty()) {
    std::vector<std::string> known;
    for (const NamedEntry& entry : all)
      if (std::find(known.begin(), known.end(), entry.title) == known.end()) known.push_back(entry.title);
    throw InputError("--explain", "unknown entry point '" + spelt(name) + "'",
                     unknown_name_remedy(spelt(name), known));
  }
  if (found.size() == 1) return found.front();
  std::string list = "one of:";
  for (const NamedEntry& entry : found)
    list +=
        "\n    " + entry.program->file + ": " + entry.title +
        (entry.program->sub_shader == 0 ? "" : " of SubShader " + std::to_string(entry.program->sub_shader));
  throw InputError("--explain",
                   "'" + spelt(name) + "' names " + std::to_string(found.size()) + " entry points", list);
}

void check_keywords(const NamedEntry& entry, const variants::Keywords& keywords) {
  std::vector<std::string> declared;
  for (const variants::KeywordSet& set : entry.program->pragmas.keyword_sets)
    for (const std::string& keyword : variants::keywords_of(set)) declared.push_back(keyword);
  for (const std::string& keyword : keywords)
    if (std::find(declared.begin(), declared.end(), keyword) == declared.end())
      throw InputError("--explain", entry.title + " declares no keyword '" + keyword + "'",
                       unknown_name_remedy(keyword, declared));
}

}  // namespace

VariantName parse_variant_name(const std::string& text) {
  VariantName name;
  const std::size_t colon = text.find(':');
  std::string entry = text.substr(0, colon);
  entry.erase(entry.find_last_not_of(' ') + 1);
  const std::size_t slash = entry.rfind('/');
  if (slash != std::string::npos) name.pass = entry.substr(0, slash);
  name.entry = slash == std::string::npos ? entry : entry.substr(slash + 1);
  if (colon == std::string::npos) return name;
  std::istringstream keywords(text.substr(colon + 1));
  for (std::string keyword; keywords >> keyword;)
    if (keyword != "_") name.keywords.push_back(keyword);
  return name;
}

CompileUnit find_variant(const ShaderSources& sources, const VariantName& name) {
  const NamedEntry entry = find_entry(sources, name);
  check_keywords(entry, name.keywords);
  return sources.entry_unit(*entry.program, entry.index, name.keywords);
}

}  // namespace penumbra::validation
