// Tests the keys of kept results: whatever a manifest says of a picture is in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "input/input_error.h"
#include "platform/hashed_fields.h"
#include "reference/scratch_folder.h"
#include "study/study.h"

namespace penumbra::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// These fields are read by people, or say which values and programs are valid. Keys do not have them: the
// values and the programs themselves are there.
const std::set<std::string> kOfNoPicture{"family", "source", "use_when", "not_when",
                                         "doc",    "unit",   "range",    "type"};

// Every change moves what stands behind it in the file, and messages name places.
void forget_places(techniques::PassGraph& graph) {
  for (techniques::GraphTexture& texture : graph.textures) texture.where.clear();
  for (techniques::GraphPass& pass : graph.passes) pass.where.clear();
}

using Keys = std::map<std::string, std::string>;  // keys of techniques, by name

Keys keys_of(const fs::path& manifest) {
  Keys keys;
  const techniques::TechniqueList list = techniques::read_technique_list(manifest);
  for (const techniques::Technique& technique : list.techniques) {
    Subject subject = technique_subject(list, technique, true);
    forget_places(subject.graph.graph);
    if (subject.unlimited) forget_places(subject.unlimited->graph);
    keys.emplace(technique.name, platform::hash_of(subject));
  }
  return keys;
}

// Gives other values that may be valid in the place of this one.
std::vector<json> others(const json& value, const std::set<std::string>& texts) {
  if (value.is_boolean()) return {!value.get<bool>()};
  if (value.is_number_integer()) return {value.get<int>() + 1, value.get<int>() - 1, value.get<int>() * 2};
  if (value.is_number()) return {value.get<double>() * 0.75};
  std::vector<json> all{value.get<std::string>() + "2"};
  for (const std::string& text : texts)
    if (text != value) all.emplace_back(text);
  return all;
}

// The name under which a value stands in its manifest: an array's elements have the array's.
std::string field_of(const json::json_pointer& at) {
  json::json_pointer place = at;
  while (!place.empty() && place.back().find_first_not_of("0123456789") == std::string::npos)
    place = place.parent_pointer();
  return place.empty() ? std::string() : place.back();
}

bool is_binding(const std::string& field) {
  return field.starts_with("_") || field == "writes" || field == "visibility";
}

// Fields of one kind hold each other's values, as all that name textures do.
std::string kind_of(const json::json_pointer& at) {
  const std::string field = field_of(at);
  return is_binding(field) || field == "previous_of" ? "of a texture" : field;
}

class Manifest {
 public:
  Manifest() {
    for (const char* file : {"Every.hlsl", "Every.shader", "Every.compute", "Other.hlsl"})
      std::ofstream(folder_.path() / file) << "// here\n";
    whole_ =
        json::parse(std::ifstream(fs::path(PENUMBRA_SOURCE_DIR) / "tests/study/every_field.technique.json"));
    const json flat = whole_.flatten();
    for (const auto& [name, value] : flat.items())
      if (value.is_string()) texts_[kind_of(json::json_pointer(name))].insert(value.get<std::string>());
    for (auto& [kind, texts] : texts_)
      texts.insert({"Other.hlsl", "r8", "screen", "frame", "bake", "opaque", "medium", "spot", "float"});
    write(whole_);
    first_ = keys_of(file_);
  }

  // Changes every value in turn to another that is valid there, if one is, and leaves out each. Returns the
  // fields of which no change was valid.
  std::set<std::string> change_all() {
    std::set<std::string> unchanged;
    const json flat = whole_.flatten();
    for (const auto& [name, value] : flat.items()) unchanged.insert(field_of(json::json_pointer(name)));
    for (const auto& [name, value] : flat.items()) {
      const json::json_pointer at(name);
      if (is_of_source(at)) continue;
      for (const json& other : others(value, texts_[kind_of(at)])) {
        json changed = whole_;
        changed.at(at) = other;
        if (!is_valid(changed, name + " = " + other.dump(), field_of(at))) continue;
        unchanged.erase(field_of(at));
        break;
      }
      if (is_valid(without(at), name + " left out", field_of(at))) unchanged.erase(field_of(at));
      swap_bindings(at, flat, unchanged);
    }
    return unchanged;
  }

 private:
  // Whether the place belongs to a graph's source, which stands in for the visibility of the graph before and
  // has its own format.
  bool is_of_source(const json::json_pointer& at) const {
    const json& parent = whole_.at(at.parent_pointer());
    return parent.is_object() && parent.value("name", "") == "source";
  }

  // A texture in the place of another is often valid only if both change places.
  void swap_bindings(const json::json_pointer& at, const json& flat, std::set<std::string>& unchanged) const {
    if (!is_binding(field_of(at))) return;
    for (const auto& [name, value] : flat.items()) {
      const json::json_pointer other(name);
      if (!is_binding(field_of(other)) || whole_.at(other) == whole_.at(at)) continue;
      json changed = whole_;
      std::swap(changed.at(at), changed.at(other));
      if (is_valid(changed, at.to_string() + " swapped with " + name, field_of(at)))
        unchanged.erase(field_of(at));
    }
  }

  void write(const json& manifest) const { std::ofstream(file_) << manifest.dump(1); }

  json without(const json::json_pointer& at) const {
    json changed = whole_;
    json& parent = changed.at(at.parent_pointer());
    if (parent.is_array())
      parent.erase(std::stoul(at.back()));
    else
      parent.erase(at.back());
    return changed;
  }

  // Expects another key of a manifest that can be read.
  bool is_valid(const json& changed, const std::string& what, const std::string& field) const {
    write(changed);
    try {
      const Keys now = keys_of(file_);
      EXPECT_EQ(now == first_, kOfNoPicture.count(field) != 0) << what;
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  reference::ScratchFolder folder_;
  fs::path file_ = folder_.path() / "every_field.technique.json";
  json whole_;
  std::map<std::string, std::set<std::string>> texts_;  // those of each kind
  Keys first_;
};

TEST(ResultKey, ChangesWithEveryFieldOfAManifest) {
  // Two passes may write one texture because one of them writes its smaller levels. And all that a graph has
  // is what it reads of the one before it, and what it ends in.
  EXPECT_THAT(Manifest().change_all(), testing::ElementsAre("_Before", "_Source", "each_mip", "visibility"))
      << "nothing else stays untried";
}

}  // namespace
}  // namespace penumbra::study
