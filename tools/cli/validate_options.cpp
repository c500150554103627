#include "cli/validate_options.h"

#include <CLI/CLI.hpp>

namespace penumbra::cli {

namespace {

void add_what(CLI::App& command, ValidateOptions& options) {
  command.add_option(
      "files", options.places,
      ".shader, .compute and .hlsl files, or folders of them; without any and without --project, the "
      "library's techniques");
  command.add_option("--project", options.project,
                     "Unity project: its Assets/ and Packages/, and where packages lie");
  command.add_option("--only", options.only, "Pattern of files to take: 'Assets/Water/**'")
      ->allow_extra_args(false);
  command.add_option("--skip", options.skip, "Pattern of files to leave out")->allow_extra_args(false);
  command.add_option("--technique-list", options.techniques, "Technique list; the library's without");
  command.add_option("--entry", options.entry, "Entry point of .hlsl files")->capture_default_str();
  command.add_option("--stage", options.stage, "Stage of .hlsl files")
      ->check(CLI::IsMember({"vertex", "hull", "domain", "geometry", "fragment", "compute"}))
      ->capture_default_str();
}

void add_with_what(CLI::App& command, ValidateOptions& options) {
  command.add_option("--package-root", options.package_roots, "NAME=DIR: where Packages/NAME/... lies")
      ->allow_extra_args(false);
  command.add_option("--cginc-root", options.cginc_root, "Editor/Data/CGIncludes of a Unity editor");
  command.add_option("-I,--include", options.include_directories, "Folder to look for includes in")
      ->allow_extra_args(false);
  command.add_option("-D,--define", options.defines, "NAME or NAME=VALUE, for every variant")->take_all();
  command.add_option("--unity-version", options.unity_version,
                     "For UNITY_VERSION; the project's, else 2022.3");
  command.add_flag("--mobile", options.mobile, "SHADER_API_MOBILE for every target, as it is for ESSL");
}

void add_which(CLI::App& command, ValidateOptions& options) {
  command.add_option("--keywords", options.keywords, "Narrow the variants: '+ON -OFF A|B'")
      ->allow_extra_args(false);
  command
      .add_option("--keyword-set", options.keyword_sets,
                  "One keyword set of .hlsl files instead of their pragmas: A,B; repeat for more")
      ->allow_extra_args(false);
  command.add_option("--stripping", options.stripping, "What the project really uses, as JSON")
      ->check(CLI::ExistingFile);
  command
      .add_option("--urp-asset", options.urp_assets,
                  "UniversalRenderPipelineAsset or UniversalRendererData whose settings the project uses; "
                  "repeat for every quality level and renderer")
      ->allow_extra_args(false);
  command.add_option("--limit", options.limit, "Refuse more variants than this")->capture_default_str();
  command.add_option("--sample", options.sample,
                     "Of each entry point at most so many variants, spread evenly");
  CLI::Option* list = command.add_flag("--count", options.list,
                                       "Count the variants and compile nothing; --format text or json");
  command
      .add_option(
          "--what-if", options.what_if,
          "With --list: count again with these keywords, too, written as for --keywords: '-_FOAM' says "
          "what _FOAM adds")
      ->needs(list);
  command
      .add_option("--target", options.targets,
                  "Of spirv, vulkan1.0, vulkan1.1, vulkan1.2, essl300, essl310, glsl410, glsl450, msl20, "
                  "msl22, msl23, "
                  "hlsl50, hlsl51; spirv (for Vulkan 1.1), essl310, glsl450, msl23 and hlsl50 without")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--api", options.api, "Compile for this API alone and make every target from that")
      ->check(CLI::IsMember({"vulkan", "d3d11", "metal", "glcore", "gles3", "switch"}));
  command.add_option("--explain", options.explain,
                     "Print one variant as the parser reads it, with the origin of every line, and compile "
                     "nothing: 'PASS/ENTRY: KEYWORD KEYWORD'");
  command.add_flag("--minimize", options.minimise, "Say which few keywords each error needs");
  command.add_flag("--no-lint", options.no_lint, "Compile alone; Documentation~/lint.md has the rules");
  command.add_option("--disable-rule", options.disabled_rules, "Lint rules to leave out")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_how(CLI::App& command, ValidateOptions& options) {
  add_report_options(command, options.report);
  command.add_option("--jobs", options.jobs, "Worker processes")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str();
  command.add_option("--shard", options.shard,
                     "K/N: the K-th of N parts; `penumbra merge` joins their JSON reports");
  command.add_option("--cache", options.cache, "Folder that keeps answers between runs");
  command.add_flag("--no-cache", options.no_cache, "Keep nothing, and use nothing that was kept");
  command.add_option("--keep", options.keep, "Folder for texts that crash or hang a compiler");
  command.add_option("--time-limit", options.time_limit, "Seconds of processor time for one variant")
      ->check(CLI::Range(1U, 3600U))
      ->capture_default_str();
  command.add_option("--memory-limit", options.memory_limit, "MiB for one worker")
      ->check(CLI::Range(64U, 65536U))
      ->capture_default_str();
  command.add_option("--emit-parameters", options.emit_parameters,
                     "Write the techniques' parameter structs as HLSL to this file (- for standard output), "
                     "and validate nothing");
  command.add_option(
      "--emit-presets", options.emit_presets,
      "Write the quality presets as C# to this file (- for standard output), and validate nothing");
  command.add_option("--emit-looks", options.emit_looks,
                     "Write the looks as C# to this file (- for standard output), and validate nothing");
  command.add_option(
      "--emit-programs", options.emit_programs,
      "Write which programs of the renderer feature's shader each quality preset keeps in a player, as "
      "JSON, to this file (- for standard output), and validate nothing");
}

}  // namespace

void add_validate_options(CLI::App& command, ValidateOptions& options) {
  add_what(command, options);
  add_with_what(command, options);
  add_which(command, options);
  add_how(command, options);
}

}  // namespace penumbra::cli
