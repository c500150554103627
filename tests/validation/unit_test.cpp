// Units and results that go to workers and into the cache come back as they were, or not at all.
#include "validation/unit.h"

#include <gtest/gtest.h>

#include "validation/source_record.h"
#include "validation/unit_message.h"

namespace penumbra::validation {
namespace {

hlsl::Diagnostic diagnostic() {
  return {"a.hlsl", 12, 7, hlsl::Severity::warning, "said", "the line", "rule"};
}

UnitJob full_job() {
  UnitJob job;
  CompileUnit& unit = job.unit;
  unit.technique = "t";
  unit.file = "folder/f.shader";
  unit.shader = std::string("with \0 inside", 13);
  unit.pass = "p";
  unit.keywords = {"A", "", "B"};
  unit.compile.file = "f.hlsl";
  unit.compile.text = std::string(1000, 'x');
  unit.compile.written_for = "theirs.hlsl";
  unit.compile.entry = "e";
  unit.compile.stage = hlsl::Stage::hull;
  unit.compile.defines = {{"D", "1"}, {"E", ""}};
  unit.compile.package_roots = {{"name", "dir"}};
  unit.compile.include_directories = {"i", "j"};
  unit.compile.project = "project";
  unit.compile.cginc_root = "cginc";
  unit.compile.prepare = true;
  unit.compile.optimise = false;
  unit.compile.keep_unoptimised = true;
  unit.sub_shader = 2;
  unit.compile.vulkan = shaders::VulkanVersion::v1_2;
  unit.targets = {"spirv", "msl23"};
  unit.lint = {true, 45, {"typed-load"}};
  job.context = {"cache", "build", {{"essl310", "Mesa"}}};
  job.given_up = {"msl23"};
  job.text_only = true;
  job.wants_emitted = true;
  return job;
}

UnitReply full_reply() {
  UnitReply reply;
  reply.text_key = "0123";
  reply.compile = CompileAnswer{{diagnostic()},
                                {{"msl23", {diagnostic()}}},
                                "4567",
                                "UnityCG.cginc",
                                {{"a.hlsl", "89ab"}},
                                std::make_shared<const std::string>("layouts"),
                                std::make_shared<const std::string>("signature")};
  reply.emitted = EmittedAnswer{{}, {diagnostic(), diagnostic()}};
  reply.dependencies = {"a.hlsl", "b.hlsl"};
  reply.compile_cached = true;
  reply.text = "text";
  reply.emitted_texts = {{"msl23", "emitted"}};
  reply.damaged = 3;
  reply.to_keep = {{EntryKind::emitted, std::string(platform::content_hash_digits, 'a'), "content"}};
  return reply;
}

// A round trip gives equal bytes again, and no beginning of them is taken for the whole.
template <typename Decode>
void expect_round_trip(const std::string& bytes, const Decode& decode) {
  const auto decoded = decode(bytes);
  ASSERT_TRUE(decoded.has_value());
  EXPECT_EQ(encode(*decoded), bytes);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(decode(std::string_view(bytes).substr(0, length)).has_value()) << length;
  EXPECT_FALSE(decode(bytes + "x").has_value());
}

TEST(UnitEncoding, AKeyThatIsNoHashIsRefused) {  // the key becomes the name of a file
  for (const char* key : {"", "../../../../home/user/.profile1234", "0123456789abcdef0123456789abcde/"}) {
    UnitReply reply;
    reply.to_keep = {{EntryKind::compile, key, "content"}};
    EXPECT_FALSE(decode_reply(encode(reply))) << key;
  }
}

TEST(UnitEncoding, GoesThereAndBack) {
  expect_round_trip(encode(full_job()), decode_job);
  expect_round_trip(encode(full_job().unit), decode_unit);
  expect_round_trip(encode(full_reply()), decode_reply);
  expect_round_trip(encode(*full_reply().compile), decode_compile_answer);
  expect_round_trip(encode(SourceRecord{"key", {{"f", "h"}, {"g", "i"}}, {"absent"}}), decode_source_record);
}

TEST(UnitEncoding, KeepsEveryMember) {
  const UnitJob job = *decode_job(encode(full_job()));
  EXPECT_EQ(job.unit.compile.stage, hlsl::Stage::hull);
  EXPECT_EQ(job.unit.compile.cginc_root, "cginc");
  EXPECT_FALSE(job.unit.compile.optimise);
  EXPECT_TRUE(job.unit.compile.prepare);
  EXPECT_TRUE(job.unit.compile.keep_unoptimised);
  EXPECT_EQ(job.unit.sub_shader, 2);
  EXPECT_EQ(job.unit.lint.shader_target, 45);
  EXPECT_EQ(job.unit.compile.vulkan, shaders::VulkanVersion::v1_2);
  EXPECT_EQ(job.unit.shader.size(), 13U);
  EXPECT_EQ(job.context.drivers.at("essl310"), "Mesa");
  UnitJob without = full_job();
  without.unit.compile.text.reset();
  EXPECT_FALSE(decode_job(encode(without))->unit.compile.text.has_value());
  const UnitReply reply = *decode_reply(encode(full_reply()));
  EXPECT_EQ(reply.emitted->at(1).at(1).source_line, "the line");
  EXPECT_EQ(reply.emitted->at(1).at(1).rule, "rule");
  EXPECT_EQ(reply.compile->of_targets.at(0).target, "msl23");
  EXPECT_EQ(reply.compile->of_targets.at(0).diagnostics.at(0).rule, "rule");
  ASSERT_EQ(reply.to_keep.size(), 1U);
  EXPECT_EQ(reply.to_keep[0].kind, EntryKind::emitted);
  EXPECT_EQ(reply.to_keep[0].key, std::string(platform::content_hash_digits, 'a'));
  EXPECT_EQ(reply.to_keep[0].content, "content");
}

TEST(Keys, HoldTheBuildAndTheDrivers) {
  const CompileUnit unit = full_job().unit;
  shaders::PreprocessedSource source;
  source.text = "text";
  AnswerContext context = full_job().context;
  AnswerContext rebuilt = context;
  rebuilt.build = "another";
  EXPECT_NE(sources_key(context, unit), sources_key(rebuilt, unit));
  EXPECT_NE(text_key(context, unit, source), text_key(rebuilt, unit, source));
  EXPECT_NE(emitted_key(context, unit, "m"), emitted_key(rebuilt, unit, "m"));
  AnswerContext driven = context;
  driven.drivers["msl23"] = "one that compiles it";
  EXPECT_NE(emitted_key(context, unit, "m"), emitted_key(driven, unit, "m"));
  EXPECT_NE(emitted_key(context, unit, "m"), emitted_key(context, unit, "n"));
}

TEST(Keys, OfATextDoNotHoldWhereItCameFrom) {
  const AnswerContext context = full_job().context;
  CompileUnit unit = full_job().unit;
  shaders::PreprocessedSource source;
  source.text = "text";
  const std::string before = text_key(context, unit, source);
  unit.compile.defines.clear();
  unit.compile.package_roots.clear();
  unit.compile.include_directories = {"elsewhere"};
  unit.compile.written_for.reset();
  EXPECT_EQ(text_key(context, unit, source), before);
  unit.compile.entry = "other";
  EXPECT_NE(text_key(context, unit, source), before);
  CompileUnit older = full_job().unit;
  older.compile.vulkan = shaders::VulkanVersion::v1_1;
  EXPECT_NE(text_key(context, older, source), before);
  source.diagnostics.push_back(diagnostic());
  EXPECT_NE(text_key(context, full_job().unit, source), before);
}

TEST(Keys, HoldWhatLintIsTold) {
  const AnswerContext context = full_job().context;
  const CompileUnit unit = full_job().unit;
  shaders::PreprocessedSource source;
  source.text = "text";
  std::vector<CompileUnit> others(3, unit);
  others[0].lint.wanted = !unit.lint.wanted;
  others[1].lint.shader_target = unit.lint.shader_target + 5;
  others[2].lint.left_out.push_back("lane-order");
  for (const CompileUnit& other : others) {
    EXPECT_NE(sources_key(context, unit), sources_key(context, other));
    EXPECT_NE(text_key(context, unit, source), text_key(context, other, source));
  }
}

TEST(UnitEncoding, DamagedBytesEndNoProgram) {
  const std::string bytes = encode(full_reply());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ (1U << bit));
      const std::optional<UnitReply> reply = decode_reply(damaged);
      EXPECT_TRUE(!reply || encode(*reply).size() <= damaged.size() + 16);
    }
  }
}

}  // namespace
}  // namespace penumbra::validation
