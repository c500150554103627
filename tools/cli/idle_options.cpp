#include "cli/idle_options.h"

#include <algorithm>

#include "input/input_error.h"

namespace penumbra::cli {

void refuse_idle(const CLI::App& command, const std::vector<std::string>& names, bool idle,
                 const std::string& because) {
  if (!idle) return;
  for (const std::string& name : names)
    if (command.get_option(name)->count() > 0)
      throw InputError("", name + " has no effect " + because, "leave it out");
}

void refuse_idle_options(const CLI::App& command, const ValidateOptions& options) {
  refuse_idle(command,
              {"--only", "--skip", "--entry", "--stage", "--keywords", "--keyword-set", "--stripping",
               "--urp-asset", "--limit", "--sample", "--unity-version", "--mobile", "--cginc-root", "--api"},
              options.places.empty() && options.project.empty(), "without shader files or --project");
  refuse_idle(command, {"--minimize", "--sample", "--shard", "--keep", "--root", "--verbose"}, options.list,
              "with --count");
  refuse_idle(command, {"--minimize", "--sample", "--shard", "--format", "--root", "--verbose"},
              options.explain.has_value(), "with --explain");
  const std::string& form = options.report.form;
  refuse_idle(command, {"--root"}, form == "text" || form == "json", "with --format " + form);
  refuse_idle(command, {"--verbose"}, form != "text", "with --format " + form);
  refuse_idle(command, {"--disable-rule"}, options.no_lint, "with --no-lint");
  refuse_idle(command, {"--cache"}, options.no_cache, "with --no-cache");
}

std::vector<std::string> idle_option_warnings(const CLI::App& command, const project::ShaderFiles& files) {
  const bool has_hlsl = std::any_of(files.files.begin(), files.files.end(),
                                    [](const auto& file) { return file.path.extension() == ".hlsl"; });
  std::vector<std::string> warnings;
  for (const char* name : {"--entry", "--stage", "--keyword-set"})
    if (!has_hlsl && command.get_option(name)->count() > 0)
      warnings.push_back(std::string("warning: ") + name + " has no effect: no .hlsl file is given");
  return warnings;
}

}  // namespace penumbra::cli
