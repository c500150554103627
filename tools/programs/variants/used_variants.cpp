#include "variants/used_variants.h"

#include <algorithm>
#include <sstream>
#include <system_error>

#include "hlsl/source_text.h"
#include "input/ascii_case.h"
#include "input/input_error.h"
#include "variants/unity_asset.h"

namespace penumbra::variants {
namespace {

namespace fs = std::filesystem;

Keywords keywords_in(std::string_view text) {
  Keywords words;
  std::istringstream stream{std::string(text)};
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// Unity 2021.2 and later list m_ValidKeywords, one per line; earlier versions have all of them behind
// m_ShaderKeywords.
void read_material(const std::vector<AssetField>& fields,
                   std::map<std::string, std::vector<Keywords>>& materials) {
  std::string shader;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const AssetField& field = fields[i];
    if (field.name == "m_Shader") shader = guid_in(field.value);
    if (field.name != "m_ValidKeywords" && field.name != "m_ShaderKeywords") continue;
    Keywords on = field.value == "[]" ? Keywords() : keywords_in(field.value);
    while (i + 1 < fields.size() && fields[i + 1].begins_item && fields[i + 1].name.empty())
      on.emplace_back(fields[++i].value);
    materials[shader].push_back(std::move(on));
  }
}

void read_collection(const std::vector<AssetField>& fields,
                     std::map<std::string, std::vector<Keywords>>& materials) {
  std::string shader;
  for (const AssetField& field : fields) {
    if (field.name == "first") shader = guid_in(field.value);
    if (field.name == "keywords") materials[shader].push_back(keywords_in(field.value));
  }
}

// Returns what stands between `before` and `end`, or all behind `before`; empty without `before`.
std::string_view part_of(std::string_view line, std::string_view before, std::string_view end) {
  const std::size_t at = line.find(before);
  if (at == std::string_view::npos) return {};
  line.remove_prefix(at + before.size());
  return line.substr(0, line.find(end));
}

// A pass without a name is "<Unnamed Pass 1>", "<unnamed>" or "unnamed" in logs, and "0.1" here.
bool is_pass(std::string_view logged, const std::string& pass) {
  if (equal_ignoring_case(logged, pass)) return true;
  const std::size_t dot = pass.find('.');
  const bool unnamed = dot != std::string::npos && pass.find_first_not_of("0123456789.") == std::string::npos;
  constexpr std::string_view numbered = "<unnamed pass ";
  if (!unnamed) return false;
  if (equal_ignoring_case(logged.substr(0, numbered.size()), numbered))
    return logged.substr(numbered.size()) == pass.substr(dot + 1) + ">";
  return equal_ignoring_case(logged, "<unnamed>") || equal_ignoring_case(logged, "unnamed");
}

}  // namespace

void UsedVariants::add(std::string_view text, const std::string& file) {
  const std::string extension = fs::path(file).extension().string();
  if (extension == ".mat") {
    read_material(asset_fields(text, file), materials_);
  } else if (extension == ".shadervariants") {
    read_collection(asset_fields(text, file), materials_);
  } else {
    add_log(text, file);
  }
}

// The lines are "Uploaded shader variant to the GPU driver: NAME (instance 0x1C), pass: NAME, stage: vertex,
// keywords A B, time: 1.4 ms", and before Unity 2021 "Compiled shader: NAME, pass: NAME, stage: vertex,
// keywords A B"; a device's log puts its own words before them.
void UsedVariants::add_log(std::string_view text, const std::string& file) {
  bool found = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    for (const std::string_view begin :
         {"Uploaded shader variant to the GPU driver: ", "Compiled shader: "}) {
      std::string_view name = part_of(line, begin, ", pass: ");
      if (name.empty()) continue;
      name = name.substr(0, name.rfind(" (instance "));
      const std::string_view keywords = part_of(line, ", keywords ", ", time: ");
      logged_[std::string(name)].push_back({std::string(part_of(line, ", pass: ", ", ")),
                                            keywords.starts_with('<') ? Keywords() : keywords_in(keywords)});
      found = true;
    }
  }
  if (!found)
    throw InputError(
        file, "names no shader variant",
        "give a folder with materials, a .mat or .shadervariants file, or the log of a player that "
        "was built with Project Settings > Graphics > Log Shader Compilation");
}

std::optional<Narrowing> UsedVariants::narrow(Narrowing narrowing, const std::string& shader,
                                              const std::string& guid, const std::string& pass) const {
  if (logged_.empty()) {
    const auto used = materials_.find(guid);
    narrowing.materials = used == materials_.end() ? std::vector<Keywords>() : used->second;
    return narrowing;
  }
  narrowing.materials.emplace();
  narrowing.materials_decide_all = true;
  if (const auto used = logged_.find(shader); used != logged_.end())
    for (const LoggedVariant& variant : used->second)
      if (is_pass(variant.pass, pass)) narrowing.materials->push_back(variant.keywords);
  if (narrowing.materials->empty()) return std::nullopt;
  return narrowing;
}

UsedVariants read_used_variants(const std::vector<std::string>& places) {
  UsedVariants used;
  const auto add = [&](const fs::path& file) {
    const hlsl::SourceRead read = hlsl::read_source(file);
    if (!read.problem.empty()) throw InputError(file.string(), "cannot be read: " + read.problem);
    used.add(read.text, file.string());
  };
  for (const std::string& place : places) {
    if (!fs::is_directory(place)) {
      add(place);
      continue;
    }
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator at(place, error), end; !error && at != end; at.increment(error)) {
      const std::string extension = at->path().extension().string();
      if (!at->is_symlink(error) && at->is_regular_file(error) &&
          (extension == ".mat" || extension == ".shadervariants"))
        files.push_back(at->path());
    }
    if (error) throw InputError(place, "cannot be searched whole: " + error.message());
    if (files.empty())
      throw InputError(place, "has no material and no ShaderVariantCollection",
                       "give the Assets folder of the project");
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) add(file);
  }
  return used;
}

}  // namespace penumbra::variants
