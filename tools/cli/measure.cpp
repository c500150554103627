// penumbra measure: speed against error of techniques and users' own functions, over scenes and lights.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/help.h"
#include "cli/option_text.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/study_messages.h"
#include "cli/study_options.h"
#include "cli/subcommand.h"
#include "cli/varied_subjects.h"
#include "input/input_error.h"
#include "input/visible_text.h"
#include "platform/atomic_file.h"
#include "platform/cache_store.h"
#include "platform/processor.h"
#include "platform/source_commit.h"
#include "reference/trace_visibility.h"
#include "study/chart.h"
#include "study/contact_sheet.h"
#include "study/earlier_rows.h"
#include "study/kept_records.h"
#include "study/report.h"
#include "study/study.h"
#include "study/summary.h"

namespace penumbra::cli {
namespace {

// The charts, pages and pictures that an earlier run drew in this folder show other results.
void remove_earlier_report(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> drawn{folder / "report.html"};
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().filename().string().starts_with("pareto-") && entry.path().extension() == ".svg")
      drawn.push_back(entry.path());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures", ignored))
    if (entry.path().extension() == ".png") drawn.push_back(entry.path());
  for (const std::filesystem::path& file : drawn)
    if (std::filesystem::is_regular_file(file, ignored)) std::filesystem::remove(file, ignored);
}

// Throws InputError if something other than an older file stands where a file of the report belongs.
void check_report_files(const std::filesystem::path& folder) {
  static const std::set<std::string> kEndings{".json", ".tsv", ".html", ".svg", ".png"};
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(folder, absent)) {
    std::error_code ignored;
    const bool is_ours =
        entry.path().filename() == "pictures" ? entry.is_directory(ignored) : entry.is_regular_file(ignored);
    if (is_ours || (entry.path().filename() != "pictures" && kEndings.count(entry.path().extension()) == 0))
      continue;
    throw InputError(entry.path().string(),
                     entry.path().filename() == "pictures"
                         ? "is in the place of a folder of the report"
                         : "is a folder, a pipe or a device in the place of a file of the report",
                     "remove it, or choose another folder with --output");
  }
  const std::filesystem::path pictures = folder / "pictures";
  if (std::filesystem::is_directory(pictures, absent))
    platform::check_folder_can_be_written(pictures, pictures);
}

// Writes the results before the charts and pages: if drawing fails, the results are there, and no other
// report is beside them.
void write_report(const std::filesystem::path& folder, const study::Results& results,
                  std::vector<study::PictureRow> pictures, study::FactsOfTechniques facts) {
  make_folder(folder);
  const std::string json = study::to_json(results);
  const std::string table = study::to_table(results);
  platform::write_files_atomically({{folder / "results.json", json}, {folder / "results.tsv", table}});
  remove_earlier_report(folder);
  study::ReportContent content;
  content.results = results;
  content.charts = study::report_charts(results);
  content.pictures = std::move(pictures);
  content.facts = std::move(facts);
  if (!content.pictures.empty()) make_folder(folder / "pictures");
  for (std::size_t i = 0; i < content.pictures.size(); ++i) {
    const study::PictureRow& row = content.pictures[i];
    write_picture(folder / "pictures" / (study::file_stem(row) + ".png"),
                  study::record_sheet(results.records[i], row));
  }
  const std::string page = study::render_report(content);
  std::vector<std::string> charts;
  for (const study::ReportChart& chart : content.charts) charts.push_back(study::render_svg(chart.chart));
  std::vector<platform::FileContent> drawn;
  for (std::size_t i = 0; i < charts.size(); ++i)
    drawn.push_back({folder / (content.charts[i].chart.name + ".svg"), charts[i]});
  drawn.push_back({folder / "report.html", page});
  platform::write_files_atomically(drawn);
}

// Prints the figures that come first in the report, and where it is.
void print_headlines(const std::filesystem::path& folder, const study::Results& results) {
  std::string text;
  for (const study::Headline& headline : study::headlines(results)) {
    text += fmt::format("{:>8}  {} ({})\n", headline.value, headline.name, visible(headline.detail));
  }
  text += fmt::format("report: {}\n",
                      std::filesystem::absolute(folder / "report.html").lexically_normal().string());
  write_output("", text);
}

struct MeasureOptions : StudyOptions {
  VariedSubjects varied{{}, {}, {}, false};
  std::optional<int> timing_repeats;  // absent: the number that the kind of device needs
  bool no_split = false;
  bool overlaps = false;
  bool flip = false;
  int pan_frames = 0;
  int frames = study::StudySettings{}.frames;
  double frame_step = study::StudySettings{}.frame_step;
  int penumbra_pixels = 0;
  int edge_samples = 0;
  std::string from;                       // earlier results, JSON or a table; if given, nothing is measured
  std::string earlier;                    // results from which rows are added to the measured ones
  std::vector<std::string> earlier_rows;  // techniques of those rows
};

// Returns NAME=FOLDER of a package root without the folder, which is the user's own.
std::string without_folder(const std::string& root) {
  return root.substr(0, root.find('=')) + "=DIR";
}

// Returns the value of an option without this machine's folders.
std::string shown(const std::string& option, const std::string& value) {
  if (option == "--package-root") return without_folder(value);
  return option == "--project" || option == "--cginc-root" ? "DIR" : value;
}

// Returns the command that gives these results again, without this machine's folders.
std::string reproducing_command(const std::vector<std::string>& arguments) {
  static const std::set<std::string> kPlaces{"-o", "--output", "--cache"};
  std::string command = "penumbra";
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& given = arguments[i];
    const std::string name = given.substr(0, given.find('='));  // "--output=FOLDER" is one argument
    if (kPlaces.count(name) != 0) {
      if (name == given) ++i;
      continue;
    }
    if (given == "-q" || given == "--quiet") continue;
    const bool apart = name == given || !given.starts_with("--");
    command += " " + shell_word(apart ? shown(i > 0 ? arguments[i - 1] : "", given)
                                      : name + "=" + shown(name, given.substr(name.size() + 1)));
  }
  return command;
}

// Without a choice, every technique for the sun is taken, unless parameters are set, which most
// techniques lack.
std::vector<study::Subject> chosen_subjects(const MeasureOptions& options) {
  StudyOptions choice = options;
  if (choice.techniques.empty() && choice.adapters.empty() && options.varied.set.empty())
    choice.techniques = {kAll};
  return varied_subjects(choice, options.varied);
}

// Two files with the same name would be two indistinguishable scenes.
void refuse_equal_names(const std::vector<scene::Scene>& scenes) {
  std::set<std::string> names;
  for (const scene::Scene& scene : scenes) {
    if (!names.insert(scene.name).second) {
      throw InputError("", "--scene: two scenes are named '" + scene.name + "'", "rename one of the files");
    }
  }
}

study::StudySettings study_settings(const MeasureOptions& options) {
  study::StudySettings settings;
  settings.scenes = chosen_scenes(options, scene::scene_names());
  refuse_equal_names(settings.scenes);
  settings.light_degrees = options.lights;
  drop_repetitions(settings.light_degrees);
  settings.frame = frame_settings(options);
  settings.compiler = chosen_compiler(options);
  settings.penumbra_pixels = options.penumbra_pixels;
  reference::check_samples(options.reference_samples);
  settings.reference_samples = options.reference_samples;
  settings.seed = options.seed;
  settings.noise_seeds = options.noise_seeds;
  settings.split_error = !options.no_split;
  settings.overlaps = options.overlaps;
  settings.flip = options.flip;
  settings.pan_frames = options.pan_frames;
  settings.frames = options.frames;
  settings.frame_step = options.frame_step;
  settings.edge_samples = options.edge_samples;
  if (options.edge_samples > 0 && settings.split_error)
    throw InputError("--edge-samples", "the error is split for one surface in each pixel",
                     "leave out the split: --no-split");
  settings.bake = options.bake;
  settings.jobs = options.jobs;
  settings.cache = options.cache;
  return settings;
}

// Returns every package that a subject could include, once.
std::vector<study::PackageNote> packages_of(const std::vector<study::Subject>& subjects) {
  std::vector<study::PackageNote> packages;
  for (const study::Subject& subject : subjects) {
    if (!subject.graph.filter) continue;
    for (const shaders::PackageRoot& root : subject.graph.filter->package_roots) {
      study::PackageNote note{root.name, std::nullopt};
      if (!root.version.empty()) note.version = root.version;
      if (std::find(packages.begin(), packages.end(), note) == packages.end()) packages.push_back(note);
    }
  }
  return packages;
}

bool writes_report(const MeasureOptions& options) {
  return !options.output.empty() && options.output != "-";
}

struct Measured {
  study::Results results;
  std::vector<study::PictureRow> pictures;
  std::shared_ptr<study::KeptRecords> kept;  // absent if nothing was measured
};

Measured measure(const CLI::App& command, const MeasureOptions& options, Context& context) {
  study::StudySettings settings = study_settings(options);
  tell_notes(settings.scenes, context);
  settings.pictures = writes_report(options);
  const std::vector<study::Subject> subjects = chosen_subjects(options);
  refuse_idle_bake_options(command, subjects);
  refuse_idle(command, {"--fxc"}, options.front_end == "glslang", "without --front-end fxc");
  gpu::Device device = open_device(options);
  // A software device's times rank nothing, and take as long as everything else together.
  settings.timing_repeats = options.timing_repeats.value_or(device.info().is_software ? 1 : 5);
  study::StudyOutcome outcome = study::run_study(device, subjects, settings, study_progress(context));

  tell_notes(outcome.notes, context);
  for (const std::string& message : device.validation_log()->messages()) {
    say("validation: {}\n", message);
    context.exit_code = findings;
  }
  Measured measured;
  measured.results.library_version = PENUMBRA_VERSION;
  measured.results.commit = platform::source_commit();
  measured.results.packages = packages_of(subjects);
  measured.results.command = reproducing_command(context.arguments);
  measured.results.hardware = platform::processor_name();
  measured.results.device = device.info().name;
  measured.results.driver = device.info().driver;
  measured.results.is_software = device.info().is_software;
  measured.results.front_end = front_end_name(options);
  measured.results.frames = std::move(outcome.frames);
  measured.results.records = std::move(outcome.records);
  measured.pictures = std::move(outcome.pictures);
  measured.kept = std::move(outcome.kept);
  return measured;
}

// Reads the facts that the manifests state about techniques, where something shows them.
study::FactsOfTechniques shown_facts(const MeasureOptions& options) {
  if (!writes_report(options)) return {};
  return study::facts_of(chosen_technique_list(options.technique_list));
}

// They are read before the measuring, so that a mistake in the file loses no results.
study::Results earlier_results(const MeasureOptions& options) {
  if (options.earlier.empty()) return {};
  study::Results earlier = study::read_results(options.earlier);
  study::check_earlier_rows(earlier, options.earlier_rows, front_end_name(options), options.earlier);
  return earlier;
}

void check_outputs(const MeasureOptions& options, const Context& context) {
  if (options.output != "-") check_output_folder(options.output);
  if (writes_report(options)) check_report_files(options.output);
  check_cache_folder(options.cache, platform::cache_directory(), context);
}

void write_all(const MeasureOptions& options, Measured measured, const study::FactsOfTechniques& facts) {
  if (writes_report(options)) {
    write_report(options.output, measured.results, std::move(measured.pictures), facts);
    print_headlines(options.output, measured.results);
  } else {
    write_output("", study::to_json(measured.results));
  }
  // Finished records are dropped last, so that a run that could not write its results can continue from them.
  if (measured.kept) measured.kept->drop();
}

void run(const CLI::App& command, const MeasureOptions& options, Context& context) {
  check_outputs(options, context);
  // Facts are read before the measuring, so that a mistake in a manifest loses no results.
  const study::FactsOfTechniques facts = shown_facts(options);
  const study::Results earlier = earlier_results(options);
  Measured measured;
  if (options.from.empty()) {
    measured = measure(command, options, context);
    if (!options.earlier.empty())
      study::add_earlier_rows(measured.results, earlier, options.earlier_rows, options.earlier);
  } else {
    measured.results = study::read_results(options.from);
  }
  if (study::has_invalid_values(measured.results)) tell_invalid_results(measured.results.records, context);
  const std::shared_ptr<study::KeptRecords> kept = measured.kept;
  try {
    write_all(options, std::move(measured), facts);
  } catch (...) {
    if (kept && !context.quiet)
      say("note: {}\n", kept->complete()
                            ? "what was measured is kept; the same command goes on from there"
                            : "the cache could not keep all that was measured; choose another one with "
                              "--cache FOLDER");
    throw;
  }
}

}  // namespace

void add_measure(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand(
      "measure", "Measure the error of shadow techniques against ray tracing, and their cost");
  auto options = std::make_shared<MeasureOptions>();
  options->lights = {0.53, 2.0, 5.0};
  add_study_options(*command, *options, "all");
  add_technique_list_option(*command, options->technique_list)->group("What to measure");
  add_technique_option(*command, options->techniques, "all, without --adapter and --set")
      ->group("What to measure");
  add_adapters(*command, options->adapters)->group("What to measure");
  add_set_option(*command, "What to measure", options->varied);
  add_title_option(*command, "What to measure", options->varied);
  command->add_option("--seeds", options->noise_seeds, "Noise seeds per technique")
      ->type_name("N")
      ->check(within(1, 1024))
      ->group("Study");
  as_list(command->add_option(
              "--history", options->varied.histories,
              "Measure the exponential mean over frames with different noise, as of temporal "
              "antialiasing at rest, of which the newest has this share; several are tried one by "
              "one"))
      ->type_name("SHARE")
      ->default_str("1")
      ->check(within(0.01, 1))
      ->group("Study");
  command->add_option("--timing-repeats", options->timing_repeats, "Timed runs per technique")
      ->type_name("N")
      ->default_str("5, on a software device 1")
      ->check(within(0, 1000))
      ->group("Study");
  command
      ->add_flag("--no-split", options->no_split, "Do not split the error into map, algorithm and sampling")
      ->group("Study");
  command
      ->add_flag("--overlaps", options->overlaps,
                 "Measure the error where shadows of low and of high casters lie over each other, too")
      ->group("Study");
  command
      ->add_flag("--flip", options->flip,
                 "Measure how much the picture lit by each technique's shadows differs from the one lit by "
                 "ray-traced shadows, too, by FLIP")
      ->group("Study");
  command
      ->add_option("--pan-frames", options->pan_frames,
                   "Frames of a slow pan in which shimmer is measured, with static noise and with noise per "
                   "frame; fewer than 2: no shimmer")
      ->type_name("N")
      ->check(within(0, 64))
      ->group("Study");
  command
      ->add_option("--frames", options->frames,
                   "Frames that a technique with history draws, the last of which is measured")
      ->type_name("N")
      ->check(within(1, 64))
      ->group("Study");
  command
      ->add_option("--frame-step", options->frame_step,
                   "Pixels by which the picture moves to the left between these frames; 0: it rests")
      ->type_name("PIXELS")
      ->check(within(-100, 100))
      ->group("Study");
  command
      ->add_option("--penumbra-pixels", options->penumbra_pixels,
                   "Enlarge the picture of a scene and light until it has this many penumbra pixels, up to "
                   "3840x2160; 0: keep --size")
      ->type_name("N")
      ->check(within(0, 1'000'000))
      ->group("Study");
  command
      ->add_option(
          "--edge-samples", options->edge_samples,
          "Measure only pixels whose 2, 4 or 8 samples see several surfaces, against the mean of the "
          "samples; 0: every pixel at its centre")
      ->type_name("N")
      ->check(one_of({"0", "2", "4", "8"}))
      ->group("Study");
  const auto file = [&](const char* name, std::string& value, const char* description) {
    return command->add_option(name, value, description)->type_name("FILE")->default_str("none");
  };
  file("--from", options->from,
       "Read the figures from this results.json or results.tsv instead of measuring");
  CLI::Option* earlier =
      file("--earlier", options->earlier,
           "Results of the same pictures, of which --earlier-rows are added to those of this run");
  earlier->group("What to measure");
  CLI::Option* earlier_rows = as_list(command->add_option(
      "--earlier-rows", options->earlier_rows, "Techniques of --earlier, measured by adapters for example"));
  earlier_rows->type_name("NAME")->default_str("none")->needs(earlier)->group("What to measure");
  earlier->needs(earlier_rows);
  command
      ->add_option("-o,--output", options->output,
                   "Folder for results.json and results.tsv, report.html, charts and pictures")
      ->type_name("FOLDER")
      ->default_str("only the JSON, on standard output");
  end_help(
      *command, "",
      {{"penumbra measure --scene trees,street --technique tent-5,pcss-angular-24-16 --light 0.53,2 -o "
        "report",
        "two techniques, and a report with charts and pictures"},
       {"penumbra measure --scene model.glb --light 2 -o report", "your own model, every technique"},
       {"penumbra measure --adapter mine=MyShadow.hlsl -o report", "your own shadow function"},
       {"penumbra measure --scene trees --technique pcss-angular-24-16 --set blockerSamples=8,16,32", ""},
       {"penumbra measure --from report/results.json -o again", "the same report again, without measuring"}});
  command->callback([command, options, &context] {
    refuse_beside_from(*command, {"--technique-list", "--output"});
    run(*command, *options, context);
  });
}

}  // namespace penumbra::cli
