// What Unity asks of a package's files: each visible one that ships has a .meta, and no two share a GUID.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "architecture/repository.h"

namespace penumbra::architecture {
namespace {

using testing::IsEmpty;

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::vector<std::string> shipped(const Tree& tree) {
  std::vector<std::string> paths;
  const nlohmann::json whitelist = nlohmann::json::parse(tree.at("package.json")).at("files");
  for (const auto& [path, text] : tree) {
    for (const nlohmann::json& entry : whitelist) {
      const std::string name = entry.get<std::string>();
      if (path == name || (ends_with(name, "/") && path.rfind(name, 0) == 0)) {
        paths.push_back(path);
        break;
      }
    }
  }
  return paths;
}

// The file itself and every folder on its way.
std::vector<std::string> visible_parts(const std::string& path) {
  std::vector<std::string> parts{path};
  for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1)) {
    parts.push_back(path.substr(0, slash));
  }
  return parts;
}

std::vector<std::string> without_meta(const Tree& tree) {
  std::vector<std::string> missing;
  for (const std::string& path : shipped(tree)) {
    if (ends_with(path, ".meta")) continue;
    for (const std::string& part : visible_parts(path)) {
      if (tree.count(part + ".meta") == 0) missing.push_back(part);
    }
  }
  return missing;
}

std::vector<std::string> shared_guids(const Tree& tree) {
  std::map<std::string, std::string> owner;
  std::vector<std::string> shared;
  for (const auto& [path, text] : tree) {
    if (!ends_with(path, ".meta")) continue;
    const std::size_t at = text.find("guid: ");
    const std::string guid = at == std::string::npos ? "" : text.substr(at + 6, 32);
    if (guid.find_first_not_of("0123456789abcdef") != std::string::npos || guid.size() != 32 ||
        !owner.emplace(guid, path).second) {
      shared.push_back(path);
    }
  }
  return shared;
}

const Tree& repository() {
  static const Tree tree = read_repository(PENUMBRA_SOURCE_DIR);
  return tree;
}

TEST(Package, EveryShippedPathHasAMeta) {
  EXPECT_THAT(without_meta(repository()), IsEmpty());
}
TEST(Package, GuidsAreWholeAndUnique) {
  EXPECT_THAT(shared_guids(repository()), IsEmpty());
}

TEST(Package, ShipsNoToolAndNoCpp) {
  for (const std::string& path : shipped(repository())) {
    EXPECT_FALSE(ends_with(path, ".cpp") || path.rfind("tools/", 0) == 0) << path;
  }
  EXPECT_FALSE(shipped(repository()).empty());
}

TEST(Package, AMissingMetaAndASharedGuidAreSeen) {
  const std::string guid = "guid: 0123456789abcdef0123456789abcdef\n";
  const Tree tree{{"package.json", R"({"files": ["package.json", "A/"]})"},
                  {"package.json.meta", guid},
                  {"A/a.hlsl", ""},
                  {"A.meta", guid}};
  EXPECT_THAT(without_meta(tree), testing::ElementsAre("A/a.hlsl"));
  EXPECT_EQ(shared_guids(tree).size(), 1u);
}

}  // namespace
}  // namespace penumbra::architecture
