// penumbra validate: compiles shader files, a Unity project, or the library's own techniques, in every
// variant for every target.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>

#include "cli/help.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "cli/validate_options.h"
#include "fxc/fxc.h"
#include "input/counted.h"
#include "input/input_error.h"
#include "input/mistake.h"
#include "input/nearest_name.h"
#include "input/visible_text.h"
#include "lint/rule.h"
#include "platform/data_directory.h"
#include "project/include_bounds.h"
#include "project/package_version.h"
#include "project/shader_files.h"
#include "project/unity_project.h"
#include "shaders/cross_compile.h"
#include "shaders/package_shader.h"
#include "techniques/technique_list.h"
#include "validation/emitted_file.h"
#include "validation/explain.h"
#include "validation/shader_sources.h"
#include "validation/spirv_target.h"
#include "validation/validate_techniques.h"
#include "validation/variant_counts.h"
#include "validation/variant_name.h"
#include "variants/narrowing.h"

namespace penumbra::cli {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> default_targets{"spirv", "essl310", "glsl450", "msl23", "hlsl50"};

std::vector<std::string> known_targets() {
  std::vector<std::string> known = validation::spirv_targets();
  known.emplace_back(validation::fxc_target);
  for (const shaders::Target target : shaders::all_targets) known.emplace_back(shaders::target_name(target));
  return known;
}

std::vector<std::string> chosen_targets(const std::vector<std::string>& given) {
  const std::vector<std::string> known = known_targets();
  for (const std::string& target : given)
    if (std::find(known.begin(), known.end(), target) == known.end())
      throw InputError("--target", "unknown target '" + target + "'", unknown_name_remedy(target, known));
  if (!given.empty()) return given;
  std::vector<std::string> targets = default_targets;
  if (fxc::find_fxc().found) targets.emplace_back(validation::fxc_target);
  return targets;
}

validation::Shard chosen_shard(const std::string& text) {
  validation::Shard shard;
  if (text.empty()) return shard;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, shard.index);
  const bool has_slash = first == std::errc() && slash != end && *slash == '/';
  const auto [last, second] =
      has_slash ? std::from_chars(slash + 1, end, shard.count) : std::from_chars_result{slash, first};
  if (!has_slash || second != std::errc() || last != end || shard.index < 1 || shard.index > shard.count)
    throw InputError("--shard", "'" + text + "' is not K/N", "for example 1/4, up to 4/4");
  return shard;
}

validation::EngineOptions engine_options(const ValidateOptions& options) {
  validation::EngineOptions engine;
  engine.jobs = worker_count(options.jobs);
  engine.shard = chosen_shard(options.shard);
  engine.worker_arguments = worker_arguments(validation::worker_mode);
  if (!options.no_cache)
    engine.cache = options.cache.empty() ? validation::default_cache() : fs::path(options.cache);
  engine.keep = options.keep;
  engine.limits = worker_limits(options.worker);
  if (!options.emit_sources.empty())
    engine.emitted = [folder = fs::path(options.emit_sources)](
                         const validation::CompileUnit& unit, const std::string& target,
                         std::string_view text) { validation::write_emitted(folder, unit, target, text); };
  return engine;
}

validation::LintOrder lint_order(const ValidateOptions& options) {
  std::vector<std::string> known;
  for (const lint::RuleInfo& rule : lint::rules()) known.push_back(rule.name);
  for (const std::string& rule : options.disabled_rules)
    if (lint::find_rule(rule) == nullptr)
      throw InputError("--disable-rule", "unknown rule '" + rule + "'", unknown_name_remedy(rule, known));
  return {!options.no_lint, 0, options.disabled_rules};
}

std::vector<project::PackageRoot> given_roots(const ValidateOptions& options) {
  std::vector<project::PackageRoot> roots;
  for (const std::string& root : options.package_roots) roots.push_back(parse_package_root(root));
  return roots;
}

// Returns the Unity project in which all of the places are; empty without one.
fs::path project_of(const std::vector<std::string>& places) {
  const fs::path first = places.empty() ? fs::path() : project::project_of(places.front());
  const bool same = std::all_of(places.begin(), places.end(), [&](const std::string& place) {
    return project::project_of(place) == first;
  });
  return same ? first : fs::path();
}

// Lines go to standard error, like progress.
void say(const Context& context, const std::string& line) {
  if (!context.quiet) std::fprintf(stderr, "%s\n", line.c_str());
}

struct Found {
  project::IncludeRoots roots;
  int unity_version = variants::Platform().unity_version;
  std::vector<hlsl::Diagnostic> said;  // messages about the project and its packages
};

Found look_around(const ValidateOptions& options) {
  Found found;
  found.roots.packages = given_roots(options);
  if (!options.project.empty()) {
    project::UnityProject project = project::read_project(options.project, found.roots.packages);
    found.roots.packages = std::move(project.packages);
    found.roots.project = project.directory;
    if (project.editor) found.unity_version = project::unity_version_number(*project.editor);
    found.said = std::move(project.problems);
  }
  for (hlsl::Diagnostic& problem : project::version_problems(found.roots.packages))
    found.said.push_back(std::move(problem));
  const bool has_library =
      std::any_of(found.roots.packages.begin(), found.roots.packages.end(),
                  [](const project::PackageRoot& root) { return root.name == "com.penumbra.shadows"; });
  if (!has_library) found.roots.packages.push_back({"com.penumbra.shadows", platform::data_directory()});
  for (const std::string& directory : options.include_directories) {
    if (!fs::is_directory(directory)) throw InputError("-I", "'" + directory + "' is not a folder");
    found.roots.directories.emplace_back(directory);
  }
  if (!options.cginc_root.empty() && !fs::is_directory(options.cginc_root))
    throw EnvironmentError("--cginc-root: '" + options.cginc_root +
                           "' is not a folder; it should be Editor/Data/CGIncludes of a Unity editor");
  found.roots.cginc = options.cginc_root;
  if (options.unity_version.empty()) return found;
  const std::optional<int> version = variants::unity_version_number(options.unity_version);
  if (!version)
    throw InputError("--unity-version", "'" + options.unity_version + "' is not a version",
                     "for example 2022.3.20f1");
  found.unity_version = *version;
  return found;
}

// Returns the folders of packages, and the editor's includes, that are not the user's own: no named file and
// no Assets folder is in one, and none is in those.
std::vector<std::string> package_folders(const project::IncludeRoots& roots, const ValidateOptions& options) {
  const auto normal = [](const fs::path& path) {
    const fs::path shortest = path.lexically_normal();
    return shortest.has_filename() ? shortest : shortest.parent_path();
  };
  std::vector<fs::path> own(options.places.begin(), options.places.end());
  if (!options.project.empty()) own.push_back(fs::path(options.project) / "Assets");
  std::vector<fs::path> folders;
  if (!roots.cginc.empty()) folders.push_back(roots.cginc);
  for (const project::PackageRoot& root : roots.packages) folders.push_back(root.directory);
  std::vector<std::string> packages;
  for (const fs::path& folder : folders) {
    const fs::path package = normal(fs::absolute(folder));
    const bool is_own = std::any_of(own.begin(), own.end(), [&](const fs::path& named) {
      const fs::path mine = normal(fs::absolute(named));
      return platform::is_below(package, mine) || platform::is_below(mine, package);
    });
    if (!is_own) packages.push_back(normal(folder).string());
  }
  return packages;
}

void explain(const ValidateOptions& options, const validation::ShaderSources& sources,
             const validation::EngineOptions& engine, Context& context) {
  for (const validation::VariantRecord& record : sources.records())
    for (const hlsl::Diagnostic& said : record.diagnostics)
      if (said.severity == hlsl::Severity::error) say(context, hlsl::format(said));
  const validation::CompileUnit unit =
      validation::find_variant(sources, validation::parse_variant_name(*options.explain));
  const validation::Explanation explanation = validation::explain(unit, engine);
  for (const hlsl::Diagnostic& said : explanation.diagnostics) say(context, hlsl::format(said));
  write_output(options.report.output, explanation.text);
  if (hlsl::has_errors(explanation.diagnostics)) context.exit_code = findings;
}

// Files that could not be read have no variants to count.
void tell_unread(const validation::ShaderSources& sources, Context& context) {
  for (const validation::VariantRecord& record : sources.records())
    for (const hlsl::Diagnostic& said : record.diagnostics) {
      if (said.severity != hlsl::Severity::error) continue;
      std::fprintf(stderr, "%s\n", visible_lines(hlsl::format(said)).c_str());
      context.exit_code = findings;
    }
}

void list(const ValidateOptions& options, const validation::ShaderSources& sources,
          const variants::Plan& plan, Context& context) {
  tell_unread(sources, context);
  validation::VariantCounts counts{plan, {}, options.what_if};
  if (!options.what_if.empty()) {
    const std::vector<variants::Clause> clauses = variants::parse_keyword_expression(options.what_if);
    std::vector<const variants::Pragmas*> declared;
    for (const validation::SourceProgram& program : sources.programs()) declared.push_back(&program.pragmas);
    for (const std::string& unknown : variants::unknown_keywords(clauses, declared))
      say(context, "--what-if: " + unknown);
    counts.what_if = sources.plan(clauses);
  }
  if (options.report.form == "json") return write_output(options.report.output, counts_json(sources, counts));
  write_output(options.report.output, counts.what_if
                                          ? variants::text_of(plan, *counts.what_if, options.what_if)
                                          : variants::text_of(plan));
}

// A keyword that no program declares is a typing error, and would narrow nothing. A program that could not be
// parsed may declare it.
void refuse_unknown_keywords(const ValidateOptions& options, const validation::ShaderSources& sources,
                             const Context& context) {
  std::vector<const variants::Pragmas*> declared;
  for (const validation::SourceProgram& program : sources.programs()) declared.push_back(&program.pragmas);
  for (const std::string& expression : options.keywords) {
    for (const std::string& unknown :
         variants::unknown_keywords(variants::parse_keyword_expression(expression), declared)) {
      if (sources.knows_keywords()) throw InputError("", unknown);
      say(context, "warning: " + unknown + "; not every program was understood");
    }
  }
}

void add_sources(const CLI::App& command, const ValidateOptions& options,
                 validation::ValidationRequest& request, Context& context) {
  Found found = look_around(options);
  project::ShaderSelection selection;
  selection.places.assign(options.places.begin(), options.places.end());
  selection.include = options.only;
  selection.exclude = options.skip;
  const project::ShaderFiles files = project::find_shader_files(options.project, selection);
  for (const hlsl::Diagnostic& problem : files.problems) found.said.push_back(problem);
  std::vector<std::string> shaders;
  for (const project::ShaderFile& file : files.files) shaders.push_back(file.path.string());
  refuse_input_as_output("--output", options.report.output, shaders);
  for (const std::string& warning : idle_option_warnings(command, files)) say(context, warning);

  validation::SourceOptions source;
  source.platforms = validation::platform_targets(
      request.targets, {variants::find_graphics_api(options.api), options.mobile, found.unity_version});
  source.narrowing = variants::read_narrowing(
      {options.stripping, {options.urp_assets.begin(), options.urp_assets.end()}, options.keywords});
  if (!options.used_by.empty()) {
    if (source.narrowing.materials)
      throw InputError("--used-by", "--stripping lists materials, too", "use one of the two");
    source.used = variants::read_used_variants(options.used_by);
  }
  if (!options.project.empty()) source.build_settings = variants::read_build_settings(options.project);
  for (validation::PlatformTargets& platform : source.platforms)
    variants::apply_settings(source.build_settings, platform.platform);
  source.roots = found.roots;
  source.defines = request.defines;
  source.lint = request.lint;
  source.sample = options.sample;
  source.entries = {{options.entry, *hlsl::find_stage(options.stage)}};
  for (const std::string& set : options.keyword_sets) source.keyword_sets.push_back(parse_keyword_set(set));
  validation::ShaderSources sources(std::move(source));
  for (const project::ShaderFile& file : files.files)
    with_place(file.path.string(), [&] { sources.add(file); });

  for (const hlsl::Diagnostic& problem : found.said)
    if (problem.severity != hlsl::Severity::note)
      std::fprintf(stderr, "%s\n", hlsl::format(problem).c_str());  // skipped files are named, --quiet or not
    else
      say(context, hlsl::format(problem));
  refuse_unknown_keywords(options, sources, context);
  if (options.explain) return explain(options, sources, request.engine, context);
  const variants::Plan plan = sources.plan();
  say(context,
      variants::results_text(plan.results) + " of " + counted(sources.program_count(), "program") + " in " +
          counted(files.files.size(), "file") + " for " + counted(request.targets.size(), "target") +
          (options.sample == 0
               ? std::string()
               : "; --sample takes at most " + counted(options.sample, "variant") + " of each entry point"));
  if (options.list) return list(options, sources, plan, context);
  const std::string refusal = options.sample == 0 ? sources.refusal(options.limit) : std::string();
  if (!refusal.empty()) {
    const std::size_t end = refusal.find('\n');
    throw InputError("--limit", refusal.substr(0, end),
                     refusal.substr(std::min(end, refusal.size() - 1) + 1));
  }
  request.units = sources.units();
  request.records = sources.records();
  request.programs = sources.to_lint();
  if (!options.packages) request.packages = package_folders(found.roots, options);
}

void check_list(const ValidateOptions& options, bool sources_given) {
  if (!sources_given) throw InputError("--count", "needs shader files or --project");
  if (options.report.form != "text" && options.report.form != "json")
    throw InputError("--format", "--count cannot be printed as '" + options.report.form + "'",
                     "use text or json");
}

void check_outputs(const ValidateOptions& options, const Context& context) {
  check_output_file(options.report.output);
  refuse_report_over_source("--output", options.report.output);
  refuse_input_as_output("--output", options.report.output, {options.techniques, options.report.baseline});
  if (!options.no_cache) check_cache_folder(options.cache, validation::default_cache(), context);
  check_output_folder(options.keep);
  check_output_folder(options.emit_sources);
}

void run_validate(const CLI::App& command, ValidateOptions options, Context& context) {
  const bool sources_given = !options.places.empty() || !options.project.empty();
  if (options.require_sources && !sources_given)
    throw InputError("--require-sources", "there is nothing to validate",
                     "name files, or a project with --project");
  check_outputs(options, context);
  refuse_idle_options(command, options);
  if (options.project.empty() && !options.no_project) options.project = project_of(options.places).string();
  if (command.get_option("--project")->count() == 0 && !options.project.empty())
    say(context, "note: this belongs to the Unity project " + visible(options.project) +
                     ", whose packages and settings hold; --no-project leaves it out");
  if (!options.fxc.empty()) fxc::choose_fxc(options.fxc);
  const std::optional<validation::ValidationReport> baseline = read_baseline(options.report);
  validation::ValidationRequest request;
  request.targets = chosen_targets(options.targets);
  request.engine = engine_options(options);
  request.lint = lint_order(options);
  request.minimise = options.minimise;
  for (const std::string& define : options.defines) request.defines.push_back(parse_define(define));
  if (!options.techniques.empty() || !sources_given) {
    const fs::path library = platform::data_directory();
    request.techniques = chosen_technique_list(options.techniques);
    request.package_roots = given_roots(options);
    request.package_roots.push_back({"com.penumbra.shadows", library});
    request.include_directories.assign(options.include_directories.begin(),
                                       options.include_directories.end());
  }
  if (options.explain && !sources_given) throw InputError("--explain", "needs a shader file");
  if (options.list) check_list(options, sources_given);
  if (sources_given) add_sources(command, options, request, context);
  if (options.list || options.explain) return;
  if (options.targets.empty() && !fxc::find_fxc().found)
    say(context, "note: FXC, Unity's compiler, checked nothing: " + fxc::find_fxc().missing);
  validation::ValidationReport report;
  {
    Progress progress(context.progress(), "validate");
    request.engine.progress = [&](std::size_t done, std::size_t total) {
      progress.update(static_cast<double>(done), static_cast<double>(total), "shaders");
    };
    report = validation::validate(request);
  }
  write_report(options.report, report, baseline, context);
}

}  // namespace

void add_validate(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand(
      "validate",
      "Compile every shader variant for every target, without Unity, and report each error at its line");
  auto options = std::make_shared<ValidateOptions>();
  add_validate_options(*command, *options);
  end_help(
      *command,
      "Each target is generated from the source as Unity compiles it for that graphics API; --api uses "
      "one API for\nall. The exit code is 1 if a variant fails. MSL and HLSL are emitted but not "
      "compiled, because their compilers\ndo not run here. ESSL and GLSL are compiled and linked by "
      "this machine's OpenGL driver through EGL, each\nstage alone; then the semantics of a program's stages "
      "are compared.",
      {{"penumbra validate --project MyGame", "every shader of a Unity project"},
       {"penumbra validate Water.shader --keywords '+_NORMALMAP -DEBUG_DISPLAY'",
        "only some variants of a file"},
       {"penumbra validate --project MyGame --count --what-if=-_FOAM",
        "how many variants the keyword _FOAM adds"},
       {"penumbra validate Water.shader --target spirv,msl23 --minimize",
        "the smallest set of keywords that causes each failure"},
       {"penumbra validate --project MyGame --shard 1/4 --format json -o shard-1.json",
        "on one of four machines"},
       {"penumbra validate Water.shader --target essl310,msl23 --emit-sources generated",
        "what is generated of it"}});
  command->callback([command, options, &context] { run_validate(*command, *options, context); });
}

}  // namespace penumbra::cli
