#include "shaders/source_memory.h"

#include <filesystem>
#include <utility>

#include "preparation/source_directives.h"

namespace penumbra::shaders {

namespace {

constexpr char separator = '\0';  // a character that no path has

}  // namespace

SourceMemory::File& SourceMemory::file(const std::string& name) {
  const auto [place, first] = files_.try_emplace(name);
  if (first) {
    hlsl::SourceRead read = hlsl::read_source(name);
    place->second.source = {std::make_shared<const std::string>(std::move(read.text)),
                            std::move(read.problem)};
  }
  return place->second;
}

const KnownSource& SourceMemory::read(const std::string& name) {
  return file(name).source;
}

const preprocessing::CutSource& SourceMemory::cut(const std::string& name, bool prepared) {
  File& known = file(name);
  std::optional<preprocessing::CutSource>& cut = prepared ? known.prepared : known.cut;
  const std::string& text = *known.source.text;
  if (!cut) cut = preprocessor_.cut(prepared ? preparation::prepare_source(text) : text);
  return *cut;
}

const preprocessing::CutSource& SourceMemory::cut_text(const std::string& text, bool prepared) {
  if (!text_ || text_->first != text || text_->second != prepared) {
    cut_text_ = preprocessor_.cut(prepared ? preparation::prepare_source(text) : text);
    text_ = {text, prepared};
  }
  return cut_text_;
}

// The result depends only on the includer's folder, and on whether there is an includer.
const project::IncludeSearch& SourceMemory::find(const project::IncludeRoots& roots,
                                                 const std::string& roots_key, std::string_view asked,
                                                 const std::string& includer) {
  std::string key = roots_key;
  key.append(asked).push_back(separator);
  if (!includer.empty()) key.append(1, '.').append(includer, 0, includer.find_last_of("/\\") + 1);
  const auto [place, first] = searches_.try_emplace(std::move(key));
  if (first) place->second = project::find_include(roots, asked, includer);
  return place->second;
}

std::string key_of(const project::IncludeRoots& roots) {
  std::string key;
  const auto add = [&](const std::string& text) { key.append(text).push_back(separator); };
  for (const project::PackageRoot& root : roots.packages) {
    add(root.name);
    add(root.directory.string());
  }
  add({});  // a name is never empty: the packages end here
  for (const std::filesystem::path& directory : roots.directories) add(directory.string());
  add("/");
  add(roots.project.string());
  add(roots.cginc.string());
  add(roots.main_folder.string());
  for (const std::filesystem::path& folder : roots.own) add(folder.string());
  return key;
}

}  // namespace penumbra::shaders
