// Writes seeds that only the program's own writers can make: fuzz_seeds FOLDER.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "platform/worker_frame.h"
#include "scene/scene_message.h"
#include "validation/report_fixture.h"
#include "validation/source_record.h"
#include "validation/unit_message.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using scene::encode;
using validation::encode;

const std::string hash = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

class Seeds {
 public:
  Seeds(const fs::path& folder, const std::string& target) : folder_(folder / target) {
    fs::create_directories(folder_);
  }
  void add(const std::string& content) {
    std::ofstream(folder_ / ("made-" + std::to_string(count_++))) << content;
  }

 private:
  fs::path folder_;
  int count_ = 0;
};

validation::CompileUnit unit() {
  validation::CompileUnit unit;
  unit.file = "Assets/Water.shader";
  unit.shader = "Custom/Water";
  unit.pass = "ForwardLit";
  unit.keywords = {"_FOAM"};
  unit.compile.defines = {{"_FOAM", "1"}};
  unit.targets = {"spirv", "essl310"};
  unit.lint = {true, 45, {"dead-store"}};
  return unit;
}

validation::UnitReply reply() {
  validation::UnitReply reply;
  reply.text_key = hash;
  reply.compile.emplace();
  reply.compile->diagnostics = {validation::error_at("Assets/Water.shader", 3, 5, "unknown identifier 'x'")};
  reply.compile->module_key = hash;
  reply.compile->quoted = {{"Assets/Water.shader", hash}};
  reply.emitted = validation::EmittedAnswer{{validation::error_at("a", 1, 1, "b")}, {}};
  reply.dependencies = {"Assets/Water.shader", "Packages/a/b.hlsl"};
  reply.to_keep = {{validation::EntryKind::compile, hash, "content"}};
  return reply;
}

validation::ValidationReport report() {
  using namespace validation;
  ValidationReport report;
  report.records = {water({}), failed(water({"_FOAM"}), error_at("Assets/Water.shader", 3, 5, "unknown 'x'")),
                    water({"_FOAM"}, "msl23")};
  report.records[2].status = VariantStatus::absent;
  report.records[2].reason = "no hull stage";
  report.records[0].module = hash;
  for (std::size_t i = 0; i < report.records.size(); ++i) report.records[i].place = i;
  report.unique = 1;
  report.checks = {{"spirv", "SPIRV-Tools"}};
  report.rules = {{"dead-store", "a value that nobody reads"}};
  report.minimal = {{error_at("Assets/Water.shader", 3, 5, "unknown 'x'"), {"_FOAM"}}};
  report.fingerprint = hash;
  return report;
}

scene::Scene triangle() {
  scene::Scene scene;
  scene.name = "triangle";
  scene.notes = {"no texture"};
  scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  scene.mesh.normals.assign(3, {0, 0, 1});
  scene.mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  scene.mesh.indices = {0, 1, 2};
  scene.mesh.triangle_materials = {0};
  scene.textures = {{1, 1, {1, 2, 3, 4}}};
  scene.materials[0].base_colour_texture = 0;
  return scene;
}

void write_worker_messages(const fs::path& folder) {
  Seeds seeds(folder, "worker_messages");
  const validation::SourceRecord record{hash, {{"Assets/a.hlsl", hash}}, {"Assets/b.hlsl"}};
  validation::UnitJob job;
  job.unit = unit();
  job.context.drivers = {{"essl310", "llvmpipe"}};
  job.given_up = {"essl310"};
  for (const std::string& message : {encode(job), encode(reply()), encode(unit()), encode(*reply().compile),
                                     encode(*reply().emitted), encode(record),
                                     platform::frame_bytes(platform::FrameKind::question, "t" + hash) +
                                         platform::frame_bytes(platform::FrameKind::answer, encode(reply()))})
    seeds.add("\x07" + message);
}

void write_reports(const fs::path& folder) {
  Seeds seeds(folder, "report");
  seeds.add(validation::report_json(report()));
  seeds.add(validation::report_json(validation::ValidationReport()));
  validation::ValidationReport shard = report();
  shard.shards = 2;
  seeds.add(validation::report_json(shard));
}

}  // namespace
}  // namespace penumbra

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "fuzz_seeds FOLDER\n";
    return 2;
  }
  penumbra::write_worker_messages(arguments[1]);
  penumbra::write_reports(arguments[1]);
}
