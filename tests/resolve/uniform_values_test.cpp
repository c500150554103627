#include "resolve/uniform_values.h"

#include <gmock/gmock.h>

#include <cstring>

namespace penumbra::resolve {
namespace {

float float_at(const std::vector<std::byte>& bytes, std::size_t offset) {
  float value = 0.0f;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

shaders::Resource block(std::vector<shaders::UniformMember> members, std::uint32_t size) {
  shaders::Resource resource;
  resource.size = size;
  resource.members = std::move(members);
  return resource;
}

TEST(UniformValues, PutsEveryMemberAtItsOffsetAndNamesTheUnset) {
  UniformValues values;
  values.set("number", 1.5f);
  values.set("vector", glm::vec4(1, 2, 3, 4));
  std::vector<std::string> unset;
  const auto bytes = values.pack(block({{.name = "number", .offset = 4, .size = 4},
                                        {.name = "vector", .offset = 16, .size = 8},
                                        {.name = "missing", .offset = 24, .size = 4, .read = true},
                                        {.name = "never read", .offset = 24, .size = 4}},
                                       28),
                                 unset);
  EXPECT_EQ(float_at(bytes, 4), 1.5f);
  EXPECT_EQ(float_at(bytes, 16), 1.0f);
  EXPECT_EQ(float_at(bytes, 20), 2.0f);
  EXPECT_EQ(float_at(bytes, 24), 0.0f);  // a float2 takes two of the four and spills nothing
  EXPECT_THAT(unset, testing::ElementsAre("missing"));
}

TEST(UniformValues, MatricesFollowTheirDecoration) {
  glm::dmat4 matrix(1.0);
  matrix[3] = {10, 20, 30, 1};  // a translation is the fourth column of mul(M, v)
  UniformValues values;
  values.set("m", std::span<const glm::dmat4>(&matrix, 1));
  std::vector<std::string> unset;
  shaders::UniformMember member{.name = "m", .offset = 0, .size = 64, .matrix_stride = 16, .row_major = true};
  const auto columns = values.pack(block({member}, 64), unset);
  EXPECT_EQ(float_at(columns, 48), 10.0f);  // the words go column after column
  EXPECT_EQ(float_at(columns, 12), 0.0f);
  member.row_major = false;
  const auto rows = values.pack(block({member}, 64), unset);
  EXPECT_EQ(float_at(rows, 12), 10.0f);  // the words go row after row
  EXPECT_EQ(float_at(rows, 48), 0.0f);
}

TEST(UniformValues, ArraysStopAtTheShorterOfTheTwo) {
  const std::vector<glm::vec4> two{glm::vec4(1), glm::vec4(2)};
  UniformValues values;
  values.set("a", std::span<const glm::vec4>(two));
  std::vector<std::string> unset;
  const auto longer = values.pack(
      block({{.name = "a", .offset = 0, .size = 64, .array_length = 4, .array_stride = 16}}, 64), unset);
  EXPECT_EQ(float_at(longer, 16), 2.0f);
  EXPECT_EQ(float_at(longer, 32), 0.0f);
  const auto shorter = values.pack(
      block({{.name = "a", .offset = 0, .size = 16, .array_length = 1, .array_stride = 16}}, 32), unset);
  EXPECT_EQ(float_at(shorter, 16), 0.0f);
}

}  // namespace
}  // namespace penumbra::resolve
