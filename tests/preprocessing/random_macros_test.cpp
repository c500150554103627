// Random sources are read as GCC's preprocessor reads them, but for white space.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "platform/child_process.h"
#include "preprocessing/random_macros.h"
#include "preprocessing/read_text.h"

namespace penumbra::preprocessing {
namespace {

constexpr std::uint32_t programs = 3000;

std::string without_white_space(const std::string& text) {
  std::string rest;
  for (const char c : text)
    if (std::isspace(static_cast<unsigned char>(c)) == 0) rest += c;
  return rest;
}

// All programs are one source for GCC, with a marker before each.
class ByGcc {
 public:
  ByGcc() {
    platform::ChildCommand gcc{"gcc", {"-E", "-P", "-undef", "-x", "c", "-"}, {}};
    std::vector<int> first_lines;
    int line = 1;
    for (std::uint32_t seed = 0; seed < programs; ++seed) {
      std::string text = "MARK\n";
      for (const char* const name : {"A", "B", "C", "D", "F", "G", "H", "AB"})
        text.append("#undef ").append(name).append("\n");
      first_lines.push_back(line);
      text += random_macros(seed);
      line += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
      gcc.input += text;
    }
    const platform::ChildResult said = platform::run_child(gcc);
    const std::string text = without_white_space(said.output);
    for (std::size_t at = text.find("MARK"); at != std::string::npos;) {
      const std::size_t next = text.find("MARK", at + 4);
      texts_.push_back(text.substr(at + 4, next == std::string::npos ? next : next - at - 4));
      at = next;
    }
    std::istringstream messages(said.errors);
    for (std::string message; std::getline(messages, message);) {
      const std::size_t error = message.find(": error:");
      const std::size_t colon = message.find("<stdin>:");
      if (error == std::string::npos || colon == std::string::npos) continue;
      const auto after =
          std::upper_bound(first_lines.begin(), first_lines.end(), std::stoi(message.substr(colon + 8)));
      wrong_.insert(static_cast<std::size_t>(after - first_lines.begin()) - 1);
    }
  }

  std::size_t size() const { return texts_.size(); }
  const std::string* text(std::size_t seed) const { return wrong_.contains(seed) ? nullptr : &texts_[seed]; }

 private:
  std::vector<std::string> texts_;
  std::set<std::size_t> wrong_;  // programs of which GCC reports an error
};

TEST(RandomMacros, AreReadAsGccReadsThem) {
  const ByGcc by_gcc;
  ASSERT_EQ(by_gcc.size(), programs);
  std::size_t right = 0;
  for (std::uint32_t seed = 0; seed < programs; ++seed) {
    const std::string* const expected = by_gcc.text(seed);
    if (expected == nullptr) continue;
    ++right;
    const std::string source = random_macros(seed);
    ASSERT_EQ(without_white_space(read_text(source)), *expected) << "seed " << seed << "\n" << source;
  }
  EXPECT_GT(right, programs / 3);
}

}  // namespace
}  // namespace penumbra::preprocessing
