// Sends texts that want to crash, hang or multiply: an answer comes, and soon.
#include <gmock/gmock.h>

#include "input/input_error.h"
#include "processor_time.h"
#include "sanitized.h"
#include "variants/keyword_space.h"
#include "variants/plan.h"
#include "variants/program_text.h"

namespace penumbra::variants {
namespace {

using hlsl::Stage;

// Asks everything of a program: its counts, its first and its last variant.
void use(const Pragmas& pragmas) {
  try {
    const KeywordSpace space(pragmas);
    for (const hlsl::Stage stage : hlsl::all_stages) {
      const VariantList& variants = space.variants(stage);
      const std::uint64_t count = variants.count().value();
      if (count == 0) continue;
      EXPECT_EQ(variants.at(0), *variants.begin());
      EXPECT_LE(shader_target(pragmas, variants.at(count - 1)), 69);
      EXPECT_GE(shader_target(pragmas, variants.at(count - 1)), 25);
    }
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("65536"), std::string::npos) << error.what();
  }
}

std::string repeated(const std::string& piece, int times) {
  std::string text;
  text.reserve(piece.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

std::string numbered(const std::string& before, const std::string& after, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += before + std::to_string(i) + after;
  return text;
}

constexpr int kilo = 1000 / sanitizer_reduction;
constexpr int doublings = sanitizer_reduction == 1 ? 60 : 8;  // doublings of a macro that grows

struct Attack {
  const char* name;
  std::string text;
};

// Each attack has about half a megabyte without the sanitizer; code that is quadratic in it would need
// minutes.
std::vector<Attack> attacks() {
  return {
      {"open comments", repeated("/*", 250 * kilo)},
      {"joined lines", "#pragma multi_compile " + repeated("A\\\n", 150 * kilo)},
      {"one long set", "#pragma multi_compile" + numbered(" K", "", 60 * kilo)},
      {"one long set, all skipped", "#pragma multi_compile" + numbered(" K", "", 30 * kilo) +
                                        "\n#pragma skip_variants" + numbered(" K", "", 30 * kilo)},
      {"many sets", numbered("#pragma multi_compile _ K", "\n", 15 * kilo)},
      {"one set many times", repeated("#pragma multi_compile _ A B\n", 15 * kilo)},
      {"a keyword in many sets", numbered("#pragma multi_compile _ A K", "\n", 15 * kilo)},
      {"many dynamic keywords", "#pragma dynamic_branch" + numbered(" K", "", 30 * kilo) +
                                    "\n#pragma multi_compile _" + numbered(" K", "", 30 * kilo)},
      {"deep conditions", repeated("#if 1\n", 80 * kilo) + "#pragma vertex V\n"},
      {"conditions on many names", repeated("#if", 1) + numbered(" K", " ||", 3 * kilo) + " 1\n" +
                                       repeated("#pragma warning x\n#if A\n#endif\n", 15 * kilo)},
      {"long conditions", repeated("#if " + repeated("1+", 3 * kilo / 2) + "1\n#endif\n", 150)},
      {"macros that grow", "#define M0 1\n" +
                               [] {
                                 std::string text;
                                 for (int i = 1; i <= doublings; ++i) {
                                   const std::string inner = "M" + std::to_string(i - 1);
                                   text +=
                                       "#define M" + std::to_string(i) + " " + inner + " + " + inner + "\n";
                                 }
                                 return text;
                               }() +
                               repeated("#if M" + std::to_string(doublings) + "\n#endif\n", 20 * kilo)},
      {"many messages", repeated("#pragma target x\n", 30 * kilo)},
      {"unknown pragmas", numbered("#pragma x", "\n", 3 * kilo)},
  };
}

TEST(Hostile, WorkStaysLinear) {
  for (const Attack& attack : attacks()) {
    const double seconds = processor_seconds([&] { use(pragmas_of(attack.text)); });
    EXPECT_LT(seconds, 20.0) << attack.name;
    RecordProperty(attack.name, std::to_string(seconds));
  }
}

// The file has its mistakes at each of its 4,096 times: only those that are shown may cost a search for the
// nearest name.
TEST(Hostile, AFileOfMistakesIncludesItself) {
  const std::string text = repeated("#pragma multi_compile_fog_and_more\n", 200 / sanitizer_reduction) +
                           repeated("#include_with_pragmas \"a.hlsl\"\n", 2);
  const double seconds = processor_seconds([&] {
    EXPECT_EQ(pragmas_of("#include_with_pragmas \"a.hlsl\"\n", {{"a.hlsl", text}}).diagnostics.size(), 200U);
  });
  EXPECT_LT(seconds, 20.0);
}

TEST(Hostile, IncludesThatFanOutAreBounded) {
  Files files;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "f" + std::to_string(i + 1) + ".hlsl";
    files["f" + std::to_string(i) + ".hlsl"] =
        "#include_with_pragmas \"" + next + "\"\n#include_with_pragmas \"" + next + "\"\n";
  }
  files["f40.hlsl"] = "#pragma multi_compile _ A\n";
  const Pragmas pragmas = pragmas_of("#include_with_pragmas \"f0.hlsl\"\n", files);
  ASSERT_EQ(pragmas.diagnostics.size(), 1U);
  EXPECT_EQ(pragmas.diagnostics[0].message,
            "too many files are included; the pragmas of the rest are ignored");
  use(pragmas);
}

std::string keywords_named(int first, int last) {
  std::string text;
  for (int i = first; i < last; ++i) text += " _K" + std::to_string(i);
  return text;
}

// This is Unity's limit for a shader.
TEST(ManyKeywords, MoreThan65534AreRefusedAtTheFirstBeyond) {
  const std::string most = "#pragma vertex V\n#pragma multi_compile _" + keywords_named(0, 65534) + "\n";
  EXPECT_THAT(messages_of(pragmas_of(most + "#pragma multi_compile _ _K7\n")),
              testing::ElementsAre("a.shader:3:1: warning: '_K7' stands in two keyword sets, here and at "
                                   "a.shader:2:1: Unity builds variants for both; declare it once"));
  const Pragmas pragmas = pragmas_of(most + "#pragma multi_compile _ _L0 _L1\n#pragma dynamic_branch _L2\n");
  EXPECT_THAT(
      messages_of(pragmas),
      testing::ElementsAre("a.shader:3:25: error: '_L0' is one keyword too many; Unity allows a shader "
                           "65534"));
}

TEST(ManyKeywords, CostTimeInProportionToTheirNumber) {
  const std::string in_one_set =
      "#pragma vertex V\n#pragma multi_compile _" + keywords_named(0, 60 * kilo) + "\n";
  std::string one_each = "#pragma vertex V\n";
  for (int i = 0; i < 60 * kilo; ++i) one_each += "#pragma multi_compile _ _K" + std::to_string(i) + "\n";
  const double seconds = processor_seconds([&] {
    for (const std::string& text : {in_one_set, one_each}) {
      const KeywordSpace space(pragmas_of(text));
      const std::string refused = refusal({{"P", &space, {Stage::vertex}}}, 10);
      EXPECT_THAT(refused, testing::HasSubstr("--keywords '-_K0"));
    }
  });
  EXPECT_LT(seconds, 20.0) << "what grows with the square takes minutes";
}

}  // namespace
}  // namespace penumbra::variants
