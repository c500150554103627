#include "cli/validate_options.h"

#include <algorithm>

#include "cli/known_names.h"
#include "cli/option_values.h"
#include "input/input_error.h"

namespace penumbra::cli {
namespace {

void add_what(CLI::App& command, ValidateOptions& options) {
  command
      .add_option("files", options.places,
                  ".shader, .compute and .hlsl files, or folders of .shader and .compute files")
      ->type_name("FILE")
      ->default_str("the library's techniques, unless --project is given");
  CLI::Option* project = add_project(command, options.project)
                             ->default_str("that of the files, where they are in its Assets/ or Packages/");
  command.add_flag("--no-project", options.no_project, "Files in a Unity project's folders are on their own")
      ->excludes(project);
  as_list(command.add_option("--only", options.only,
                             "Pattern of files to include, for example 'Assets/Water/**'"))
      ->type_name("PATTERN")
      ->default_str("every file");
  as_list(command.add_option("--skip", options.skip, "Pattern of files to exclude"))
      ->type_name("PATTERN")
      ->default_str("none");
  command.add_flag("--require-sources", options.require_sources,
                   "Fail where neither files nor --project are given, instead of validating the library");
  add_technique_list_option(command, options.techniques);
  command.add_option("--entry", options.entry, "Entry point of .hlsl files")->type_name("NAME");
  command.add_option("--stage", options.stage, "Stage of .hlsl files")
      ->type_name("STAGE")
      ->check(one_of({"vertex", "hull", "domain", "geometry", "fragment", "compute"}));
}

void add_with_what(CLI::App& command, ValidateOptions& options) {
  add_package_roots(command, options.package_roots);
  add_cginc_root(command, options.cginc_root);
  add_source_options(command, options.include_directories, options.defines);
  add_fxc(command, options.fxc);
  command.add_option("--unity-version", options.unity_version, "Unity version, which sets UNITY_VERSION")
      ->type_name("VERSION")
      ->default_str("the project's, else 2022.3");
  command.add_flag("--mobile", options.mobile,
                   "Define SHADER_API_MOBILE for every target, not only for ESSL");
}

void add_narrowing(CLI::App& command, ValidateOptions& options) {
  one_each(command.add_option("--keywords", options.keywords,
                              "Restrict the variants: '+ON -OFF A|B', separated by spaces or commas"))
      ->type_name("EXPRESSION")
      ->default_str("every variant");
  one_each(command.add_option("--keyword-set", options.keyword_sets,
                              "One keyword set of .hlsl files, as a comma-separated list"))
      ->type_name("KEYWORD[,...]")
      ->default_str("those of their pragmas");
  command
      .add_option("--stripping", options.stripping,
                  "JSON with the keywords and settings that the project uses; other variants are stripped")
      ->type_name("FILE")
      ->default_str("none");
  one_each(command.add_option("--used-by", options.used_by,
                              "Materials, ShaderVariantCollections, folders of them, or the log of a player: "
                              "other variants of .shader files are stripped"))
      ->type_name("PATH[,...]")
      ->default_str("none");
  one_each(command.add_option("--urp-asset", options.urp_assets,
                              "UniversalRenderPipelineAsset or UniversalRendererData that the project uses; "
                              "give every quality level and renderer"))
      ->type_name("FILE")
      ->default_str("none");
  command.add_option("--limit", options.limit, "Stop with an error if there are more results than this")
      ->type_name("N")
      ->check(within(0, 1e9));
  command
      .add_option("--sample", options.sample,
                  "Compile at most this many variants per entry point, spread evenly; 0: all")
      ->type_name("N")
      ->check(within(0, 1e9));
  CLI::Option* count = command.add_flag("--count", options.list,
                                        "Count the variants and compile nothing; --format text or json");
  command
      .add_option("--what-if", options.what_if,
                  "Count a second time with these restrictions, written as for --keywords: '-_FOAM' shows "
                  "what _FOAM adds")
      ->type_name("EXPRESSION")
      ->default_str("none")
      ->needs(count);
}

void add_checks(CLI::App& command, ValidateOptions& options) {
  takes(command,
        as_list(command.add_option("--target", options.targets,
                                   "Targets that each variant is compiled for; spirv is for Vulkan 1.1"))
            ->default_str("spirv,essl310,glsl450,msl23,hlsl50, and d3d11 where FXC is found"),
        "TARGET");
  command
      .add_option("--api", options.api,
                  "Compile for this graphics API only, and generate every target from that")
      ->type_name("API")
      ->check(one_of({"vulkan", "d3d11", "metal", "glcore", "gles3", "switch"}))
      ->default_str("each target's own");
  command
      .add_option("--explain", options.explain,
                  "Print the source of one variant as the parser reads it, with the origin of every line, "
                  "and compile nothing: "
                  "'PASS/ENTRY: KEYWORD KEYWORD'")
      ->type_name("VARIANT")
      ->default_str("none");
  command.add_flag("--minimize", options.minimise,
                   "Find the smallest set of keywords that causes each error");
  command.add_flag("--packages", options.packages,
                   "Messages in packages are as severe as those in files of your own; else they are notes");
  command.add_flag("--no-lint", options.no_lint, "Only compile, without the lint rules of docs/lint.md");
  takes(command,
        as_list(command.add_option("--disable-rule", options.disabled_rules, "Lint rules to disable"))
            ->default_str("none"),
        "RULE");
}

void add_how(CLI::App& command, ValidateOptions& options) {
  add_report_options(command, options.report);
  add_jobs(command, options.jobs);
  command
      .add_option("--shard", options.shard,
                  "Validate only part K of N; `penumbra merge` merges the JSON reports")
      ->type_name("K/N")
      ->default_str("1/1");
  command.add_option("--cache", options.cache, "Folder in which results are cached between runs")
      ->type_name("FOLDER")
      ->default_str("the user's cache");
  command.add_flag("--no-cache", options.no_cache, "Neither read nor write the cache");
  command.add_option("--keep", options.keep, "Folder for sources that crash or hang a compiler")
      ->type_name("FOLDER")
      ->default_str("below the cache; without one a new folder for temporary files");
  command
      .add_option("--emit-sources", options.emit_sources,
                  "Folder for what is generated of each variant: GLSL, ESSL, MSL, HLSL and SPIR-V; the cache "
                  "is not used")
      ->type_name("FOLDER")
      ->default_str("none");
  add_worker_limits(command, options.worker, "one variant");
}

}  // namespace

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  add_what(command, options);
  add_with_what(command, options);
  add_narrowing(command, options);
  add_checks(command, options);
  add_how(command, options);
}

void refuse_idle_options(const CLI::App& command, const ValidateOptions& options) {
  refuse_idle(
      command,
      {"--only", "--skip", "--entry", "--stage", "--keywords", "--keyword-set", "--stripping", "--used-by",
       "--urp-asset", "--limit", "--sample", "--unity-version", "--mobile", "--cginc-root", "--api"},
      options.places.empty() && options.project.empty(), "without shader files or --project");
  refuse_idle(command,
              {"--minimize", "--sample", "--shard", "--keep", "--root", "--verbose", "--werror", "--baseline",
               "--packages", "--emit-sources"},
              options.list, "with --count");
  refuse_idle(command,
              {"--minimize", "--sample", "--shard", "--format", "--root", "--verbose", "--werror",
               "--baseline", "--packages", "--emit-sources"},
              options.explain.has_value(), "with --explain");
  const std::string& form = options.report.form;
  refuse_idle(command, {"--root"}, form == "text" || form == "json", "with --format " + form);
  refuse_idle(command, {"--verbose"}, form == "json" || form == "junit", "with --format " + form);
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
