// Time per variant: the engine of `penumbra validate` beside the shell pipeline that people have today.
//
// The pipeline makes, for each variant, seven processes under xargs: glslangValidator -E, glslangValidator,
// spirv-val, and spirv-cross for ESSL 310, GLSL 450, MSL 2.3 and HLSL 50; as many variants at once as the
// engine has workers. What it compiles is the text that the engine's own preparation has made, because
// glslang does not accept Unity's sources as they are; that costs it nothing here. Runs of the engine, each
// from its own empty cache unless said otherwise:
//   alone     the same seven steps; no variant shares anything with another
//   cold      the same steps; what variants do not reach is looked at once
//   shared    besides, equal texts and equal modules once
//   driver    besides, the emitted GLSL and ESSL compiled and linked by this machine's GL driver
//   lint      besides, the rules of `penumbra validate`: all that the command does with `--api vulkan`
//   default   the command without it: one source for each target's graphics API, that is, five for each
//             variant, where the pipeline still has one. URP's lighting alone; the techniques have one source
//   warm      that (of the techniques: lint) once more, everything kept
// Counters: X_ms milliseconds of time that passes, per variant; X_ratio shell_ms over it; X_cpu_ratio the
// same by processor time, which holds on a machine that does other work too; texts and modules: different
// ones among the variants. Runs alternate, so that a change of the machine's load meets all. Mesa's own cache
// is off.
//
// PENUMBRA_URP_PACKAGES names a folder with com.unity.render-pipelines.core, .universal and
// .universal-config: then keyword sets of URP's Lighting.hlsl are measured besides the library's techniques.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hlsl/source_text.h"
#include "platform/child_process.h"
#include "techniques/technique_list.h"
#include "validation/engine.h"
#include "validation/source_variants.h"
#include "variants/platform_defines.h"

namespace penumbra::validation {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr unsigned jobs = 2;
constexpr int shader_target = 45;

const char* const targets[] = {"spirv", "essl310", "glsl450", "msl23", "hlsl50"};

constexpr const char* lit_shader = R"(
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

float4 Main(float4 positionCS : SV_Position, float3 positionWS : TEXCOORD0, float3 normalWS : TEXCOORD1,
            float2 uv : TEXCOORD2) : SV_Target
{
    InputData place = (InputData)0;
    place.positionWS = positionWS;
    place.positionCS = positionCS;
    place.normalWS = normalize(normalWS);
    place.viewDirectionWS = GetWorldSpaceNormalizeViewDir(positionWS);
    place.shadowCoord = TransformWorldToShadowCoord(positionWS);
    place.bakedGI = SampleSH(place.normalWS);
    place.normalizedScreenSpaceUV = uv;
    place.shadowMask = half4(1, 1, 1, 1);
    SurfaceData surface = (SurfaceData)0;
    surface.albedo = half3(0.5, 0.5, 0.5);
    surface.smoothness = 0.5;
    surface.occlusion = 1.0;
    surface.alpha = 1.0;
    return UniversalFragmentPBR(place, surface);
}
)";

// A folder that goes with the benchmark.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / "penumbra-validation-benchmark") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::vector<CompileUnit> technique_units() {
  ValidationRequest request;
  const fs::path root = PENUMBRA_SOURCE_DIR;
  request.techniques = techniques::read_technique_list(root);
  request.package_roots = {{"com.penumbra.shadows", root}};
  request.targets.assign(std::begin(targets), std::end(targets));
  std::vector<CompileUnit> units;
  for (const SourceVariant& variant : source_variants(request)) units.push_back(variant.unit);
  return units;
}

std::vector<CompileUnit> lighting_units(const fs::path& packages) {
  CompileUnit unit;
  unit.file = "Lit.hlsl";
  unit.targets.assign(std::begin(targets), std::end(targets));
  unit.compile.file = unit.file;
  unit.compile.text = lit_shader;
  unit.compile.stage = hlsl::Stage::fragment;
  unit.compile.prepare = true;
  for (const char* name : {"com.unity.render-pipelines.core", "com.unity.render-pipelines.universal",
                           "com.unity.render-pipelines.universal-config"})
    unit.compile.package_roots.push_back({name, packages / name});
  std::vector<CompileUnit> units{unit};
  for (const std::vector<const char*>& one_of :
       std::vector<std::vector<const char*>>{{"", "_MAIN_LIGHT_SHADOWS", "_MAIN_LIGHT_SHADOWS_CASCADE"},
                                             {"", "_ADDITIONAL_LIGHTS_VERTEX", "_ADDITIONAL_LIGHTS"},
                                             {"", "_ADDITIONAL_LIGHT_SHADOWS"},
                                             {"", "_SHADOWS_SOFT"},
                                             {"", "LIGHTMAP_ON"},
                                             {"", "_SCREEN_SPACE_OCCLUSION"},
                                             {"", "_REFLECTION_PROBE_BLENDING"}}) {
    std::vector<CompileUnit> more;
    for (const CompileUnit& before : units) {
      for (const std::string keyword : one_of) {
        more.push_back(before);
        if (keyword.empty()) continue;
        more.back().keywords.push_back(keyword);
        more.back().compile.defines.emplace_back(keyword, "1");
      }
    }
    units = std::move(more);
  }
  return units;
}

CompileUnit for_platform(CompileUnit unit, const variants::Platform& platform) {
  std::map<std::string, std::string> defines =
      variants::platform_defines(platform, unit.compile.stage, shader_target);
  unit.compile.defines.insert(unit.compile.defines.begin(), defines.begin(), defines.end());
  return unit;
}

std::vector<CompileUnit> for_vulkan(const std::vector<CompileUnit>& units) {
  std::vector<CompileUnit> all;
  for (const CompileUnit& unit : units) all.push_back(for_platform(unit, {}));
  return all;
}

// The units, one source for each graphics API, as the command has it without --api.
std::vector<CompileUnit> for_every_api(const std::vector<CompileUnit>& units) {
  using variants::GraphicsApi;
  const std::vector<std::pair<variants::Platform, std::string>> platforms = {
      {{GraphicsApi::vulkan}, "spirv"},
      {{GraphicsApi::gles3, true}, "essl310"},
      {{GraphicsApi::glcore}, "glsl450"},
      {{GraphicsApi::metal}, "msl23"},
      {{GraphicsApi::d3d11}, "hlsl50"}};
  std::vector<CompileUnit> all;
  for (const auto& [platform, target] : platforms)
    for (const CompileUnit& unit : units) {
      all.push_back(for_platform(unit, platform));
      all.back().targets = {target};
    }
  return all;
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

const char* short_stage(hlsl::Stage stage) {
  if (stage == hlsl::Stage::vertex) return "vert";
  return stage == hlsl::Stage::fragment ? "frag" : "comp";
}

// Writes each variant's folder: the source with its includes, the prepared text, and a script of the seven
// steps.
fs::path write_pipeline(const Scratch& scratch, const CompileUnit& unit, std::size_t number) {
  const fs::path folder = scratch / std::to_string(number);
  shaders::PreprocessedSource prepared = shaders::preprocess(unit.compile);
  const hlsl::SharedText& text = unit.compile.text;  // none where the unit is a file
  write(folder / "source.hlsl", text ? *text : hlsl::read_source(unit.compile.file).text);
  write(folder / "prepared.hlsl", prepared.text);
  std::string front = "glslangValidator -D -S " + std::string(short_stage(unit.compile.stage)) + " -e " +
                      unit.compile.entry + " ";
  std::string search = " -I" + folder.string();
  for (const shaders::PackageRoot& root : unit.compile.package_roots) {
    fs::create_directories(folder / "Packages");
    fs::create_directory_symlink(root.directory, folder / "Packages" / root.name);
  }
  if (unit.compile.file.has_parent_path()) search += " -I" + unit.compile.file.parent_path().string();
  for (const fs::path& directory : unit.compile.include_directories) search += " -I" + directory.string();
  for (const auto& [name, value] : unit.compile.defines)
    search.append(" -D").append(name).append("=").append(value);
  write(folder / "run.sh",
        "set -e\ncd '" + folder.string() + "'\n" + front + "-E" + search + " source.hlsl > expanded.hlsl\n" +
            front +
            "-V --target-env vulkan1.1 --auto-map-bindings --auto-map-locations prepared.hlsl -o m.spv >"
            " /dev/null\nspirv-val --target-env vulkan1.1 m.spv\n"
            "spirv-cross m.spv --es --version 310 --output m.essl\n"
            "spirv-cross m.spv --version 450 --no-420pack-extension --output m.glsl\n"
            "spirv-cross m.spv --msl --msl-version 20300 --output m.msl\n"
            "spirv-cross m.spv --hlsl --shader-model 50 --output m.hlsl\n");
  return folder / "run.sh";
}

// The processor time of this process and of all that it started and that have ended, workers included.
double processor_milliseconds() {
  double total = 0.0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(whose, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      total += 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
  }
  return total;
}

struct Spent {
  double passed = 0.0;     // milliseconds
  double processor = 0.0;  // milliseconds

  template <typename Work>
  void add(const Work& work) {
    const auto start = Clock::now();
    const double processor_start = processor_milliseconds();
    work();
    passed += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    processor += processor_milliseconds() - processor_start;
  }
};

void run_shell(const std::string& scripts) {
  platform::ChildCommand command{"xargs", {"-P", std::to_string(jobs), "-n", "1", "sh"}, scripts};
  command.timeout = std::chrono::minutes(30);
  const platform::ChildResult result = platform::run_child(command);
  if (!result.succeeded()) throw std::runtime_error("the pipeline fails: " + result.output + result.errors);
}

// One way to run the engine.
struct Way {
  const char* name;
  Sharing sharing;
  bool drivers;
  bool lint;
  bool every_api;
  bool kept;  // the cache of the way before is kept
};

constexpr Way ways[] = {{"alone", Sharing::nothing, false, false, false, false},
                        {"cold", Sharing::declarations, false, false, false, false},
                        {"shared", Sharing::everything, false, false, false, false},
                        {"driver", Sharing::everything, true, false, false, false},
                        {"lint", Sharing::everything, true, true, false, false},
                        {"default", Sharing::everything, true, true, true, false},
                        {"warm", Sharing::everything, true, true, true, true}};

// The units to validate, and the same with one source for each graphics API; empty where the command does not
// work so.
struct Measured {
  std::vector<CompileUnit> units;
  std::vector<CompileUnit> every_api;
};

EngineRun run_engine(std::vector<CompileUnit> units, const Way& way, const fs::path& cache) {
  for (CompileUnit& unit : units) unit.lint.wanted = way.lint;
  EngineOptions options;
  options.jobs = jobs;
  options.cache = cache;
  options.sharing = way.sharing;
  options.drivers = way.drivers;
  options.worker_arguments = {worker_mode};
  return run_units(units, options);
}

std::vector<CompileUnit> spread(std::vector<CompileUnit> units, std::size_t count) {
  if (count >= units.size()) return units;
  std::vector<CompileUnit> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(units[i * units.size() / count]);
  return some;
}

void measure(benchmark::State& state, const Measured& measured) {
  const std::vector<CompileUnit>& units = measured.units;
  const Scratch scratch;
  std::string scripts;
  for (std::size_t i = 0; i < units.size(); ++i)
    scripts += write_pipeline(scratch, units[i], i).string() + "\n";
  Spent shell;
  std::map<std::string, Spent> spent;
  std::pair<std::size_t, std::size_t> one_source;  // numbers of texts and modules
  EngineRun run;
  for ([[maybe_unused]] auto iteration : state) {
    shell.add([&] { run_shell(scripts); });
    for (const Way& way : ways) {
      if (way.every_api && !way.kept && measured.every_api.empty()) continue;
      const bool every_api = way.every_api && !measured.every_api.empty();
      if (!way.kept) fs::remove_all(scratch / "cache");
      spent[way.name].add(
          [&] { run = run_engine(every_api ? measured.every_api : units, way, scratch / "cache"); });
      if (!way.every_api) one_source = {run.unique_texts, run.unique_modules};
    }
  }
  for (const UnitResult& result : run.results)
    if (!result.cached) return state.SkipWithError("not everything was kept");
  const double variants = static_cast<double>(units.size()) * static_cast<double>(state.iterations());
  state.counters["variants"] = static_cast<double>(units.size());
  state.counters["shell_ms"] = shell.passed / variants;
  for (const auto& [name, of] : spent) {
    state.counters[name + "_ms"] = of.passed / variants;
    state.counters[name + "_ratio"] = shell.passed / of.passed;
    state.counters[name + "_cpu_ratio"] = shell.processor / of.processor;
  }
  state.counters["texts"] = static_cast<double>(one_source.first);
  state.counters["modules"] = static_cast<double>(one_source.second);
  if (measured.every_api.empty()) return;
  state.counters["every_api_texts"] = static_cast<double>(run.unique_texts);
  state.counters["every_api_modules"] = static_cast<double>(run.unique_modules);
}

std::size_t wanted(const benchmark::State& state) {
  return static_cast<std::size_t>(state.range(0));
}

void techniques(benchmark::State& state) {
  measure(state, {spread(technique_units(), wanted(state)), {}});
}
BENCHMARK(techniques)
    ->ArgName("variants")
    ->Arg(8)
    ->Arg(1000)
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->Iterations(1);

void urp_lighting(benchmark::State& state) {
  const std::vector<CompileUnit> units = spread(lighting_units(std::getenv("PENUMBRA_URP_PACKAGES")),
                                                wanted(state));  // NOLINT(concurrency-mt-unsafe)
  measure(state, {for_vulkan(units), for_every_api(units)});
}

}  // namespace
}  // namespace penumbra::validation

int main(int argc, char** argv) {
  using namespace penumbra::validation;  // NOLINT(google-build-using-namespace)
  if (argc > 1 && std::string_view(argv[1]) == worker_mode) return serve_units({argv + 2, argv + argc});
  ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);     // NOLINT(concurrency-mt-unsafe)
  if (std::getenv("PENUMBRA_URP_PACKAGES") != nullptr)  // NOLINT(concurrency-mt-unsafe)
    benchmark::RegisterBenchmark("urp_lighting", urp_lighting)
        ->ArgName("variants")
        ->Arg(72)
        ->Arg(288)
        ->Unit(benchmark::kSecond)
        ->UseRealTime()
        ->Iterations(1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
