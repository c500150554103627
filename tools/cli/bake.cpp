// penumbra bake: the inputs of far shadows, made of geometry once.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "bake/baked_files.h"
#include "bake/distance_field.h"
#include "bake/height_source.h"
#include "bake/horizon_angles.h"
#include "cli/help.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/study_messages.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "platform/cache_store.h"
#include "scene/image_file.h"
#include "scene/scene.h"

namespace penumbra::cli {

namespace {

struct BakeCommandOptions {
  std::string product;
  std::string scene;
  std::string image;
  std::string field;
  std::vector<double> area;     // corner, size
  std::vector<double> heights;  // an image's lowest and highest height
  std::string samples = "513x513";
  std::string raw_size;
  bool flip_z = false;
  scene::ImportOptions import;
  std::string texels = "512x512";
  bake::DistanceFieldOptions distances;
  int objects = 0;  // 0 bakes the scene as one object
  double nearest_metres = 0.0;
  std::string output;
  std::string cache;
  int jobs = 0;
  WorkerOptions worker{.time_limit = 60, .memory_limit = 2048};
};

// Parses "513x257", or "513" for a square.
scene::ImageSize size_of(const std::string& option, const std::string& text) {
  int width = 0, height = 0, read = 0;
  const auto all = static_cast<int>(text.size());
  if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &read) == 2 && read == all)
    return {width, height};
  if (std::sscanf(text.c_str(), "%d%n", &width, &read) == 1 && read == all) return {width, width};
  throw InputError("", option + " '" + text + "' is not WIDTHxDEPTH",
                   "write " + option + " 512x256, or " + option + " 512 for a square");
}

constexpr const char* kHeightField = "heightfield";
constexpr const char* kHorizon = "horizon";
constexpr const char* kDistanceField = "distance-field";
constexpr double kMuchThin = 0.1;  // share of an object's surface

// The pictures have the name without .json: any other ending could be that of a picture.
void check_output_name(const std::string& output) {
  if (output == "-") {
    throw InputError("--output", "a bake is several files, which standard output cannot hold",
                     "name a file that ends in .json");
  }
  const std::filesystem::path file = output;
  if (file.extension() != ".json") {
    throw InputError("--output",
                     "'" + output + "' does not end in .json, and could be taken for one of its pictures",
                     "name a file that ends in .json, such as terrain.json");
  }
  bake::check_stem(file.stem().string());
}

void refuse_idle_options(const CLI::App& command, const BakeCommandOptions& options) {
  const bool horizon = options.product == kHorizon, distances = options.product == kDistanceField;
  refuse_idle(command, {"--field", "--texels", "--nearest"}, !horizon, "on " + options.product);
  refuse_idle(command, {"--image", "--area", "--samples"}, distances, "on " + options.product);
  refuse_idle(command, {"--voxels", "--margin", "--objects"}, !distances, "on " + options.product);
  const int sources =
      (options.scene.empty() ? 0 : 1) + (options.image.empty() ? 0 : 1) + (options.field.empty() ? 0 : 1);
  if (sources != 1) {
    const char* all = distances ? "give --scene"
                      : horizon ? "give one of --scene, --image and --field"
                                : "give one of --scene and --image";
    throw InputError(
        "", sources == 0 ? "there is nothing to bake from" : "there are several things to bake from", all);
  }
  refuse_idle(command, {"--samples", "--metres-per-unit", "--z-up"}, options.scene.empty(),
              "without --scene");
  refuse_idle(command, {"--heights", "--raw-size", "--flip-z"}, options.image.empty(), "without --image");
  refuse_idle(command, {"--area"}, !options.field.empty(), "with --field, which has an area");
}

class Bake {
  template <typename Work>
  auto with_progress(const std::string& label, const std::string& unit, const Work& work) {
    Progress progress(context_.progress(), label);
    bake::BakeOptions options;
    options.jobs = options_.jobs;
    options.store = &store_;
    options.progress = [&](double done, double total) { progress.update(done, total, unit); };
    return work(options);
  }

 public:
  Bake(const CLI::App& command, const BakeCommandOptions& options, Context& context)
      : options_(options),
        context_(context),
        store_(options.cache.empty() ? platform::cache_directory() : std::filesystem::path(options.cache)) {
    refuse_idle_options(command, options);
    check_output_name(options.output);
    check_output_file(options.output);
    refuse_input_as_output("--output", options.output, {options.scene, options.image, options.field});
    check_cache_folder(options.cache, platform::cache_directory(), context);
  }

  void run() {
    if (options_.product == kHorizon) {
      horizon_angles();
    } else if (options_.product == kDistanceField) {
      distance_field();
    } else {
      write(bake::baked_files(field(), stem()));
    }
  }

 private:
  void horizon_angles() {
    const scene::ImageSize texels = size_of("--texels", options_.texels);
    const bake::HeightField ground = field();
    const double across = std::hypot(ground.area.size.x, ground.area.size.y);
    if (options_.nearest_metres >= across) {
      throw InputError("--nearest",
                       fmt::format("no ground counts from {} metres on: the area is {:.6g} metres across",
                                   options_.nearest_metres, across),
                       "give a smaller distance, or a larger area");
    }
    write(with_progress("horizon angles", " rows", [&](const bake::BakeOptions& run) {
      return bake::baked_files(
          bake::bake_horizon_angles(ground, {texels.width, texels.height, options_.nearest_metres}, run),
          stem());
    }));
  }

  void distance_field() {
    const scene::Scene scene = loaded_scene();
    if (options_.objects > 0) {
      object_fields(scene);
      return;
    }
    if (options_.distances.margin == 0.0 && !context_.quiet) {
      say("note: with --margin 0 the field ends at the mesh, and has no distances around it: soft shadows "
          "end there, too\n");
    }
    const bake::DistanceField field =
        with_progress("distances", " slices", [&](const bake::BakeOptions& run) {
          return bake::bake_distance_field(scene, options_.distances, run);
        });
    if (field.open_edges > 0 && !context_.quiet) {
      say("note: the mesh is not closed ({} edges do not have two triangles that turn the same way): "
          "inside is "
          "the back of the nearest triangle\n",
          field.open_edges);
    }
    write(bake::baked_files(field, stem()));
  }

  void object_fields(const scene::Scene& scene) {
    const bake::ObjectFields fields =
        with_progress("distances", " slices", [&](const bake::BakeOptions& run) {
          return bake::bake_object_fields(scene, {options_.objects, options_.distances}, run);
        });
    if (!context_.quiet) tell_about(fields);
    write(bake::baked_files(fields, stem()));
  }

  static void tell_about(const bake::ObjectFields& fields) {
    std::size_t open = 0, thin = 0, parts = 0;
    for (const bake::ObjectField& object : fields.objects) {
      open += object.field.open_edges > 0 ? 1 : 0;
      thin += object.thin_share > kMuchThin ? 1 : 0;
      parts += object.parts;
    }
    say("note: objects: {}, of {} parts; triangles of level ground, in no object: {}\n",
        fields.objects.size(), parts, fields.ground_triangles);
    if (fields.flat_triangles > 0) say("note: triangles without area, left out: {}\n", fields.flat_triangles);
    if (open > 0) {
      say("note: objects that are not closed (open_edges in the file): {}; inside is the back of the "
          "nearest triangle\n",
          open);
    }
    if (thin > 0) {
      say("note: objects too thin over a tenth of their surface or more (too_thin in the file): {}; "
          "shadows are lost where there are less than two voxels: bake more voxels or more objects\n",
          thin);
    }
  }

  bake::Area area(const std::function<bake::Area()>& usual) const {
    if (options_.area.empty()) return usual();
    return {{options_.area[0], options_.area[1]}, {options_.area[2], options_.area[3]}};
  }

  bake::HeightField field() {
    if (!options_.field.empty())
      return bake::read_height_field(options_.field, reading_process(options_.worker));
    return options_.image.empty() ? field_of_scene() : field_of_image();
  }

  scene::Scene loaded_scene() {
    scene::ImportOptions import = options_.import;
    import.ground = false;
    import.process = reading_process(options_.worker);
    scene::Scene scene = scene::load(options_.scene, import);
    tell_notes(scene.notes, context_);
    return scene;
  }

  bake::HeightField field_of_scene() {
    const scene::Scene scene = loaded_scene();
    const scene::ImageSize samples = size_of("--samples", options_.samples);
    const bake::Area covered = area([&] {
      const bake::Area all = bake::area_of(scene);
      if (all.size.x > 0.0 && all.size.y > 0.0) return all;
      throw InputError(
          options_.scene,
          fmt::format("has no ground: seen from above it is {} x {} metres", all.size.x, all.size.y),
          "a vertical wall has no heights; bake its distance-field");
    });
    const bake::HeightField field = with_progress("heights", " rows", [&](const bake::BakeOptions& run) {
      return bake::heights_of_scene(scene, covered, {samples.width, samples.height}, run);
    });
    if (field.holes > 0 && !context_.quiet) {
      say("note: samples without a surface: {} of {}; they have the height of the scene's lowest vertex, "
          "{:.6g} m\n",
          field.holes, field.metres.size(), scene.bounds().minimum.y);
    }
    return field;
  }

  bake::HeightField field_of_image() const {
    if (options_.heights.empty())
      throw InputError(
          options_.image, "is an image of heights without a unit",
          "say how many metres its 0 and its 65535 are: --heights 0,600 (Unity: 0 and the terrain's height)");
    const bake::Area covered = area([&]() -> bake::Area {
      throw InputError(options_.image, "does not say how large the ground is",
                       "say its corner and its size in metres: --area X,Z,WIDTH,DEPTH");
    });
    std::optional<scene::ImageSize> raw_size;
    if (!options_.raw_size.empty()) raw_size = size_of("--raw-size", options_.raw_size);
    const scene::HeightImage image =
        scene::read_height_image_apart(options_.image, raw_size, reading_process(options_.worker));
    return bake::heights_of_image(image, covered, {options_.heights[0], options_.heights[1]},
                                  options_.flip_z);
  }

  std::string stem() const { return std::filesystem::path(options_.output).stem().string(); }

  void write(const bake::BakedFiles& files) {
    for (const auto& [name, bytes] : files.pictures) {
      const std::filesystem::path picture = std::filesystem::path(options_.output).parent_path() / name;
      refuse_input_as_output("--output", picture.string(), {options_.scene, options_.image, options_.field});
    }
    bake::write_baked_files(files, options_.output);
    std::string written = options_.output + "\n";
    for (const auto& [name, bytes] : files.pictures)
      written += (std::filesystem::path(options_.output).parent_path() / name).string() + "\n";
    write_output("", written);
  }

  const BakeCommandOptions& options_;
  Context& context_;
  platform::CacheStore store_;
};

}  // namespace

void add_bake(CLI::App& app, Context& context) {
  CLI::App* command = app.add_subcommand(
      "bake", "Bake what shadows without a map read: heights, angles of the horizon, distances to a mesh");
  auto options = std::make_shared<BakeCommandOptions>();
  const auto add = [&](const char* name, auto& value, const char* placeholder, const char* description,
                       const char* group) {
    return command->add_option(name, value, description)->type_name(placeholder)->group(group);
  };
  command->add_option("product", options->product, "What to bake")
      ->type_name("PRODUCT")
      ->check(one_of({kHeightField, kHorizon, kDistanceField}))
      ->required();
  const char* const ground = "Ground";
  add("--scene", options->scene, "SCENE", "A built-in scene, package:NAME, or a model file", ground)
      ->default_str("none");
  add("--image", options->image, "FILE", "Heights: PNG of 16 bits, or RAW as Unity's terrains export it",
      ground)
      ->default_str("none");
  add("--field", options->field, "FILE", "A JSON file that penumbra bake heightfield wrote", ground)
      ->default_str("none");
  as_vector(add("--area", options->area, "METRES", "Smallest x and z, and size along x and z", ground), 4, 4)
      ->default_str("the scene's bounds");
  as_vector(add("--heights", options->heights, "METRES", "What an image's 0 and 65535 mean", ground), 2, 2)
      ->default_str("none");
  add("--samples", options->samples, "WIDTHxDEPTH", "Heights taken of a scene, 2 to 8193 per side", ground);
  add("--raw-size", options->raw_size, "WIDTHxDEPTH", "Samples of a RAW image", ground)
      ->default_str("a square");
  command
      ->add_flag("--flip-z", options->flip_z,
                 "A picture's top, or the last row of RAW, is at the smallest z, not the largest")
      ->group(ground);
  add("--metres-per-unit", options->import.metres_per_unit, "METRES", "Scale of a model file", ground)
      ->check(positive());
  command->add_flag("--z-up", options->import.z_up, "The model file's +Z is up")->group(ground);
  const char* const horizon = "Horizon";
  add("--texels", options->texels, "WIDTHxDEPTH", "Size of the pictures, 1 to 8192 per side", horizon);
  add("--nearest", options->nearest_metres, "METRES", "Ground nearer than this does not count", horizon)
      ->check(within(0.0, 1e6));
  const char* const distances = "Distance field";
  add("--voxels", options->distances.voxels, "N", "Voxels along the longest side, margins included",
      distances)
      ->check(within(bake::least_voxels_per_side, bake::most_voxels_per_side));
  add("--margin", options->distances.margin, "SHARE", "Room around the mesh, of its longest side", distances)
      ->check(within(0.0, 10.0));
  add("--objects", options->objects, "N",
      "Of the scene's parts N fields at the most, in one file, without level ground", distances)
      ->default_str("one field of everything")
      ->check(within(1, bake::most_field_objects));
  const char* const run = "Run";
  add_jobs(*command, options->jobs)->group(run);
  add_worker_limits(*command, options->worker, "one model or image");
  for (const char* limit : {"--time-limit", "--memory-limit"}) command->get_option(limit)->group(run);
  add("--cache", options->cache, "FOLDER", "Folder in which finished bakes are cached", run)
      ->default_str("the user's cache");
  command
      ->add_option("-o,--output", options->output, "JSON file to write; its pictures are written beside it")
      ->type_name("FILE")
      ->required();
  end_help(
      *command, "The same bake again is read from the cache; one that was interrupted begins anew.",
      {{"penumbra bake heightfield --image terrain.raw --heights 0,600 --area 0,0,1000,1000 -o terrain.json",
        "of Unity's terrain of 1000 x 600 x 1000 metres"},
       {"penumbra bake horizon --field terrain.json --texels 1024 --nearest 50 -o horizon.json",
        "for shadows beyond cascades of 50 metres"},
       {"penumbra bake horizon --scene street --samples 257 -o horizon.json", ""}});
  command->callback([command, options, &context] { Bake(*command, *options, context).run(); });
}

}  // namespace penumbra::cli
