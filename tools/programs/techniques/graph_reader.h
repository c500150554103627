// Reads and checks one graph of a manifest. Internal to this folder.
#pragma once

#include "project/include_bounds.h"
#include "techniques/manifest_reader.h"

namespace penumbra::techniques {

// The files that a manifest names: relative to its folder, and in the list relative to the package's if they
// lie in that. Files outside of the manifest's own tree and of the package are refused: messages quote lines
// of them, and a manifest may come from an untrusted source.
class ManifestFiles {
 public:
  ManifestFiles(const std::filesystem::path& manifest, const std::filesystem::path& package);

  // Throws if there is no such file to read.
  std::string required(JsonObject& object, const std::string& key) const;
  std::string named(const std::filesystem::path& file) const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path package_;
  std::filesystem::path tree_;
  project::IncludeBounds bounds_;
};

// Reads a graph of technique.schema.json, over the graphs that are known by then.
PassGraph read_graph(JsonObject& object, const TechniqueList& list, const ManifestFiles& files,
                     const std::map<std::string, PassGraph>& known);

FilterCall read_filter(JsonObject object, const TechniqueList& list, const ManifestFiles& files);

}  // namespace penumbra::techniques
