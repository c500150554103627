// Whatever stands in a project's JSON files, reading it ends in a project or in an InputError that names the
// file.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>

#include "input/input_error.h"
#include "project/package_versions.h"
#include "project/unity_project.h"
#include "project_folder.h"
#include "sanitized.h"

namespace penumbra::project {
namespace {

const std::string manifest =
    R"({"dependencies": {"com.x.a": "1.0.0", "com.x.b": "file:../b", "com.x.c": "https://h/c.git#1"},)"
    R"( "scopedRegistries": [{"name": "x", "url": "https://h", "scopes": ["com.x"]}]})";
const std::string lock =
    R"({"dependencies": {"com.x.a": {"version": "1.0.0", "depth": 0, "source": "registry"},)"
    R"( "com.x.c": {"version": "https://h/c.git#1", "source": "git", "hash": "24c1c38f35bd3111"}}})";
const std::string package =
    R"({"name": "com.x.a", "version": "1.0.0-pre.1", "dependencies": {"com.x.b": "1.0.0"}})";

// A string, value or key, gives its place to something else that JSON knows.
void replace_a_string(std::string& text, std::size_t from, std::mt19937& random) {
  static const std::string others[] = {"null", "3", "[]", "{}", "true", "\"\"", "[[\"a\"]]", "{\"a\": {}}"};
  const std::size_t start = text.find('"', from);
  const std::size_t end = start == std::string::npos ? start : text.find('"', start + 1);
  if (end != std::string::npos) text.replace(start, end + 1 - start, others[random() % std::size(others)]);
}

// The text after one to four edits: a byte changed, a piece cut, a piece doubled, a token that JSON knows put
// in.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::string tokens[] = {"{", "}",    "[",      "]",       "\"",   ",",
                                       ":", "null", "-1e999", "\\u0000", "\xff", "file:"};
  for (std::size_t edits = 1 + random() % 4; edits > 0 && !text.empty(); --edits) {
    const std::size_t at = random() % text.size();
    const std::size_t length = random() % 12;
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        replace_a_string(text, at, random);
        break;
      default:
        text.insert(at, tokens[random() % std::size(tokens)]);
    }
  }
  return text;
}

struct Outcomes {
  int projects = 0;
  int refused = 0;
};

void read_once(const ProjectFolder& files, Outcomes& outcomes) {
  try {
    const UnityProject project = read_project(files.path());
    for (const PackageRoot& root : project.packages) EXPECT_FALSE(root.directory.empty());
    version_problems(project.packages);
    ++outcomes.projects;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(files.text("Packages/"), 0), 0U) << error.what();
    ++outcomes.refused;
  }
}

TEST(ProjectMutation, EndsInAProjectOrInAnInputError) {
  const ProjectFolder files;
  files.package("b", "com.x.b", "1.0.0");
  files.package("Library/PackageCache/com.x.c@24c1c38f35", "com.x.c", "1.0.0");
  const std::pair<std::string, std::string> texts[] = {
      {"Packages/manifest.json", manifest},
      {"Packages/packages-lock.json", lock},
      {"Library/PackageCache/com.x.a@1.0.0/package.json", package},
      {"Packages/e/package.json", package}};
  for (const auto& [name, text] : texts) files.write(name, text);
  std::mt19937 random(20240607);
  Outcomes outcomes;
  constexpr int repetitions = 3000 / sanitizer_reduction;
  for (int i = 0; i < repetitions; ++i) {
    const auto& [name, text] = texts[random() % std::size(texts)];
    files.write(name, mutated(text, random));
    read_once(files, outcomes);
    files.write(name, text);
  }
  EXPECT_GT(outcomes.projects, repetitions / 6);
  EXPECT_GT(outcomes.refused, repetitions / 6);
}

}  // namespace
}  // namespace penumbra::project
