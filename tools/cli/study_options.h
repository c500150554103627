// The options that `measure` and `render` share: scenes, lights, maps and the device.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "gpu/device.h"
#include "resolve/compiler.h"
#include "resolve/shadow_shader.h"
#include "scene/frame.h"
#include "scene/scene.h"
#include "study/picture.h"
#include "study/study.h"
#include "techniques/technique_list.h"

namespace penumbra::cli {

struct StudyOptions {
  std::vector<std::string> scenes;
  std::vector<double> lights;
  std::vector<std::string> techniques;
  std::string technique_list;              // a manifest or a package's folder; empty: the library's own
  std::vector<std::string> adapters;       // parse_adapter() reads these
  std::vector<std::string> package_roots;  // NAME=FOLDER
  std::string project;                     // a Unity project; empty: none
  std::string cginc_root;                  // the editor's CGIncludes; empty: none
  std::string size = "480x270";
  int map_size = 2048;
  int cascades = 4;
  std::string map_format = "d32";
  std::optional<double> depth_bias;  // if one of these four is absent, each subject has its own
  std::optional<double> normal_bias;
  std::optional<std::string> soft_quality;
  std::optional<double> slope_bias;
  bool reversed_z = true;
  std::vector<std::string> light_fits{"sphere"};    // parameters::name_of; several are tried one by one
  std::vector<std::string> cascade_blends{"none"};  // none, dither or mix; several are tried one by one
  double cascade_border = 0.1;
  std::vector<double> map_ages{0.0};  // degrees; several are tried one by one
  double distance_metres = 0.0;       // 0: the scene's own
  study::BakeSettings bake;
  std::vector<double> sun;     // elevation and azimuth in degrees; empty: the scene's own
  std::vector<double> origin;  // world position of the scene's own origin, metres; empty: 0 0 0
  std::vector<double> camera;  // position, target and perhaps the field of view; empty: the scene's own
  scene::ImportOptions import;
  std::string device;
  std::string front_end = "glslang";  // glslang or fxc
  std::string fxc;                    // FXC's library; empty: where it is found
  bool validation = false;
  int reference_samples = 1024;
  int noise_seeds = 2;
  std::uint64_t seed = 0;
  int jobs = 0;  // 0 means all cores
  WorkerOptions worker{.time_limit = 60};
  std::string cache;
  std::string output;
};

// `default_scene` is the default in help.
void add_study_options(CLI::App& command, StudyOptions& options, const std::string& default_scene);
CLI::Option* add_adapters(CLI::App& command, std::vector<std::string>& adapters);

// All of these throw InputError for values that are out of range or unknown, with the nearest right name.
std::vector<scene::Scene> chosen_scenes(const StudyOptions& options,
                                        const std::vector<std::string>& fallback);
// Prints the notes of imports, on stderr unless --quiet.
void tell_notes(const std::vector<scene::Scene>& scenes, const Context& context);
// Throws EnvironmentError where the front end is not installed.
resolve::Compiler chosen_compiler(const StudyOptions& options);
// Returns the name that results record; absent for glslang.
std::optional<std::string> front_end_name(const StudyOptions& options);
scene::FrameSettings frame_settings(const StudyOptions& options);
std::vector<resolve::Adapter> chosen_adapters(const StudyOptions& options);

// The result has no repetitions.
std::vector<parameters::LightFit> chosen_light_fits(const StudyOptions& options);
std::vector<scene::CascadeBlend> chosen_cascade_blends(const StudyOptions& options);
// Sets the requested biases instead of the subject's own.
void choose_bias(const StudyOptions& options, study::Subject& subject);
// Throws InputError for an option of bakes that no subject reads, before anything is compiled or baked.
void refuse_idle_bake_options(const CLI::App& command, const std::vector<study::Subject>& subjects);

gpu::Device open_device(const StudyOptions& options);

// Prints a progress line per stage of a study.
study::StudyProgress study_progress(const Context& context);

std::pair<int, int> picture_size(const StudyOptions& options);  // width and height

void make_folder(const std::filesystem::path& folder);  // makes its parents, too; InputError when that fails

bool is_jpeg_name(const std::filesystem::path& file);  // .jpg or .jpeg, in any case
// Writes a JPEG if the file's name says so, else a PNG.
void write_picture(const std::filesystem::path& file, const study::Picture& picture);

}  // namespace penumbra::cli
