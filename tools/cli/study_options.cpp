#include "cli/study_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "bake/field_objects.h"
#include "bake/horizon_angles.h"
#include "cli/known_names.h"
#include "cli/option_text.h"
#include "cli/option_values.h"
#include "cli/study_messages.h"
#include "fxc/fxc.h"
#include "hlsl/identifier.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "parameters/setting_keys.h"
#include "parameters/settings_input.h"
#include "platform/atomic_file.h"
#include "project/package_manifest.h"
#include "project/unity_project.h"
#include "reference/trace_visibility.h"
#include "resolve/module_order.h"
#include "resolve/shadow_shader.h"
#include "shaders/bytecode_module.h"

namespace penumbra::cli {
namespace {

constexpr const char* kForm = "--adapter 'NAME=FILE;KEYWORD;UNIFORM=1,2,3;TEXTURE=picture.png'";

// Returns all of a text as finite numbers between commas, or nothing when a part of it is no number.
std::optional<std::vector<double>> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : split(text, ',')) {
    double number = 0.0;
    const char* end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    if (part.empty() || error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
    numbers.push_back(number);
  }
  if (numbers.empty()) return std::nullopt;
  return numbers;
}

void add_value(resolve::Adapter& adapter, const std::string& name, const std::string& value,
               const scene::ReadingProcess& process) {
  const bool known_texture =
      std::any_of(adapter.textures.begin(), adapter.textures.end(),
                  [&](const resolve::AdapterTexture& texture) { return texture.name == name; });
  if (known_texture || adapter.uniforms.count(name) != 0) {
    throw InputError("--adapter " + adapter.name, "'" + name + "' is given twice");
  }
  if (std::optional<std::vector<double>> numbers = numbers_of(value)) {
    adapter.uniforms.emplace(name, *std::move(numbers));
  } else {
    adapter.textures.push_back(resolve::adapter_texture(name, value, process));
  }
}

double bounded(const std::string& name, const std::string& text, double most) {
  const double value = number("--adapter: " + name, text);
  if (value < 0.0 || value > most) {
    throw InputError("", fmt::format("--adapter: {} must be from 0 to {:g}, not {}", name, most, text));
  }
  return value;
}

// "@NAME=VALUE" sets how the adapter's function is run.
void set_adapter_setting(resolve::Adapter& adapter, const std::string& name, const std::string& value) {
  static const std::vector<std::string> kNames{"@depth-bias", "@normal-bias", "@soft-quality",
                                               "@light-scale"};
  if (name == "@depth-bias") {
    adapter.bias.depth = bounded(name, value, 10.0);
  } else if (name == "@normal-bias") {
    adapter.bias.normal = bounded(name, value, 10.0);
  } else if (name == "@soft-quality") {
    adapter.bias.soft_quality = parameters::soft_quality_named(value);
  } else if (name == "@light-scale") {
    adapter.light_scale = bounded(name, value, 10.0);
  } else {
    throw InputError("", "--adapter: unknown setting '" + name + "'", unknown_name_remedy(name, kNames));
  }
}

// The text is "NAME=FILE[;KEYWORD][;UNIFORM=a,b,...][;TEXTURE=picture.png][;@SETTING=value]": NAME=VALUE is a
// uniform if the value consists of numbers, else a texture. Settings are @depth-bias, @normal-bias,
// @soft-quality and @light-scale. Package roots and project are not included. Throws InputError for another
// form, for a picture that cannot be read (in that process), and for duplicates.
resolve::Adapter parse_adapter(const std::string& text, const scene::ReadingProcess& process) {
  const std::vector<std::string> parts = split(text, ';');
  if (parts.empty()) throw InputError("--adapter", "is empty", kForm);
  resolve::Adapter adapter;
  std::tie(adapter.name, adapter.file) = name_and_value("--adapter", parts[0]);
  require_plain_name("--adapter", adapter.name);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].find('=') == std::string::npos) {
      if (!hlsl::is_identifier(parts[i])) {
        throw InputError("--adapter " + adapter.name, "'" + parts[i] + "' is not a keyword's name", kForm);
      }
      adapter.keywords.push_back(parts[i]);
      continue;
    }
    const auto [name, value] = name_and_value("--adapter", parts[i]);
    if (name.starts_with("@"))
      set_adapter_setting(adapter, name, value);
    else
      add_value(adapter, name, value, process);
  }
  return adapter;
}

constexpr const char* kFxc = "fxc";

scene::DepthFormat depth_format(const std::string& text) {
  if (text == "d16") return scene::DepthFormat::d16;
  if (text == "d24") return scene::DepthFormat::d24;
  return scene::DepthFormat::d32;
}

// The numbers give position, target and perhaps the field of view; the rest of the camera stays.
void look_as_told(const std::vector<double>& numbers, parameters::Camera& camera) {
  const glm::dvec3 position{numbers[0], numbers[1], numbers[2]};
  const glm::dvec3 target{numbers[3], numbers[4], numbers[5]};
  const double fov = numbers.size() > 6 ? numbers[6] : camera.fov_y_degrees;
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw InputError("--camera", "contains a number that is not finite");
  }
  const glm::dvec3 view = target - position;
  if (glm::length(glm::cross(view, camera.up)) <= 1e-6 * glm::length(view)) {
    throw InputError("--camera", "looks straight up or down, or its target is its position",
                     "move the target sideways");
  }
  if (!(fov >= 1.0 && fov <= 170.0)) {
    throw InputError("--camera", "the field of view must be 1 to 170 degrees");
  }
  const parameters::Camera looking = scene::camera_looking(position, target);
  camera.position = looking.position;
  camera.forward = looking.forward;
  camera.fov_y_degrees = fov;
}

}  // namespace

namespace {

void add_scene_options(CLI::App& command, StudyOptions& options, const std::string& default_scene) {
  const std::string group = "Scene";
  const auto number = [&](const char* name, auto& value, const char* unit, const char* description) {
    return command.add_option(name, value, description)->type_name(unit)->group(group);
  };
  CLI::Option* scene =
      command
          .add_option("--scene", options.scenes,
                      "Built-in scenes, package:NAME, or model files; all: every one under the sun that most "
                      "techniques draw")
          ->default_str(default_scene)
          ->group(group);
  takes(command, one_each(scene), "SCENE");  // names_or_files splits them: a file name may contain a comma
  as_vector(
      number("--sun", options.sun, "DEGREES", "Sun's elevation and azimuth")->default_str("the scene's"), 2,
      2);
  as_vector(number("--origin", options.origin, "METRES", "Move the scene to this position in world space")
                ->default_str("0 0 0"),
            3, 3);
  as_vector(number("--camera", options.camera, "X,Y,Z,X,Y,Z[,DEGREES]",
                   "Camera position and target in metres, optionally followed by the vertical field of view")
                ->default_str("the scene's"),
            6, 7);
  number("--metres-per-unit", options.import.metres_per_unit, "METRES", "Scale of a model file")
      ->check(positive());
  number("--height", options.import.height_metres, "METRES", "Scale a model file to this height")
      ->default_str("set by --metres-per-unit")
      ->check(positive());
  command.add_flag("--z-up", options.import.z_up, "The model file's +Z is up")->group(group);
  command.add_flag("!--no-ground", options.import.ground, "Put no ground under a model file")->group(group);
}

void add_light_and_map_options(CLI::App& command, StudyOptions& options) {
  const auto add = [&](const char* name, auto& value, const char* unit, const char* description) {
    return command.add_option(name, value, description)->type_name(unit)->group("Light and map");
  };
  const auto bounds = [](const char* key) {
    const parameters::SettingKey& setting = parameters::setting_key(key);
    return within(setting.smallest, setting.largest);
  };
  as_list(add("--light", options.lights, "DEGREES", "Angular diameters of the sun"))
      ->check(bounds("/light/angular_diameter_degrees"));
  add("--map-size", options.map_size, "TEXELS", "Width of the cascade atlas")
      ->check(bounds("/shadows/resolution"));
  add("--map-format", options.map_format, "FORMAT", "Depth format of the map")
      ->check(one_of({"d16", "d24", "d32"}));
  add("--cascades", options.cascades, "N", "Number of cascades")->check(bounds("/shadows/cascades"));
  std::vector<std::string> fits;
  for (const parameters::LightFit fit : parameters::kLightFits) fits.emplace_back(parameters::name_of(fit));
  as_list(add("--light-fit", options.light_fits, "FIT",
              "What the cascades are fitted to; several are tried one by one"))
      ->check(one_of(fits));
  as_list(add("--cascade-blend", options.cascade_blends, "BLEND",
              "How cascades are blended in the border to the next; several are tried one by one"))
      ->check(one_of({"none", "dither", "mix"}));
  add("--cascade-border", options.cascade_border, "SHARE",
      "The border's width, a share of the split sphere's radius")
      ->check(within(0.001, 1.0));
  as_list(add("--map-age", options.map_ages, "DEGREES",
              "How far the sun has moved since the cascades were drawn; several are tried one by one"))
      ->check(within(0.0, scene::kOldestMapDegrees));
  add("--distance", options.distance_metres, "METRES", "Shadow distance")
      ->check(bounds("/shadows/distance_metres"))
      ->default_str("the scene's");
  add("--ground-samples", options.bake.ground_samples, "N",
      "Heights along the longer side of the ground, for techniques that read them")
      ->check(within(2, bake::most_samples_per_side));
  add("--horizon-texels", options.bake.horizon_texels, "N",
      "Horizon angles along that side, for techniques that read them")
      ->check(within(1, bake::most_horizon_texels_per_side));
  add("--field-voxels", options.bake.field_voxels, "N",
      "Voxels along the longest side of each object, for techniques that read distance fields")
      ->check(within(bake::least_voxels_of_objects, bake::most_voxels_per_side));
  constexpr const char* kOwn = "each technique's own";
  add("--depth-bias", options.depth_bias, "BIAS", "URP's depth bias setting, for all techniques")
      ->check(bounds("/shadows/depth_bias"))
      ->default_str(kOwn);
  add("--normal-bias", options.normal_bias, "BIAS", "URP's normal bias setting, for all techniques")
      ->check(bounds("/shadows/normal_bias"))
      ->default_str(kOwn);
  add("--soft-quality", options.soft_quality, "QUALITY",
      "URP's soft shadow quality, which scales both biases, for all techniques")
      ->check(one_of({"off", "low", "medium", "high"}))
      ->default_str(kOwn);
  add("--slope-bias", options.slope_bias, "BIAS",
      "Slope-scaled depth bias of the rasteriser when it draws the casters, for all techniques")
      ->check(within(0.0, 100.0))
      ->default_str(kOwn);
  add("--reversed-z", options.reversed_z, "BOOL", "Whether depth is reversed: 1 near the light")
      ->check(one_of({"true", "false"}))
      ->default_str("true");
}

}  // namespace

void add_study_options(CLI::App& command, StudyOptions& options, const std::string& default_scene) {
  add_scene_options(command, options, default_scene);
  add_light_and_map_options(command, options);
  const auto add = [&](const char* name, auto& value, const char* placeholder, const char* description) {
    return command.add_option(name, value, description)->type_name(placeholder)->group("Study");
  };
  add("--size", options.size, "WIDTHxHEIGHT", "Picture size, sides of 8 to 8192 pixels");
  add("--reference-samples", options.reference_samples, "N",
      "Rays per pixel of the reference, a power of two")
      ->check(within(reference::fewest_samples, reference::most_samples));
  add("--seed", options.seed, "N", "Seed of the reference's random numbers")
      ->check(within(0.0, 4294967295.0));
  add_jobs(command, options.jobs)->group("Study");
  add_worker_limits(command, options.worker, "one model, picture or shader");
  for (const char* limit : {"--time-limit", "--memory-limit"}) command.get_option(limit)->group("Study");
  add("--cache", options.cache, "FOLDER", "Folder in which references are cached between runs")
      ->default_str("the user's cache");
  add("--device", options.device, "DEVICE", "Vulkan device: part of its name, or its number")
      ->default_str("the software device");
  add("--front-end", options.front_end, "COMPILER",
      "What compiles the shaders: glslang, or fxc, Unity's own, whose bytecode is then run")
      ->check(one_of({"glslang", kFxc}));
  add_fxc(command, options.fxc)->group("Study");
  command.add_flag("--validation", options.validation, "Run with Vulkan's validation layers")->group("Study");
  add_package_roots(command, options.package_roots)->group("Study");
  add_project(command, options.project)->group("Study");
  add_cginc_root(command, options.cginc_root)->group("Study");
}

CLI::Option* add_adapters(CLI::App& command, std::vector<std::string>& adapters) {
  return one_each(
             command.add_option(
                 "--adapter", adapters,
                 "Your own ShadowVisibility function, with its keywords, uniforms, textures and settings"))
      ->type_name("NAME=FILE[;KEYWORD][;UNIFORM=1,2,...][;TEXTURE=picture.png][;@SETTING=VALUE]")
      ->default_str("none");
}

std::pair<int, int> picture_size(const StudyOptions& options) {
  int width = 0;
  int height = 0;
  char extra = 0;
  const int read = std::sscanf(options.size.c_str(), "%dx%d%c", &width, &height, &extra);
  if (read != 2 || width < 8 || height < 8 || width > 8192 || height > 8192) {
    throw InputError("", "--size '" + options.size + "' is not WIDTHxHEIGHT with sides of 8 to 8192 pixels");
  }
  return {width, height};
}

namespace {

// The options are refused and not ignored: a built-in scene has its own size.
void refuse_import_options_without_a_model(const scene::ImportOptions& import,
                                           const std::vector<std::string>& names) {
  const std::vector<std::string> built_in = scene::all_built_in_names();
  const auto is_model = [&](const std::string& name) {
    return std::find(built_in.begin(), built_in.end(), name) == built_in.end();
  };
  if (std::any_of(names.begin(), names.end(), is_model)) return;
  const scene::ImportOptions usual;
  const char* option = import.metres_per_unit != usual.metres_per_unit ? "--metres-per-unit"
                       : import.height_metres != usual.height_metres   ? "--height"
                       : import.z_up != usual.z_up                     ? "--z-up"
                       : import.ground != usual.ground                 ? "--no-ground"
                                                                       : nullptr;
  if (option != nullptr)
    throw InputError(option, "it is for model files, and every scene is a built-in one",
                     "remove it, or name a model file with --scene");
}

}  // namespace

std::vector<scene::Scene> chosen_scenes(const StudyOptions& options,
                                        const std::vector<std::string>& fallback) {
  std::vector<scene::Scene> scenes;
  std::set<std::string> seen;
  std::vector<std::string> names;
  const std::vector<std::string> given = options.scenes.empty() ? fallback : names_or_files(options.scenes);
  for (const std::string& name : given) {
    if (name != kAll) {
      names.push_back(name);
      continue;
    }
    const std::vector<std::string> all = scene::scene_names();
    names.insert(names.end(), all.begin(), all.end());
  }
  refuse_import_options_without_a_model(options.import, names);
  for (const std::string& name : names) {
    if (!seen.insert(name).second) continue;  // duplicates are removed
    require_plain_name("--scene", std::filesystem::path(name).filename().string());
    scene::ImportOptions import = options.import;
    import.process = reading_process(options.worker);
    scene::Scene scene = scene::load(name, import);
    if (!options.sun.empty()) scene.light_direction = scene::sunlight(options.sun[0], options.sun[1]);
    if (!options.camera.empty()) look_as_told(options.camera, scene.camera);
    if (!options.origin.empty()) {
      scene.origin = {options.origin[0], options.origin[1], options.origin[2]};
      scene.name +=
          fmt::format(" at {:g} {:g} {:g}", options.origin[0], options.origin[1], options.origin[2]);
    }
    if (options.distance_metres > 0.0) scene.shadow_distance_metres = options.distance_metres;
    scenes.push_back(std::move(scene));
  }
  return scenes;
}

void tell_notes(const std::vector<scene::Scene>& scenes, const Context& context) {
  if (context.quiet) return;
  for (const scene::Scene& scene : scenes) {
    for (const std::string& note : scene.notes) say("note: {}\n", note);
  }
}

resolve::Compiler chosen_compiler(const StudyOptions& options) {
  platform::WorkerPool process{worker_arguments(resolve::modules_mode), 1, worker_limits(options.worker)};
  if (options.front_end != kFxc) return process;
  if (!options.fxc.empty()) fxc::choose_fxc(options.fxc);
  if (!shaders::translates_bytecode())
    throw EnvironmentError(
        "--front-end fxc: this program was built without vkd3d-shader, which translates FXC's bytecode; "
        "build "
        "it where pkg-config finds libvkd3d-shader (libvkd3d-dev on Debian)");
  const fxc::JudgeLimits limits = fxc::limits_of(process.limits);
  return {std::move(process), resolve::bytecode_by_fxc(fxc::require_fxc(), limits)};
}

std::optional<std::string> front_end_name(const StudyOptions& options) {
  if (options.front_end != kFxc) return std::nullopt;
  return fxc::name_of(fxc::require_fxc());
}

scene::FrameSettings frame_settings(const StudyOptions& options) {
  scene::FrameSettings settings;
  std::tie(settings.width, settings.height) = picture_size(options);
  settings.format = depth_format(options.map_format);
  settings.shadows.resolution = options.map_size;
  settings.shadows.cascades = options.cascades;
  settings.shadows.reversed_z = options.reversed_z;
  return settings;
}

std::vector<parameters::LightFit> chosen_light_fits(const StudyOptions& options) {
  std::vector<parameters::LightFit> fits;
  for (const std::string& name : options.light_fits) {
    const parameters::LightFit fit = parameters::light_fit_named(name).value();  // the option checks it
    if (std::find(fits.begin(), fits.end(), fit) == fits.end()) fits.push_back(fit);
  }
  return fits;
}

std::vector<scene::CascadeBlend> chosen_cascade_blends(const StudyOptions& options) {
  std::vector<scene::CascadeBlend> blends;
  for (const std::string& name : options.cascade_blends) {
    const scene::CascadeBlend blend{name == "none" ? 0.0 : options.cascade_border, name == "mix"};
    if (std::find(blends.begin(), blends.end(), blend) == blends.end()) blends.push_back(blend);
  }
  return blends;
}

void choose_bias(const StudyOptions& options, study::Subject& subject) {
  subject.bias.depth = options.depth_bias.value_or(subject.bias.depth);
  subject.bias.normal = options.normal_bias.value_or(subject.bias.normal);
  if (options.soft_quality) subject.bias.soft_quality = parameters::soft_quality_named(*options.soft_quality);
  subject.raster_bias.slope = options.slope_bias.value_or(subject.raster_bias.slope);
}

void refuse_idle_bake_options(const CLI::App& command, const std::vector<study::Subject>& subjects) {
  using techniques::Need;
  const auto reads = [&](Need need) {
    return std::any_of(subjects.begin(), subjects.end(), [&](const study::Subject& subject) {
      const std::vector<Need>& needs = subject.graph.graph.needs;
      return std::find(needs.begin(), needs.end(), need) != needs.end();
    });
  };
  const bool angles = reads(Need::horizon_angles), heights = angles || reads(Need::ground_heights);
  refuse_idle(command, {"--ground-samples"}, !heights, "on techniques that read no heights of the ground");
  refuse_idle(command, {"--horizon-texels"}, !angles, "on techniques that read no horizon angles");
  refuse_idle(command, {"--field-voxels"}, !reads(Need::distance_fields),
              "on techniques that read no distance fields");
}

// Roots given by hand come first, then those of the project that were not given.
std::vector<shaders::PackageRoot> package_roots(const StudyOptions& options) {
  std::vector<shaders::PackageRoot> given;
  for (const std::string& text : options.package_roots) {
    given.push_back(parse_package_root(text));
    const std::filesystem::path& folder = given.back().directory;
    if (project::has_package_manifest(folder))
      given.back().version = project::read_package_manifest(folder).version;
  }
  if (options.project.empty()) return given;
  const project::UnityProject project = project::read_project(options.project, given);
  for (const hlsl::Diagnostic& problem : project.problems) {
    if (problem.severity == hlsl::Severity::error) throw InputError("--project", hlsl::format(problem));
  }
  return project.packages;
}

std::vector<resolve::Adapter> chosen_adapters(const StudyOptions& options) {
  const std::vector<shaders::PackageRoot> roots = package_roots(options);
  std::vector<resolve::Adapter> adapters;
  for (const std::string& text : options.adapters) {
    adapters.push_back(parse_adapter(text, reading_process(options.worker)));
    adapters.back().package_roots = roots;
    adapters.back().project = options.project;
    adapters.back().cginc_root = options.cginc_root;
  }
  return adapters;
}

gpu::Device open_device(const StudyOptions& options) {
  return gpu::Device({.name = options.device, .validation = options.validation});
}

study::StudyProgress study_progress(const Context& context) {
  struct Line {
    std::string stage;
    std::unique_ptr<Progress> progress;
  };
  auto line = std::make_shared<Line>();
  return [&context, line](std::string_view stage, double done, double total, std::string_view unit) {
    if (line->stage != stage) {
      line->progress.reset();
      line->stage = stage;
      line->progress = std::make_unique<Progress>(context.progress(), line->stage);
    }
    line->progress->update(done, total, unit);
  };
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be created: " + error.message());
}

bool is_jpeg_name(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".jpg" || extension == ".jpeg";
}

void write_picture(const std::filesystem::path& file, const study::Picture& picture) {
  const std::vector<std::byte> bytes =
      is_jpeg_name(file) ? study::encode_jpeg(picture) : study::encode_png(picture);
  platform::write_file_atomically(file, std::span<const std::byte>(bytes));
}

}  // namespace penumbra::cli
