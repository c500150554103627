// Sends ten thousand damaged shaders through the whole program: it ends in time, with an answer for every
// file.
//
// A compiler may crash or hang on some of them, in its worker; the program may not.
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "cli/program.h"
#include "shaderlab/parse.h"
#include "shaderlab/programs.h"
#include "validate_report.h"

namespace penumbra {
namespace {

constexpr int folders = 4;
constexpr int mutants_of_folder = 2500;

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

// The text "#define M0 x", "#define M1 M0 <join> M0" and so on is used at once: of depth 13, or rarely a bomb
// of depth 32.
std::string nested_macros(std::size_t depth, const std::string& join) {
  std::string text = "#define M0 1\n";
  for (std::size_t i = 1; i < depth; ++i) {
    const std::string inner = "M" + std::to_string(i - 1);
    text += "#define M" + std::to_string(i) + " " + (join.empty() ? inner : inner + join + inner) + "\n";
  }
  return text + "static const float deep = M" + std::to_string(depth - 1) + ";\n";
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  std::string mutant(std::string text, const std::string& other, const std::string& own_name) {
    for (std::size_t i = 1 + below(4); i > 0; --i) mutate(text, other, own_name);
    return text;
  }

 private:
  void mutate(std::string& text, const std::string& other, const std::string& own_name) {
    static const std::vector<std::string> words{"#if ",
                                                "#endif\n",
                                                "#else\n",
                                                "#define M(x) ",
                                                "{",
                                                "}",
                                                "(",
                                                ")",
                                                ";",
                                                "\"",
                                                "/*",
                                                "*/",
                                                "\\\n",
                                                "##",
                                                "float4x4 ",
                                                "cbuffer C { ",
                                                "ENDHLSL\n",
                                                "Pass { ",
                                                "[unroll] ",
                                                "half ",
                                                "return ",
                                                "0xFFFFFFFFF",
                                                "1e999",
                                                "Texture2D ",
                                                "__LINE__",
                                                "$",
                                                "::",
                                                "template<",
                                                "#line 7 \"z\"\n",
                                                "\xEF\xBB\xBF",
                                                "\r\n"};
    const std::size_t at = below(text.size() + 1);
    switch (below(9)) {
      case 0:
        for (std::size_t i = 1 + below(8); i > 0 && !text.empty(); --i)
          text[below(text.size())] = static_cast<char>(random_());
        break;
      case 1:
        text.erase(at, 1 + below(200));
        break;
      case 2:
        text.insert(at, text.substr(below(text.size() + 1), below(200)));
        break;
      case 3:
        text.insert(at, words[below(words.size())]);
        break;
      case 4:
        text.insert(line_start(text, at), "#include \"" + own_name + "\"\n");
        break;
      case 5:
        text.insert(line_start(text, at),
                    nested_macros(below(500) == 0 ? 32 : 2 + below(12), below(2) == 0 ? "" : " + "));
        break;
      case 6:
        text.insert(at, other.substr(below(other.size() + 1), below(300)));
        break;
      case 7:
        text.insert(at, repeated(words[below(words.size())], 1 + below(400)));
        break;
      default:
        text.resize(at);
    }
  }

  static std::size_t line_start(const std::string& text, std::size_t at) {
    const std::size_t newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return newline == std::string::npos ? 0 : newline + 1;
  }

  std::mt19937 random_;
};

std::vector<std::pair<std::string, std::string>> seeds() {
  std::vector<std::pair<std::string, std::string>> list;  // extension, text
  const std::filesystem::path tests = std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests";
  for (const std::filesystem::path& folder : {tests / "validation" / "broken", tests / "cli" / "seeds"})
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!entry.is_regular_file()) continue;
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      list.emplace_back(entry.path().extension().string(), text.str());
    }
  std::sort(list.begin(), list.end());
  return list;
}

class Mutants : public ProgramTest, public testing::WithParamInterface<int> {};

TEST_P(Mutants, EveryFileHasItsAnswer) {
  const auto all = seeds();
  ASSERT_GE(all.size(), 50U);
  Mutator mutator(static_cast<unsigned>(GetParam()));
  std::set<std::string> expected;
  for (int i = 0; i < mutants_of_folder; ++i) {
    const auto& [extension, text] = all[mutator.below(all.size())];
    if (extension != ".shader" && extension != ".compute" && extension != ".hlsl") continue;
    const std::string name = "m" + std::to_string(i) + extension;
    const std::string mutant = mutator.mutant(text, all[mutator.below(all.size())].second, name);
    const std::string file = write("shaders/" + name, mutant).string();
    // A .shader without a program is only read.
    const shaderlab::ParsedShader parsed = shaderlab::parse_shader(mutant, file);
    if (extension != ".shader" || hlsl::has_errors(parsed.diagnostics) || !programs(parsed.shader).empty())
      expected.insert(file);
  }
  ASSERT_GE(expected.size(), mutants_of_folder * 9U / 10U);
  platform::ChildCommand command;
  command.program = PENUMBRA_PROGRAM;
  command.arguments = {"validate",
                       path("shaders").string(),
                       "--target",
                       "spirv,msl23",
                       "--sample",
                       "2",
                       "--no-cache",
                       "--jobs",
                       "2",
                       "--time-limit",
                       "3",
                       "--memory-limit",
                       "512",
                       "--keep",
                       path("kept").string(),
                       "--format",
                       "json",
                       "-o",
                       path("report.json").string()};
  for (const std::string& file : expected)  // in folders, .hlsl files are what others include
    if (file.ends_with(".hlsl")) command.arguments.push_back(file);
  command.timeout = std::chrono::minutes(25);
  const platform::ChildResult result = platform::run_child(command);
  ASSERT_THAT(result.exit_code, testing::AnyOf(1, 70)) << result.errors;
  const nlohmann::json report = nlohmann::json::parse(read("report.json"));
  int crashes = 0;
  for (const nlohmann::json& variant : results_of(report)) {
    expected.erase(variant["file"].get<std::string>());
    const std::string status = variant["status"];
    bool has_error = false;
    for (const nlohmann::json& said : variant["messages"]) {
      has_error = has_error || said["severity"] == "error";
      EXPECT_FALSE(said["message"].get<std::string>().empty());
    }
    EXPECT_EQ(status == "failed", has_error) << variant;
    if (!variant.contains("reproduction")) continue;
    ++crashes;
    EXPECT_TRUE(std::filesystem::exists(variant["reproduction"].get<std::string>())) << variant;
  }
  EXPECT_FALSE(result.timed_out);
  EXPECT_TRUE(expected.empty()) << expected.size() << " files have no record, the first "
                                << *expected.begin();
  RecordProperty("crashes_in_workers", crashes);
}

INSTANTIATE_TEST_SUITE_P(TenThousand, Mutants, testing::Range(0, folders));

}  // namespace
}  // namespace penumbra
