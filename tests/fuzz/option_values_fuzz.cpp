// Reads values of options, versions, patterns and names.
#include "cli/option_text.h"
#include "project/editor_includes.h"
#include "project/include_search.h"
#include "project/package_version.h"
#include "project/shader_files.h"
#include "project/unity_project.h"

#include "fuzz/fuzz_input.h"
#include "fuzz/targets.h"
#include "variants/narrowing.h"

namespace penumbra::fuzz {

namespace {

void read_options(const std::string& text) {
  read([&] { variants::unknown_keywords(variants::parse_keyword_expression(text), {}); });
  read([&] { cli::name_and_value("--option", text); });
  read([&] { cli::number("--option", text); });
  read([&] { cli::require_plain_name("--option", text); });
  cli::split(text, ',');
  cli::shell_word(text);
}

void read_versions(const std::string& text) {
  if (const auto version = project::parse_package_version(text))
    require(*version == *version, "a version equals itself");
  if (const auto version = project::parse_editor_version(text)) project::unity_version_number(*version);
}

}  // namespace

void targets::option_values(std::string_view bytes) {
  static const ScratchFolder folder;
  const std::string text(bytes);
  read_options(text);
  read_versions(text);
  const std::size_t end = text.find('\n');
  if (end != std::string::npos) project::path_matches(text.substr(0, end), text.substr(end + 1));
  project::editor_include(text);
  const std::filesystem::path includer = folder.write("Assets/a.hlsl", "");
  const project::IncludeSearch search =
      project::find_include({{}, {}, folder.path(), {}, {}}, text, includer);
  require(search.file.has_value() != !search.problem.empty(), "an include has a file or a problem");
  if (search.file)
    require(search.file->string().starts_with(folder.path().string()), "no include leads out of the project");
}

}  // namespace penumbra::fuzz
