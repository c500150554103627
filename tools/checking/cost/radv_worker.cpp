#include "cost/null_radv.h"

#include <algorithm>
#include <cstdint>
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "gpu/pipeline_statistics.h"
#include "hlsl/diagnostic.h"
#include "hlsl/stage.h"
#include "input/input_error.h"
#include "platform/confinement.h"
#include "shaders/compile.h"
#include "shaders/pipeline_interface.h"
#include "shaders/spirv_module.h"

namespace penumbra::cost {
namespace {

using shaders::ScalarType;
using shaders::StageLocation;

// Variables that share a location become one that covers them.
std::vector<StageLocation> whole_locations(const std::vector<StageLocation>& variables) {
  std::vector<StageLocation> locations;
  for (StageLocation variable : variables) {
    variable.components = std::min(4U, variable.component + variable.components);
    variable.component = 0;
    if (!locations.empty() && locations.back().location == variable.location) {
      locations.back().components = std::max(locations.back().components, variable.components);
    } else {
      locations.push_back(variable);
    }
  }
  return locations;
}

std::string type_of(const StageLocation& at) {
  const char* scalar = at.type == ScalarType::float32 ? "float"
                       : at.type == ScalarType::int32 ? "int"
                                                      : "uint";
  return at.components == 1 ? scalar : scalar + std::to_string(at.components);
}

std::string name_of(const StageLocation& at) {
  return "at" + std::to_string(at.location);
}

// Returns "[[vk::location(L)]] TYPE NAME : SEMANTIC": HLSL requires a semantic although only the location
// matters.
std::string declaration(const StageLocation& at, std::size_t location, const std::string& semantic) {
  const char* flat = at.type == ScalarType::float32 ? "" : "nointerpolation ";
  return "[[vk::location(" + std::to_string(location) + ")]] " + flat + type_of(at) + " " + name_of(at) +
         " : " + semantic + std::to_string(location);
}

// Generates the other stage of a graphics pipeline if only one is given: HLSL that writes or reads exactly
// the given stage's interface.
//
// Drivers link stages: an input that no vertex shader writes is undefined and the code that depends on it is
// removed, an output that no fragment shader reads is removed, too, and constants are propagated across
// stages. So the generated vertex shader passes a separate vertex attribute through every location, and the
// generated fragment shader reads every component of every location.

// Returns HLSL with the entry point Main. Throws std::invalid_argument when the words are no SPIR-V module or
// its interface is one that shaders::pipeline_interface() refuses.
std::string vertex_stage_for(const std::vector<std::uint32_t>& fragment, const std::string& entry) {
  const std::vector<StageLocation> passed =
      whole_locations(shaders::pipeline_interface(fragment, entry).inputs);
  std::string members = "    float4 position : SV_Position;\n";
  std::string parameters = "[[vk::location(0)]] float4 position : ATTRIBUTE0";
  std::string body = "    passed.position = position;\n";
  std::size_t attribute = 1;  // attributes are dense, whatever the locations that the fragment shader reads
  for (const StageLocation& at : passed) {
    members += "    " + declaration(at, at.location, "PASSED") + ";\n";
    parameters += ",\n            " + declaration(at, attribute++, "ATTRIBUTE");
    body += "    passed." + name_of(at) + " = " + name_of(at) + ";\n";
  }
  return "struct Passed\n{\n" + members + "};\n\nPassed Main(" + parameters + ")\n{\n    Passed passed;\n" +
         body + "    return passed;\n}\n";
}

std::string fragment_stage_for(const std::vector<std::uint32_t>& vertex, const std::string& entry) {
  const std::vector<StageLocation> passed =
      whole_locations(shaders::pipeline_interface(vertex, entry).outputs);
  std::string parameters = "float4 position : SV_Position";
  std::string body = "    float4 sum = 0;\n";
  for (const StageLocation& at : passed) {
    parameters += ",\n            " + declaration(at, at.location, "PASSED");
    const std::string swizzle = std::string("xyzw").substr(0, at.components);
    StageLocation as_float = at;
    as_float.type = ScalarType::float32;
    body += "    sum." + swizzle + " += (" + type_of(as_float) + ")" + name_of(at) + ";\n";
  }
  return "float4 Main(" + parameters + ") : SV_Target\n{\n" + body + "    return sum;\n}\n";
}

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
