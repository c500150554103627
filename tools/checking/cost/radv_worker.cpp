#include "cost/radv_worker.h"

#include <algorithm>
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>

#include "cost/counterpart_stage.h"
#include "gpu/pipeline_statistics.h"
#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "input/input_error.h"
#include "platform/confinement.h"
#include "shaders/compile.h"
#include "shaders/spirv_module.h"

namespace penumbra::cost {
namespace {

using Json = nlohmann::ordered_json;

struct Request {
  std::string stage, entry;
  std::vector<std::uint32_t> words;
};

// Returns nothing at the end of the input.
std::optional<Request> read_request(std::istream& input) {
  std::string line;
  if (!std::getline(input, line)) return std::nullopt;
  const Json head = Json::parse(line);
  Request request{head.at("stage").get<std::string>(), head.at("entry").get<std::string>(),
                  std::vector<std::uint32_t>(head.at("words").get<std::size_t>())};
  const std::size_t bytes = request.words.size() * sizeof(std::uint32_t);
  if (!input.read(reinterpret_cast<char*>(request.words.data()), static_cast<std::streamsize>(bytes)))
    throw std::invalid_argument("the module ends early");
  return request;
}

gpu::ShaderEntry compile_counterpart(const std::string& text, hlsl::Stage stage) {
  shaders::CompileRequest request;
  request.file = std::string("the ") + hlsl::stage_name(stage) + " stage of the pipeline";
  request.text = text;
  request.stage = stage;
  const shaders::CompileResult result = shaders::compile(request);
  for (const hlsl::Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity == hlsl::Severity::error) throw std::logic_error(hlsl::format(diagnostic));
  return {result.spirv, request.entry};
}

gpu::PipelineExecutable measured_executable(const gpu::StatisticsDevice& device, hlsl::Stage stage,
                                            const gpu::ShaderEntry& shader) {
  std::vector<gpu::PipelineExecutable> executables;
  if (stage == hlsl::Stage::compute) {
    executables = device.compute(shader);
  } else if (stage == hlsl::Stage::fragment) {
    executables = device.graphics(
        compile_counterpart(vertex_stage_for(shader.spirv, shader.entry), hlsl::Stage::vertex), shader);
  } else if (stage == hlsl::Stage::vertex) {
    executables = device.graphics(
        shader, compile_counterpart(fragment_stage_for(shader.spirv, shader.entry), hlsl::Stage::fragment));
  } else {
    throw std::invalid_argument(std::string(hlsl::stage_name(stage)) +
                                " shaders are not measured; vertex, fragment and compute shaders are");
  }
  for (gpu::PipelineExecutable& executable : executables) {
    const bool is_it = stage == hlsl::Stage::compute    ? executable.compute
                       : stage == hlsl::Stage::fragment ? executable.fragment
                                                        : executable.vertex;
    if (is_it) return std::move(executable);
  }
  throw std::runtime_error(std::string("the driver's pipeline has no program for the ") +
                           hlsl::stage_name(stage) + " stage");
}

Json answer_of(const gpu::PipelineExecutable& executable) {
  Json statistics = Json::array();
  for (const gpu::PipelineStatistic& statistic : executable.statistics)
    statistics.push_back({{"name", statistic.name}, {"value", statistic.value}});
  return {{"subgroup_size", executable.subgroup_size}, {"statistics", statistics}};
}

constexpr std::size_t kMemory = std::size_t{2} << 30;  // bytes

Json measure_here(const gpu::StatisticsDevice& device, Request request) {
  try {
    const std::optional<hlsl::Stage> stage = hlsl::find_stage(request.stage);
    if (!stage) throw std::invalid_argument("there is no stage '" + request.stage + "'");
    // The behaviour of drivers is undefined for an invalid module.
    const std::vector<std::string> problems =
        shaders::validation_problems(request.words, shaders::VulkanVersion::v1_1, false);
    if (!problems.empty())
      throw std::invalid_argument("not valid SPIR-V for Vulkan 1.1: " + problems.front());
    return answer_of(measured_executable(device, *stage, {std::move(request.words), request.entry}));
  } catch (const std::exception& error) {
    return {{"failure", error.what()}};
  }
}

void write_line(std::ostream& output, const Json& answer) {
  output << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

}  // namespace

void run_radv_worker(unsigned seconds, std::istream& input, std::ostream& output) {
  platform::close_descriptors_from(3);
  platform::limit_processor_time(seconds);
  try {
    // The driver has only this device under RADV_FORCE_FAMILY; all its devices have RADV in their names.
    const gpu::StatisticsDevice device("RADV");
    platform::confine_process(kMemory);
    write_line(output, {{"device", device.info().name}, {"driver", device.info().driver}});
    while (std::optional<Request> request = read_request(input)) {
      platform::limit_processor_time(seconds);
      write_line(output, measure_here(device, *std::move(request)));
    }
  } catch (const EnvironmentError& error) {
    write_line(output, {{"no_device", error.what()}});
  } catch (const std::exception& error) {
    write_line(output, {{"failure", error.what()}});
  }
}

}  // namespace penumbra::cost
