// Runs random programs on the device against the rules of the language. docs/validating.md says
// how many were run.
#include <gmock/gmock.h>

#include <cstdlib>
#include <iostream>

#include "fxc/at_hand.h"
#include "programs/arithmetic.h"
#include "programs/batch.h"
#include "programs/build.h"
#include "programs/device_run.h"
#include "programs/interpreter.h"
#include "programs/program_text.h"
#include "programs/random_program.h"

namespace penumbra::programs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

int number(const char* variable, int otherwise) {
  const char* given = std::getenv(variable);
  return given == nullptr ? otherwise : std::atoi(given);
}

// The programs are in two halves, for two processors. PENUMBRA_RANDOM_PROGRAMS=10000 runs more of them,
// PENUMBRA_FIRST_SEED others; scripts/pages publishes what the lines at the end say.
class RandomProgramsHalf : public testing::TestWithParam<std::tuple<int, Compiler>> {};

TEST_P(RandomProgramsHalf, MeansOnTheDeviceWhatTheLanguageSays) {
  constexpr int between_halves = 1000000;
  const auto [half, compiler] = GetParam();
  const bool by_fxc = compiler == Compiler::fxc;
  if (by_fxc) PENUMBRA_NEEDS_FXC();
  const auto first = static_cast<std::uint32_t>(number("PENUMBRA_FIRST_SEED", 1) + half * between_halves);
  const BatchResult result =
      run_batch(first, number("PENUMBRA_RANDOM_PROGRAMS", by_fxc ? 100 : 500) / 2, compiler);
  EXPECT_THAT(result.differences, IsEmpty());
  // FXC does not write to an element of some arrays whose index it cannot know (X3500), and vkd3d-shader does
  // not translate firstbithigh() of vectors.
  EXPECT_LE(result.refusals.size(), static_cast<std::size_t>(by_fxc ? result.programs / 10 : 0));
  std::cout << result.programs << " programs by " << (by_fxc ? "FXC" : "glslang") << " on " << kSets
            << " sets of inputs each, seeds from " << first << " on, " << result.unfit << " more not run, "
            << result.refusals.size() << " refused; differences: " << result.differences.size()
            << ", largest distance of two floats: " << result.most_ulps << " ULP; device: " << device_name()
            << "\n";
}

INSTANTIATE_TEST_SUITE_P(Both, RandomProgramsHalf,
                         testing::Combine(testing::Values(0, 1),
                                          testing::Values(Compiler::glslang, Compiler::fxc)));

TEST(RandomPrograms, AreTheSameForTheSameSeed) {
  EXPECT_EQ(program_text(random_program(5, "p_")), program_text(random_program(5, "p_")));
  EXPECT_NE(program_text(random_program(5, "p_")), program_text(random_program(6, "p_")));
}

// Each kind must come up among a million tokens that a generator may write, or it is not tested.
TEST(RandomPrograms, HoldEverythingTheyAreMadeOf) {
  std::string text;
  for (std::uint32_t seed = 0; seed < 400; ++seed) text += program_text(random_program(seed, "p_"));
  for (const char* part :
       {"int ",    "uint",       "float3",    "bool",     "float2x3", "float4x4 ", "struct ", "static ",
        "out ",    "inout ",     "[2]",       "switch (", "case ",    "default:",  "for (",   "do {",
        "while (", "break;",     "continue;", "return",   " else ",   "._m",       ".zx",     " ? ",
        "mul(",    "transpose(", "dot(",      "lerp(",    "fmod(",    "mad(",      "step(",   "clamp(",
        "sign(",   "countbits(", "sqrt(",     "length(",  " % ",      " / ",       " << ",    " >> ",
        " && ",    " || ",       " ^ ",       "~",        "!",        " <= ",      " != ",    "+= ",
        "++",      "(int3)",     "{ "})
    EXPECT_THAT(text, HasSubstr(part));
}

Value value(Base base, std::vector<double> numbers) {
  Value made{numbers.size() == 1 ? scalar(base) : vector(base, static_cast<int>(numbers.size())), {}};
  for (const double one : numbers) made.words.push_back(build::number(base, one).bits);
  return made;
}

// The rules themselves are tested at values where other languages differ.
TEST(Rules, OfIntegers) {
  EXPECT_EQ(binary("%", value(Base::integer, {-7}), value(Base::integer, {2})).words,
            value(Base::integer, {-1}).words);
  EXPECT_EQ(binary("/", value(Base::integer, {-7}), value(Base::integer, {2})).words,
            value(Base::integer, {-3}).words);
  EXPECT_EQ(binary(">>", value(Base::integer, {-8}), value(Base::integer, {1})).words,
            value(Base::integer, {-4}).words);
  EXPECT_EQ(binary("+", value(Base::integer, {-1}), value(Base::natural, {0})).type.base, Base::natural);
  EXPECT_EQ(binary("+", value(Base::boolean, {1}), value(Base::boolean, {1})).words,
            value(Base::integer, {2}).words);
  EXPECT_THROW(binary("/", value(Base::integer, {1}), value(Base::integer, {0})), Unfit);
  EXPECT_THROW(binary("<<", value(Base::integer, {1}), value(Base::integer, {32})), Unfit);
}

TEST(Rules, OfFloatsAndVectors) {
  EXPECT_EQ(binary("%", value(Base::real, {-7.5}), value(Base::real, {2})).words,
            value(Base::real, {-1.5}).words);
  EXPECT_EQ(binary("+", value(Base::real, {1, 2, 3}), value(Base::real, {1, 1})).words,
            value(Base::real, {2, 3}).words);
  EXPECT_EQ(binary("<", value(Base::real, {1, 3}), value(Base::integer, {2})).words,
            (std::vector<std::uint32_t>{1, 0}));
  EXPECT_EQ(convert(value(Base::real, {-2.75}), scalar(Base::integer)).words,
            value(Base::integer, {-2}).words);
  EXPECT_EQ(intrinsic("round", scalar(Base::real), {value(Base::real, {2.5})}).words,
            value(Base::real, {2}).words);
  EXPECT_EQ(intrinsic("sign", scalar(Base::integer), {value(Base::real, {-2.5})}).words,
            value(Base::integer, {-1}).words);
  EXPECT_THROW(binary("*", value(Base::real, {1.0 / 64}), value(Base::real, {1.0 / 64})), Unfit);
}

TEST(Rules, OfFunctionsAndLoops) {
  // The program is void F(inout int v) { for (int i = 0; i < 3; ++i) v += i; }   int x = 4; F(x); Out[0] = x;
  Program program;
  const Type one = scalar(Base::integer);
  program.variables = {{"v", one, Variable::Place::inout}, {"i", one}, {"x", one}};
  Statement add{Statement::Kind::assign, "+="};
  add.parts = {build::variable(0, one), build::variable(1, one)};
  Statement loop{Statement::Kind::repeat};
  loop.number = 1;
  loop.count = 3;
  loop.bodies = {{add}};
  Statement declare{Statement::Kind::declare};
  declare.number = 2;
  declare.parts = {build::number(Base::integer, 4)};
  Statement call{Statement::Kind::call};
  call.parts = {build::with_parts(Expression::Kind::call, one, "", {build::variable(2, one)})};
  Statement store{Statement::Kind::store};
  store.parts = {build::variable(2, one)};
  program.functions = {{"F", false, one, {0}, {loop}}, {"Main", false, one, {}, {declare, call, store}}};
  EXPECT_EQ(run(program, std::vector<std::uint32_t>(kInputs))[0], 7U);
}

}  // namespace
}  // namespace penumbra::programs
