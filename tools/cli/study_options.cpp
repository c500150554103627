#include "cli/study_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <memory>

#include "cli/adapter_argument.h"
#include "cli/option_text.h"
#include "cli/shader_arguments.h"
#include "input/input_error.h"
#include "platform/atomic_file.h"
#include "project/package_manifest.h"
#include "project/unity_project.h"

namespace penumbra::cli {
namespace {

scene::DepthFormat depth_format(const std::string& text) {
  if (text == "d16") return scene::DepthFormat::d16;
  if (text == "d24") return scene::DepthFormat::d24;
  return scene::DepthFormat::d32;
}

parameters::SoftQuality soft_quality(const std::string& text) {
  if (text == "off") return parameters::SoftQuality::off;
  if (text == "low") return parameters::SoftQuality::low;
  return text == "high" ? parameters::SoftQuality::high : parameters::SoftQuality::medium;
}

// Position, target and perhaps the field of view; the rest of the camera stays.
void look_as_told(const std::vector<double>& numbers, parameters::Camera& camera) {
  const glm::dvec3 position{numbers[0], numbers[1], numbers[2]};
  const glm::dvec3 target{numbers[3], numbers[4], numbers[5]};
  const double fov = numbers.size() > 6 ? numbers[6] : camera.fov_y_degrees;
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw InputError("--camera", "holds a number that is not finite");
  }
  const glm::dvec3 view = target - position;
  if (glm::length(glm::cross(view, camera.up)) <= 1e-6 * glm::length(view)) {
    throw InputError("--camera", "looks straight up or down, or nowhere", "move the target a little aside");
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

void add_study_options(CLI::App& command, StudyOptions& options) {
  command.add_option("--scene", options.scenes, "Built-in scene, package:NAME or a model file; repeatable")
      ->group("Scene");
  command.add_option("--sun", options.sun, "Sun's elevation and azimuth in degrees, instead of the scene's")
      ->expected(2)
      ->group("Scene");
  command.add_option("--origin", options.origin, "Move the scene to this place in the world, metres")
      ->expected(3)
      ->group("Scene");
  command
      .add_option("--camera", options.camera,
                  "Position and target in metres, then perhaps the vertical field of view in degrees "
                  "(X Y Z X Y Z [60]), instead of the scene's")
      ->expected(6, 7)
      ->group("Scene");
  command.add_option("--metres-per-unit", options.import.metres_per_unit, "Scale of a model file")
      ->check(CLI::PositiveNumber)
      ->group("Scene");
  command.add_option("--height", options.import.height_metres, "Scale a model file to this height in metres")
      ->check(CLI::PositiveNumber)
      ->group("Scene");
  command.add_flag("--z-up", options.import.z_up, "The model file's +Z is up")->group("Scene");
  command.add_flag("!--no-ground", options.import.ground, "Put no ground under a model file")->group("Scene");

  command.add_option("--light", options.lights, "Angular diameter of the sun in degrees; repeatable")
      ->check(CLI::Range(0.0, 30.0))
      ->group("Light and map");
  command.add_option("--map-size", options.map_size, "Width of the cascade atlas in texels")
      ->check(CLI::Range(64, 16384))
      ->group("Light and map");
  command.add_option("--map-format", options.map_format, "d16, d24 or d32")
      ->check(CLI::IsMember({"d16", "d24", "d32"}))
      ->group("Light and map");
  command.add_option("--cascades", options.cascades, "1 to 4")
      ->check(CLI::Range(1, 4))
      ->group("Light and map");
  command
      .add_option("--distance", options.distance_metres, "Shadow distance in metres, instead of the scene's")
      ->check(CLI::PositiveNumber)
      ->group("Light and map");
  command.add_option("--depth-bias", options.depth_bias, "URP's depth bias setting")
      ->check(CLI::Range(0.0, 10.0))
      ->group("Light and map");
  command.add_option("--normal-bias", options.normal_bias, "URP's normal bias setting")
      ->check(CLI::Range(0.0, 10.0))
      ->group("Light and map");
  command
      .add_option("--soft-quality", options.soft_quality,
                  "URP's soft shadow quality, which scales both biases: off, low, medium or high")
      ->check(CLI::IsMember({"off", "low", "medium", "high"}))
      ->group("Light and map");
  command.add_option("--reversed-z", options.reversed_z, "Whether depth is 1 near the light")
      ->group("Light and map");

  command.add_option("--size", options.size, "Picture size, WIDTHxHEIGHT")->group("Study");
  command.add_option("--reference-samples", options.reference_samples, "Rays per pixel of the reference")
      ->check(CLI::Range(16, 1 << 20))
      ->group("Study");
  command.add_option("--seed", options.seed, "Seed of the reference's random numbers")->group("Study");
  command.add_option("--jobs", options.jobs, "Threads; 0: all cores")
      ->check(CLI::Range(0, 1024))
      ->group("Study");
  command.add_option("--cache", options.cache, "Folder that keeps references between runs")->group("Study");
  command.add_option("--device", options.device, "Vulkan device: part of its name, or its number")
      ->group("Study");
  command.add_flag("--validation", options.validation, "Run with Vulkan's validation layers")->group("Study");
  command.add_option("--package-root", options.package_roots, "NAME=FOLDER of a Unity package; repeatable")
      ->group("Study");
  command
      .add_option("--project", options.project,
                  "Unity project whose packages and Assets/ adapters include; --package-root wins")
      ->group("Study");
  command
      .add_option("--cginc-root", options.cginc_root,
                  "The Unity editor's CGIncludes, for adapters that need it")
      ->group("Study");
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

std::vector<scene::Scene> chosen_scenes(const StudyOptions& options,
                                        const std::vector<std::string>& fallback) {
  std::vector<scene::Scene> scenes;
  for (const std::string& name : options.scenes.empty() ? fallback : options.scenes) {
    scene::Scene scene = scene::load(name, options.import);
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
    for (const std::string& note : scene.notes) fmt::print(stderr, "note: {}\n", note);
  }
}

scene::FrameSettings frame_settings(const StudyOptions& options) {
  scene::FrameSettings settings;
  std::tie(settings.width, settings.height) = picture_size(options);
  settings.format = depth_format(options.map_format);
  settings.shadows.resolution = options.map_size;
  settings.shadows.cascades = options.cascades;
  settings.shadows.depth_bias = options.depth_bias;
  settings.shadows.normal_bias = options.normal_bias;
  settings.shadows.soft_quality = soft_quality(options.soft_quality);
  settings.shadows.reversed_z = options.reversed_z;
  return settings;
}

// Those given by hand, then those of the project that are not.
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
    adapters.push_back(parse_adapter(text));
    adapters.back().package_roots = roots;
    adapters.back().project = options.project;
    adapters.back().cginc_root = options.cginc_root;
  }
  return adapters;
}

gpu::Device open_device(const StudyOptions& options) {
  return gpu::Device({.name = options.device, .validation = options.validation, .timeout_seconds = 600.0});
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
      line->progress = std::make_unique<Progress>(context, line->stage);
    }
    line->progress->update(done, total, unit);
  };
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string(), "cannot be made: " + error.message());
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
