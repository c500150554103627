// Reports are joined and told in other forms, with the exit codes of the run itself.
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace penumbra {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Merge : public ProgramTest {
 protected:
  // The JSON report of one shader, made shard index/count.
  std::string shard(const std::string& name, const std::string& body, int index, int count) {
    const std::string shader = write(name + ".hlsl", "float4 Main() : SV_Target { " + body + " }\n").string();
    const std::string file = path(name + ".json").string();
    run({"validate", shader, "--target", "spirv,msl23", "--format", "json", "-o", file});
    nlohmann::json report = nlohmann::json::parse(read(name + ".json"));
    report["shard"] = {{"index", index}, {"count", count}};
    report["fingerprint"] = "of one request";
    write(name + ".json", report.dump());
    return file;
  }
};

TEST_F(Merge, JoinsShardsAndFailsWhereOneFailed) {
  const std::string good = shard("good", "return 1;", 2, 2);
  const std::string broken = shard("broken", "return glow;", 1, 2);
  const auto result = run({"merge", good, broken, "-o", path("all.json").string()});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.output, IsEmpty());
  const nlohmann::json merged = nlohmann::json::parse(read("all.json"));
  EXPECT_EQ(merged.at("summary").at("results"), 4);
  EXPECT_EQ(merged.at("summary").at("failed"), 2);  // the mistake is in the source of either target
  EXPECT_THAT(merged.at("variants").at(0).at("file").get<std::string>(), HasSubstr("broken.hlsl"));
  EXPECT_EQ(run({"merge", path("all.json").string(), "--format", "text"}).exit_code, 1);
}

TEST_F(Merge, AWholeReportIsToldInEveryForm) {
  const std::string report = shard("good", "return 1;", 1, 1);
  const auto form = [&](const std::string& name) { return run({"merge", report, "--format", name}); };
  EXPECT_THAT(form("text").output, HasSubstr("1 variant for 2 targets: 2 results"));
  EXPECT_THAT(form("json").output, StartsWith("{\n  \"summary\""));
  EXPECT_THAT(form("sarif").output, HasSubstr("\"version\": \"2.1.0\""));
  EXPECT_THAT(form("junit").output, HasSubstr("<testsuites name=\"penumbra\" tests=\"2\""));
  EXPECT_THAT(form("github").output, HasSubstr("0 failed"));
  EXPECT_EQ(form("sarif").exit_code, 0);
  EXPECT_EQ(form("html").exit_code, 2);
}

TEST_F(Merge, MissingShardsAndStrangeFilesAreBadInputAndChangeNothing) {
  const std::string first = shard("good", "return 1;", 1, 2);
  write("out.json", "old");
  expect_bad_input({"merge", first, "-o", path("out.json").string()}, HasSubstr("shard 2/2 is missing"));
  EXPECT_EQ(read("out.json"), "old");
  expect_bad_input({"merge", write("x.json", "{\n\"variants\": [3]}").string()},
                   HasSubstrs("x.json:2:", "expected an object"));
  EXPECT_EQ(run({"merge", path("none.json").string()}).exit_code, 2);
  EXPECT_EQ(run({"merge"}).exit_code, 2);
}

TEST_F(Merge, ColourIsForTerminalsThatWantIt) {
  const std::string report = shard("broken", "return glow;", 1, 1);
  const std::string command = PENUMBRA_PROGRAM " merge " + report + " --format text";
  EXPECT_THAT(shell(command).output, testing::Not(HasSubstr("\x1b[")));
  // script(1) gives the program a terminal.
  EXPECT_THAT(shell("script -qec '" + command + "' /dev/null").output, HasSubstr("\x1b[1;31merror"));
  EXPECT_THAT(shell("NO_COLOR=1 script -qec '" + command + "' /dev/null").output,
              testing::Not(HasSubstr("\x1b[")));
}

}  // namespace
}  // namespace penumbra
