#include "cli/validate_options.h"

#include <CLI/CLI.hpp>

#include "cli/known_names.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"

namespace penumbra::cli {

namespace {

void add_what(CLI::App& command, ValidateOptions& options) {
  command.add_option("files", options.places, ".shader, .compute and .hlsl files, or folders of them")
      ->type_name("FILE")
      ->default_str("the library's techniques, where there is no --project either");
  add_project(command, options.project);
  as_list(
      command.add_option("--only", options.only, "Pattern of files to take, for example 'Assets/Water/**'"))
      ->type_name("PATTERN")
      ->default_str("every file");
  as_list(command.add_option("--skip", options.skip, "Pattern of files to leave out"))
      ->type_name("PATTERN")
      ->default_str("none");
  command.add_option("--technique-list", options.techniques, "List of techniques to validate")
      ->type_name("FILE")
      ->default_str("the library's");
  command.add_option("--entry", options.entry, "Entry point of .hlsl files")->type_name("NAME");
  command.add_option("--stage", options.stage, "Stage of .hlsl files")
      ->type_name("STAGE")
      ->check(one_of({"vertex", "hull", "domain", "geometry", "fragment", "compute"}));
}

void add_with_what(CLI::App& command, ValidateOptions& options) {
  add_package_roots(command, options.package_roots);
  add_cginc_root(command, options.cginc_root);
  add_source_options(command, options.include_directories, options.defines);
  command.add_option("--unity-version", options.unity_version, "For UNITY_VERSION")
      ->type_name("VERSION")
      ->default_str("the project's, else 2022.3");
  command.add_flag("--mobile", options.mobile, "SHADER_API_MOBILE for every target, as it is for ESSL");
}

void add_narrowing(CLI::App& command, ValidateOptions& options) {
  one_each(command.add_option("--keywords", options.keywords,
                              "Narrow the variants: '+ON -OFF A|B', parted by blanks or commas"))
      ->type_name("EXPRESSION")
      ->default_str("every variant");
  one_each(command.add_option("--keyword-set", options.keyword_sets,
                              "One keyword set of .hlsl files, its keywords parted by commas"))
      ->type_name("KEYWORD[,...]")
      ->default_str("those of their pragmas");
  command.add_option("--stripping", options.stripping, "What the project really uses, as JSON")
      ->type_name("FILE")
      ->default_str("none");
  one_each(
      command.add_option(
          "--urp-asset", options.urp_assets,
          "UniversalRenderPipelineAsset or UniversalRendererData whose settings the project uses, one for "
          "every quality level and renderer"))
      ->type_name("FILE")
      ->default_str("none");
  command.add_option("--limit", options.limit, "Refuse more variants than this")->type_name("N");
  command
      .add_option("--sample", options.sample,
                  "Of each entry point at most so many variants, spread evenly; 0: all")
      ->type_name("N");
  CLI::Option* count = command.add_flag("--count", options.list,
                                        "Count the variants and compile nothing; --format text or json");
  command
      .add_option(
          "--what-if", options.what_if,
          "Count again with these keywords, too, written as for --keywords: '-_FOAM' says what _FOAM adds")
      ->type_name("EXPRESSION")
      ->default_str("none")
      ->needs(count);
}

void add_checks(CLI::App& command, ValidateOptions& options) {
  takes(command,
        as_list(command.add_option("--target", options.targets,
                                   "What each variant is made into; spirv is for Vulkan 1.1"))
            ->default_str("spirv,essl310,glsl450,msl23,hlsl50"),
        "TARGET");
  command.add_option("--api", options.api, "Compile for this API alone and make every target from that")
      ->type_name("API")
      ->check(one_of({"vulkan", "d3d11", "metal", "glcore", "gles3", "switch"}))
      ->default_str("each target's own");
  command
      .add_option(
          "--explain", options.explain,
          "Print one variant as the parser reads it, with the origin of every line, and compile nothing: "
          "'PASS/ENTRY: KEYWORD KEYWORD'")
      ->type_name("VARIANT")
      ->default_str("none");
  command.add_flag("--minimize", options.minimise, "Say which few keywords each error needs");
  command.add_flag("--no-lint", options.no_lint, "Compile alone; Documentation~/lint.md has the rules");
  takes(command,
        as_list(command.add_option("--disable-rule", options.disabled_rules, "Lint rules to leave out"))
            ->default_str("none"),
        "RULE");
}

void add_how(CLI::App& command, ValidateOptions& options) {
  add_report_options(command, options.report);
  add_jobs(command, options.jobs);
  command
      .add_option("--shard", options.shard, "The K-th of N parts; `penumbra merge` joins their JSON reports")
      ->type_name("K/N")
      ->default_str("1/1");
  command.add_option("--cache", options.cache, "Folder that keeps answers between runs")
      ->type_name("FOLDER")
      ->default_str("the user's cache");
  command.add_flag("--no-cache", options.no_cache, "Keep nothing, and use nothing that was kept");
  command.add_option("--keep", options.keep, "Folder for texts that crash or hang a compiler")
      ->type_name("FOLDER")
      ->default_str("below the cache");
  command.add_option("--time-limit", options.time_limit, "Seconds of processor time for one variant")
      ->type_name("SECONDS")
      ->check(within(1, 3600));
  command.add_option("--memory-limit", options.memory_limit, "MiB for one worker")
      ->type_name("MIB")
      ->check(within(64, 65536));
}

void add_written(CLI::App& command, ValidateOptions& options) {
  const auto add = [&](const char* name, std::string& file, const char* description) {
    command.add_option(name, file, description)
        ->type_name("FILE")
        ->default_str("none")
        ->group("Writes a file (- is standard output) and validates nothing");
  };
  add("--emit-parameters", options.emit_parameters, "The techniques' parameter structs as HLSL");
  add("--emit-presets", options.emit_presets, "The quality presets as C#");
  add("--emit-looks", options.emit_looks, "The looks as C#");
  add("--emit-programs", options.emit_programs,
      "Which programs of the renderer feature's shader each quality preset keeps in a player, as JSON");
}

}  // namespace

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  add_what(command, options);
  add_with_what(command, options);
  add_narrowing(command, options);
  add_checks(command, options);
  add_how(command, options);
  add_written(command, options);
}

}  // namespace penumbra::cli
