// penumbra constants: the values of each cascade that a shader needs, from settings or from dumped matrices.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <memory>
#include <optional>

#include "cli/help.h"
#include "cli/option_values.h"
#include "cli/shared_options.h"
#include "cli/subcommand.h"
#include "input/input_error.h"
#include "input/located_json.h"
#include "parameters/emit_constants.h"
#include "parameters/matrices_input.h"
#include "parameters/setting_keys.h"
#include "parameters/settings_input.h"

namespace penumbra::cli {

namespace {

using parameters::CascadeSet;
using parameters::FitInput;

// Flags override the file, the file overrides the defaults; so every flag is optional here.
struct ConstantsOptions {
  std::string config;
  std::string matrices;
  std::string format = "table";
  std::string output;
  std::optional<std::vector<double>> position;
  std::optional<std::vector<double>> forward;
  std::optional<std::vector<double>> direction;
  std::optional<std::vector<double>> splits;
  std::optional<double> fov;
  std::optional<double> aspect;
  std::optional<double> near_plane;
  std::optional<double> far_plane;
  std::optional<double> angle;
  std::optional<double> distance;
  std::optional<int> cascades;
  std::optional<int> resolution;
  std::optional<double> depth_bias;
  std::optional<double> normal_bias;
  std::optional<double> depth_range;
  std::optional<std::string> soft_quality;
  std::optional<std::string> clip_depth;
  std::optional<bool> reversed_z;
};

template <typename Value>
void set_if(const std::optional<Value>& given, Value& value) {
  if (given) value = *given;
}

void set_if(const std::optional<std::vector<double>>& given, glm::dvec3& value) {
  if (given) value = {given->at(0), given->at(1), given->at(2)};
}

void apply_splits(const std::vector<double>& given, parameters::ShadowSettings& shadows) {
  const std::size_t needed = shadows.cascades > 1 ? static_cast<std::size_t>(shadows.cascades - 1) : 0;
  if (given.size() != needed && given.size() != shadows.splits.size()) {
    throw InputError("",
                     "--splits has " + std::to_string(given.size()) + " numbers, and --cascades is " +
                         std::to_string(shadows.cascades),
                     "give one number fewer than there are cascades, or three as in Unity's asset");
  }
  shadows.splits = {};
  std::copy(given.begin(), given.end(), shadows.splits.begin());
}

void apply_flags(const ConstantsOptions& options, FitInput& input) {
  set_if(options.position, input.camera.position);
  set_if(options.forward, input.camera.forward);
  set_if(options.fov, input.camera.fov_y_degrees);
  set_if(options.aspect, input.camera.aspect);
  set_if(options.near_plane, input.camera.near_plane);
  set_if(options.far_plane, input.camera.far_plane);
  set_if(options.direction, input.light.direction);
  set_if(options.angle, input.light.angular_diameter_degrees);
  set_if(options.distance, input.shadows.distance_metres);
  set_if(options.cascades, input.shadows.cascades);
  set_if(options.resolution, input.shadows.resolution);
  set_if(options.depth_bias, input.shadows.depth_bias);
  set_if(options.normal_bias, input.shadows.normal_bias);
  set_if(options.reversed_z, input.shadows.reversed_z);
  if (options.depth_range) input.shadows.depth_range_metres = options.depth_range;
  if (options.soft_quality)
    input.shadows.soft_quality = parameters::soft_quality_named(*options.soft_quality);
  if (options.clip_depth) input.shadows.clip_depth = parameters::clip_depth_named(*options.clip_depth);
  if (options.splits) apply_splits(*options.splits, input.shadows);
}

std::string print(const CascadeSet& set, const std::string& format) {
  if (format == "json") return parameters::constants_json(set);
  if (format == "hlsl") return parameters::constants_source(set, parameters::Language::hlsl);
  if (format == "csharp") return parameters::constants_source(set, parameters::Language::csharp);
  if (format == "cpp") return parameters::constants_source(set, parameters::Language::cpp);
  return parameters::constants_table(set);
}

std::string constants_from_settings(const ConstantsOptions& options) {
  FitInput input;
  if (!options.config.empty()) input = parameters::read_settings(LocatedJson::read(options.config));
  apply_flags(options, input);
  return print(parameters::fit_cascades(input.camera, input.light, input.shadows), options.format);
}

std::string constants_from_matrices(const ConstantsOptions& options) {
  return print(parameters::read_matrices(LocatedJson::read(options.matrices)).set, options.format);
}

// The bounds are exclusive.
CLI::Validator between(const parameters::SettingKey& setting) {
  const auto check = [&setting](std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || std::isnan(value)) return "'" + text + "' is not a number";
    return value > setting.smallest && value < setting.largest ? std::string()
                                                               : text + " is not " + setting.bounds();
  };
  return {check, setting.bounds()};
}

// Adds the option of one key of a --config file: its default, bounds and meaning are those of the key.
template <typename Value>
CLI::Option* add_setting(CLI::App& command, const char* key, std::optional<Value>& value) {
  const parameters::SettingKey& setting = parameters::setting_key(key);
  CLI::Option* option = command.add_option(setting.flag, value, setting.meaning)->default_str(setting.preset);
  std::string unit = setting.unit;
  std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::toupper(c); });
  option->type_name(unit.empty() ? "VALUE" : unit == "M" ? "METRES" : unit);
  if (setting.has_bounds())
    option->check(setting.between ? between(setting) : within(setting.smallest, setting.largest));
  return option;
}

// Options that describe a fit have no effect together with matrices, which are already fitted.
void add_fit_flags(CLI::App& command, ConstantsOptions& options, CLI::Option& matrices) {
  command
      .add_option("--config", options.config,
                  "JSON with camera, light and shadow settings; options override it")
      ->type_name("FILE")
      ->default_str("none")
      ->excludes(&matrices);
  const auto fit = [&](const char* key, auto& value) {
    return add_setting(command, key, value)->excludes(&matrices);
  };
  as_vector(fit("/camera/position", options.position), 3, 3);
  as_vector(fit("/camera/forward", options.forward), 3, 3);
  fit("/camera/fov_y_degrees", options.fov);
  fit("/camera/aspect", options.aspect);
  fit("/camera/near", options.near_plane);
  fit("/camera/far", options.far_plane);
  as_vector(fit("/light/direction", options.direction), 3, 3);
  fit("/light/angular_diameter_degrees", options.angle);
  fit("/shadows/distance_metres", options.distance);
  fit("/shadows/cascades", options.cascades);
  as_vector(fit("/shadows/splits", options.splits), 1, 3);
  fit("/shadows/resolution", options.resolution);
  fit("/shadows/depth_bias", options.depth_bias);
  fit("/shadows/normal_bias", options.normal_bias);
  fit("/shadows/depth_range_metres", options.depth_range);
  fit("/shadows/soft_quality", options.soft_quality)->check(one_of({"off", "low", "medium", "high"}));
  fit("/shadows/clip_depth", options.clip_depth)->check(one_of({"zero_to_one", "minus_one_to_one"}));
  fit("/shadows/reversed_z", options.reversed_z)->check(one_of({"true", "false"}));
}

}  // namespace

void add_constants(CLI::App& app, Context& /*context*/) {
  CLI::App* command = app.add_subcommand(
      "constants",
      "Print each shadow cascade's matrices, scales and biases, with their rounding error in ULP");
  auto options = std::make_shared<ConstantsOptions>();
  CLI::Option* matrices =
      command
          ->add_option("--matrices", options->matrices,
                       "JSON with matrices dumped from Unity, used instead of fitting cascades")
          ->type_name("FILE")
          ->default_str("none");
  add_fit_flags(*command, *options, *matrices);
  add_format(*command, options->format, {"table", "json", "hlsl", "csharp", "cpp"});
  add_output_file(*command, options->output);
  command->add_flag_callback(
      "--list-settings",
      [] {
        write_output("", parameters::setting_keys_table());
        throw CLI::Success();
      },
      "Print every key of a --config file, with type, unit, default and bounds, and exit");
  end_help(
      *command, "",
      {{"penumbra constants", "URP's default settings"},
       {"penumbra constants --cascades 4 --light 2 --format json", ""},
       {"penumbra constants --config settings.json --format hlsl -o Constants.hlsl", "as HLSL, for a shader"},
       {"penumbra constants --matrices shadows.json --format hlsl",
        "from matrices of a frame that Unity has drawn"}});
  command->callback([options, matrices] {
    check_output_file(options->output);
    refuse_input_as_output("--output", options->output, {options->config, options->matrices});
    write_output(options->output, matrices->count() > 0 ? constants_from_matrices(*options)
                                                        : constants_from_settings(*options));
  });
}

}  // namespace penumbra::cli
