#include "validation/emitted_file.h"

#include <optional>
#include <system_error>

#include "input/file_name.h"
#include "platform/atomic_file.h"
#include "platform/content_hash.h"
#include "shaders/cross_compile.h"

namespace penumbra::validation {
namespace {

const char* ending(const std::string& target) {
  const std::optional<shaders::Target> known = shaders::find_target(target);
  if (!known) return ".spv";
  switch (shaders::target_language(*known)) {
    case shaders::TargetLanguage::msl:
      return ".metal";
    case shaders::TargetLanguage::hlsl:
      return ".hlsl";
    case shaders::TargetLanguage::essl:
    case shaders::TargetLanguage::glsl:
      break;
  }
  return ".glsl";
}

}  // namespace

std::string emitted_file_name(const CompileUnit& unit, const std::string& target) {
  constexpr std::size_t longest = 40;
  std::string name = file_name_part(
      unit.technique.empty() ? std::filesystem::path(unit.file).stem().string() : unit.technique, longest);
  if (name.empty() || name[0] == '.' || name[0] == '-') name.insert(0, "_");  // hidden, or like an option
  if (!unit.pass.empty()) name += "-" + file_name_part(unit.pass, longest);
  name += "-" + file_name_part(unit.compile.entry, longest) + "." + hlsl::stage_name(unit.compile.stage);
  std::string keywords;
  for (const std::string& keyword : unit.keywords) keywords += (keywords.empty() ? "." : "-") + keyword;
  name += file_name_part(keywords, longest);
  platform::ContentHash hash;
  hash.update(unit.file).update(unit.sub_shader);
  add_names(hash, unit);
  return name + "." + hash.hex().substr(0, 12) + "." + target + ending(target);
}

void write_emitted(const std::filesystem::path& folder, const CompileUnit& unit, const std::string& target,
                   std::string_view text) {
  std::error_code problem;  // which writing the file tells
  std::filesystem::create_directories(folder, problem);
  platform::write_file_atomically(folder / emitted_file_name(unit, target), text);
}

}  // namespace penumbra::validation
