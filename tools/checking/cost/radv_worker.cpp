#include "cost/radv_worker.h"

#include <algorithm>
#include <cstring>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
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

std::vector<std::uint32_t> read_words(std::istream& input) {
  const std::string bytes{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
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

Json measure_here(const std::string& stage, const std::string& entry, std::istream& input) {
  // The only device of this driver under RADV_FORCE_FAMILY; all its devices have RADV in their names.
  const gpu::StatisticsDevice device("RADV");
  Json answer{{"device", device.info().name}, {"driver", device.info().driver}};
  if (stage.empty()) return answer;
  const std::optional<hlsl::Stage> known = hlsl::find_stage(stage);
  if (!known) throw std::invalid_argument("there is no stage '" + stage + "'");
  platform::confine_process(kMemory);
  try {
    const std::vector<std::uint32_t> words = read_words(input);
    // The behaviour of drivers is undefined for an invalid module.
    const std::vector<std::string> problems =
        shaders::validation_problems(words, shaders::VulkanVersion::v1_1, false);
    if (!problems.empty())
      throw std::invalid_argument("not valid SPIR-V for Vulkan 1.1: " + problems.front());
    answer["measured"] = answer_of(measured_executable(device, *known, {words, entry}));
  } catch (const std::exception& error) {
    answer["failure"] = error.what();
  }
  return answer;
}

}  // namespace

void run_radv_worker(unsigned seconds, const std::string& stage, const std::string& entry,
                     std::istream& input, std::ostream& output) {
  platform::close_descriptors_from(3);
  platform::limit_processor_time(seconds);
  Json answer;
  try {
    answer = measure_here(stage, entry, input);
  } catch (const EnvironmentError& error) {
    answer["no_device"] = error.what();
  } catch (const std::exception& error) {
    answer["failure"] = error.what();
  }
  output << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
  output.flush();
}

}  // namespace penumbra::cost
