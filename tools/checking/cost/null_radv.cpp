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

// Why the worker sent no response.
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

// Empty if the output is not a response.
nlohmann::json answer_in(const platform::ChildResult& result) {
  if (!result.succeeded()) return {};
  nlohmann::json answer = nlohmann::json::parse(result.output, nullptr, false);
  return answer.is_object() ? answer : nlohmann::json();
}

void read_answer(const nlohmann::json& answer, Measurement& measurement) {
  for (const char* reason : {"no_device", "failure"})
    if (answer.contains(reason)) measurement.failure = answer.at(reason).get<std::string>();
  if (!answer.contains("measured")) return;
  const nlohmann::json& measured = answer.at("measured");
  measurement.subgroup_size = measured.at("subgroup_size").get<std::uint32_t>();
  for (const nlohmann::json& statistic : measured.at("statistics"))
    measurement.statistics.push_back(
        {statistic.at("name").get<std::string>(), statistic.at("value").get<std::uint64_t>()});
  measurement.figures = figures_of(measurement.statistics);
}

}  // namespace

RadvFamily open_family(const NullRadv& radv) {
  const platform::ChildResult result = platform::run_child(worker_command(radv));
  const nlohmann::json answer = answer_in(result);
  if (answer.contains("no_device"))
    throw EnvironmentError("RADV, Mesa's Vulkan driver for AMD, cannot be used: " +
                           first_line(answer["no_device"].get<std::string>()) + install_it);
  if (answer.contains("device"))
    return {radv.family, answer["device"].get<std::string>(), answer["driver"].get<std::string>()};
  if (answer.contains("failure")) throw EnvironmentError("RADV: " + answer["failure"].get<std::string>());
  // RADV ends the process when it does not know the family.
  if (result.errors.find("Unknown family") != std::string::npos)
    throw InputError("--family", "this machine's RADV does not know the family '" + radv.family + "'",
                     unknown_name_way_out(radv.family, known_family_names()));
  throw EnvironmentError("RADV does not start for family '" + radv.family + "': " + sudden_end(result, radv));
}

Measurement measure(const NullRadv& radv, const ModuleToMeasure& module) {
  Measurement measurement;
  platform::ChildCommand command = worker_command(radv);
  command.arguments.insert(command.arguments.end(), {hlsl::stage_name(module.stage), module.entry});
  command.input.assign(reinterpret_cast<const char*>(module.spirv.data()),
                       module.spirv.size() * sizeof(std::uint32_t));
  const platform::ChildResult result = platform::run_child(command);
  try {
    read_answer(answer_in(result), measurement);
  } catch (const nlohmann::json::exception& error) {
    measurement.failure = std::string("the worker's response cannot be parsed: ") + error.what();
  }
  if (measurement.failure.empty() && measurement.statistics.empty())
    measurement.failure = sudden_end(result, radv);
  return measurement;
}

}  // namespace penumbra::cost
