#include "shaders/source_memory.h"

#include <filesystem>
#include <utility>

#include "preparation/bare_source.h"
#include "preparation/macro_arguments.h"
#include "preparation/source_directives.h"

namespace penumbra::shaders {

namespace {

constexpr char separator = '\0';  // a character that no path has

}  // namespace

SourceToExpand prepared_source(const std::string& text) {
  const preparation::PreparedSource prepared = preparation::prepare_source(text);
  std::string bare = preparation::bare_source(prepared.text);
  SourceToExpand source{
      {}, prepared.once, preparation::include_guard(bare), preparation::undefined_macros(bare)};
  source.text = preparation::with_own_names_marked(std::move(bare));
  return source;
}

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

const SourceToExpand& SourceMemory::prepared(const std::string& name) {
  File& known = file(name);
  if (!known.prepared) known.prepared = prepared_source(*known.source.text);
  return *known.prepared;
}

const preprocessing::CutSource& SourceMemory::cut(const std::string& name) {
  const std::string& text = prepared(name).text;
  File& known = file(name);
  if (!known.cut) known.cut = preprocessor_.cut(text);
  return *known.cut;
}

const preprocessing::CutSource& SourceMemory::cut_text(const std::string& text) {
  if (text_ != text) {
    cut_text_ = preprocessor_.cut(text);
    text_ = text;
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
