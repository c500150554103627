// Values of options, versions, patterns and names.
#include "cli/option_text.h"
#include "project/editor_includes.h"
#include "project/editor_version.h"
#include "project/include_search.h"
#include "project/package_version.h"
#include "project/path_pattern.h"

#include "fuzz/fuzz_input.h"
#include "variants/keyword_expression.h"

namespace {

using namespace penumbra;

void read_options(const std::string& text) {
  fuzz::read([&] { variants::unknown_keywords(variants::parse_keyword_expression(text), {}); });
  fuzz::read([&] { cli::name_and_value("--option", text); });
  fuzz::read([&] { cli::number("--option", text); });
  fuzz::read([&] { cli::require_plain_name("--option", text); });
  cli::split(text, ',');
  cli::shell_word(text);
}

void read_versions(const std::string& text) {
  if (const auto version = project::parse_package_version(text))
    fuzz::require(*version == *version, "a version equals itself");
  if (const auto version = project::parse_editor_version(text)) project::unity_version_number(*version);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const std::string text(fuzz::text_of(data, size));
  read_options(text);
  read_versions(text);
  const std::size_t end = text.find('\n');
  if (end != std::string::npos) project::path_matches(text.substr(0, end), text.substr(end + 1));
  project::editor_include(text);
  const std::filesystem::path includer = folder.write("Assets/a.hlsl", "");
  const project::IncludeSearch search =
      project::find_include({{}, {}, folder.path(), {}, {}}, text, includer);
  fuzz::require(search.file.has_value() != !search.problem.empty(), "an include has a file or a problem");
  if (search.file)
    fuzz::require(search.file->string().starts_with(folder.path().string()),
                  "no include leads out of the project");
  return 0;
}
