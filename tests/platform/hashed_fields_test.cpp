#include "platform/hashed_fields.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace penumbra::platform {
namespace {

enum class Colour { red, green };

class Counted {
 public:
  Counted() = default;
  explicit Counted(int count) : count_(count) {}
  friend void add_fields(ContentHash& hash, const Counted& counted) { hash.update(counted.count_); }

 private:
  int count_ = 0;
};

struct Inner {
  int number = 0;
  std::optional<std::string> text{};
};

struct Outer {
  std::string name;
  std::optional<Inner> inner;
  std::array<int, 3> size{};
  std::vector<std::pair<std::string, std::string>> reads;
  std::map<std::string, std::vector<double>> values;
  std::set<std::string> words;
  std::vector<Inner> all;
  std::vector<bool> flags;
  std::vector<float> texels;
  std::filesystem::path file;
  Colour colour = Colour::red;
  glm::vec4 point{0.0F};
  glm::dmat4 matrix{1.0};
  float part = 0.0F;
  bool on = false;
  Counted counted{};
  std::string last;
};

TEST(HashedFields, OfEveryKindChangeTheHash) {
  const std::vector<std::function<void(Outer&)>> changes{
      [](Outer& value) { value.name = "n"; },           [](Outer& value) { value.inner = Inner{}; },
      [](Outer& value) { value.inner = Inner{0, ""}; }, [](Outer& value) { value.inner = Inner{1, {}}; },
      [](Outer& value) { value.size[2] = 1; },          [](Outer& value) { value.reads = {{"a", "b"}}; },
      [](Outer& value) { value.reads = {{"b", "a"}}; }, [](Outer& value) { value.values["a"] = {}; },
      [](Outer& value) { value.values["a"] = {0.0}; },  [](Outer& value) { value.words = {"a"}; },
      [](Outer& value) { value.all = {{}}; },           [](Outer& value) { value.all = {{}, {}}; },
      [](Outer& value) { value.flags = {false}; },      [](Outer& value) { value.texels = {0.0F}; },
      [](Outer& value) { value.file = "f"; },           [](Outer& value) { value.colour = Colour::green; },
      [](Outer& value) { value.point.w = 1.0F; },       [](Outer& value) { value.matrix[3][0] = 1.0; },
      [](Outer& value) { value.part = 0.1F; },          [](Outer& value) { value.on = true; },
      [](Outer& value) { value.counted = Counted(1); }, [](Outer& value) { value.last = "l"; },
  };
  std::set<std::string> hashes{hash_of(Outer{})};
  for (const auto& change : changes) {
    Outer value;
    change(value);
    hashes.insert(hash_of(value));
  }
  EXPECT_EQ(hashes.size(), changes.size() + 1);
  EXPECT_EQ(hash_of(Outer{}), hash_of(Outer{}));
}

TEST(HashedFields, KeepTheBoundariesOfValues) {
  const std::string a = "a", ab = "ab", b = "b", bc = "bc", c = "c";
  EXPECT_NE(hash_of(ab, c), hash_of(a, bc));
  EXPECT_NE(hash_of(std::vector<std::string>{a}, b), hash_of(std::vector<std::string>{a, b}));
}

}  // namespace
}  // namespace penumbra::platform
