#include "cost/null_radv.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cost/families.h"
#include "input/input_error.h"
#include "input/nearest_name.h"
#include "platform/child_process.h"

namespace penumbra::cost {
namespace {

constexpr const char* install_it =
    "\n  scripts/setup installs it (Debian: mesa-vulkan-drivers); no AMD hardware is needed. VK_DRIVER_FILES "
    "or "
    "VK_ICD_FILENAMES, when set, must name RADV's radeon_icd";

platform::ChildCommand worker_command(const NullRadv& radv) {
  platform::ChildCommand command;
  command.program = radv.worker.string();
  const auto seconds = std::chrono::ceil<std::chrono::seconds>(radv.time_limit).count();
  command.arguments = {"cost-worker", std::to_string(seconds)};
  command.timeout = radv.time_limit;
  command.output_limit = std::size_t{16} << 20;
  command.environment = {
      {"RADV_FORCE_FAMILY", radv.family},
      {"VK_LOADER_DRIVERS_SELECT", "*radeon*"},    // the loader need not open the others
      {"VK_LOADER_LAYERS_DISABLE", "~implicit~"},  // layers such as overlays and frame capture
      {"MESA_SHADER_CACHE_DISABLE", "true"},
      {"RADV_DEBUG", ""},
      {"RADV_PERFTEST", ""},
      {"ACO_DEBUG", ""},
      {"NIR_DEBUG", ""},
  };
  return command;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// Says why the worker sent no response.
std::string sudden_end(const platform::ChildResult& result, const NullRadv& radv) {
  const bool out_of_processor_time = result.exit_code == 128 + platform::signal_of_processor_time;
  if (result.timed_out || out_of_processor_time)
    return fmt::format("the driver's compiler did not finish within {:g} s",
                       std::chrono::duration<double>(radv.time_limit).count());
  std::string reason =
      result.overflowed ? "the driver's output exceeded its limit"
      : result.exit_code > 128
          ? "the driver's compiler was terminated by signal " + std::to_string(result.exit_code - 128)
          : "the worker ended with exit code " + std::to_string(result.exit_code) + " without a response";
  if (const std::string said = last_line(result.errors); !said.empty()) reason += ": " + said;
  return reason;
}

// The format is that of read_request() in radv_worker.cpp: a line of JSON, then the module's words.
void append_request(std::string& input, const ModuleToMeasure& module) {
  const nlohmann::json head{
      {"stage", hlsl::stage_name(module.stage)}, {"entry", module.entry}, {"words", module.spirv.size()}};
  input += head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  input.append(reinterpret_cast<const char*>(module.spirv.data()),
               module.spirv.size() * sizeof(std::uint32_t));
}

// Returns the lines of its output that are responses, up to the first that is none.
std::vector<nlohmann::json> answers_in(const std::string& output) {
  std::vector<nlohmann::json> answers;
  for (std::size_t at = 0, end = 0; (end = output.find('\n', at)) != std::string::npos; at = end + 1) {
    nlohmann::json answer = nlohmann::json::parse(output.substr(at, end - at), nullptr, false);
    if (!answer.is_object()) break;
    answers.push_back(std::move(answer));
  }
  return answers;
}

Measurement measurement_in(const nlohmann::json& answer) {
  Measurement measurement;
  if (answer.contains("failure")) {
    measurement.failure = answer.at("failure").get<std::string>();
    return measurement;
  }
  measurement.subgroup_size = answer.at("subgroup_size").get<std::uint32_t>();
  for (const nlohmann::json& statistic : answer.at("statistics"))
    measurement.statistics.push_back(
        {statistic.at("name").get<std::string>(), statistic.at("value").get<std::uint64_t>()});
  if (measurement.statistics.empty()) measurement.failure = "the driver has no statistics of the shader";
  measurement.figures = figures_of(measurement.statistics);
  return measurement;
}

Measurement failed(std::string reason) {
  Measurement measurement;
  measurement.failure = std::move(reason);
  return measurement;
}

Measurement read_measurement(const nlohmann::json& answer) {
  try {
    return measurement_in(answer);
  } catch (const nlohmann::json::exception& error) {
    return failed(std::string("the worker's response cannot be parsed: ") + error.what());
  }
}

// Returns the measurements of the first modules, at least of one. The worker may have failed at the last of
// them.
std::vector<Measurement> measured_by_one_worker(const NullRadv& radv,
                                                std::span<const ModuleToMeasure> modules) {
  platform::ChildCommand command = worker_command(radv);
  command.timeout = radv.time_limit * modules.size();
  for (const ModuleToMeasure& module : modules) append_request(command.input, module);
  const platform::ChildResult result = platform::run_child(command);
  const std::vector<nlohmann::json> answers = answers_in(result.output);
  if (!answers.empty())
    for (const char* reason : {"no_device", "failure"})
      if (answers[0].contains(reason))
        return std::vector(modules.size(), failed(answers[0].at(reason).get<std::string>()));
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < modules.size() && i + 1 < answers.size(); ++i)
    measurements.push_back(read_measurement(answers[i + 1]));
  if (measurements.size() < modules.size()) measurements.push_back(failed(sudden_end(result, radv)));
  return measurements;
}

}  // namespace

RadvFamily open_family(const NullRadv& radv) {
  const platform::ChildResult result = platform::run_child(worker_command(radv));
  const std::vector<nlohmann::json> answers = answers_in(result.output);
  const nlohmann::json answer = answers.empty() ? nlohmann::json::object() : answers[0];
  if (answer.contains("no_device"))
    throw EnvironmentError("RADV, Mesa's Vulkan driver for AMD, cannot be used: " +
                           first_line(answer["no_device"].get<std::string>()) + install_it);
  if (answer.contains("device"))
    return {radv.family, answer["device"].get<std::string>(), answer["driver"].get<std::string>()};
  if (answer.contains("failure")) throw EnvironmentError("RADV: " + answer["failure"].get<std::string>());
  // RADV ends the process when it does not know the family.
  if (result.errors.find("Unknown family") != std::string::npos) {
    std::vector<std::string> known = known_family_names();
    known.emplace_back(direct3d_family.name);
    throw InputError("--family", "this machine's RADV does not know the family '" + radv.family + "'",
                     unknown_name_remedy(radv.family, known));
  }
  throw EnvironmentError("RADV does not start for family '" + radv.family + "': " + sudden_end(result, radv));
}

std::vector<Measurement> measure(const NullRadv& radv, std::span<const ModuleToMeasure> modules) {
  std::vector<Measurement> measurements;
  while (measurements.size() < modules.size())
    for (Measurement& measurement : measured_by_one_worker(radv, modules.subspan(measurements.size())))
      measurements.push_back(std::move(measurement));
  return measurements;
}

}  // namespace penumbra::cost
