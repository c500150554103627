#include "programs/batch.h"

#include <bit>
#include <optional>
#include <utility>

#include "programs/arithmetic.h"
#include "programs/device_run.h"
#include "programs/interpreter.h"
#include "programs/program_text.h"
#include "programs/random_program.h"
#include "programs/scope.h"
#include "programs/ulp.h"

namespace penumbra::programs {

namespace {

using Words = std::vector<std::uint32_t>;

// One shader has so many programs: more than that make the compilers slow, fewer the device.
constexpr std::size_t kTogether = 4;

// The inputs are four floats, four ints and four uints for each set.
const Words& inputs() {
  static const Words all = [] {
    Chance chance(7);
    Words words;
    for (int set = 0; set < kSets; ++set) {
      for (int i = 0; i < 4; ++i)
        words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(chance.between(-32, 32)) / 4));
      for (int i = 0; i < 2; ++i) words.push_back(static_cast<std::uint32_t>(chance.between(-20, 20)));
      for (int i = 0; i < 2; ++i) words.push_back(chance.word());
      for (int i = 0; i < 2; ++i) words.push_back(static_cast<std::uint32_t>(chance.below(40)));
      for (int i = 0; i < 2; ++i) words.push_back(chance.word());
    }
    return words;
  }();
  return all;
}

struct Fit {
  std::uint32_t seed;
  Program program;
  std::vector<Words> answers;  // answers for each set of inputs
};

void leave_to_glslang(std::vector<Expression>& expressions) {
  for (Expression& one : expressions) {
    if (one.name == "round") one.name = "floor";
    if (one.name == "fmod" || (one.name == "%" && one.type.base == Base::real)) {
      one.kind = Expression::Kind::intrinsic;
      one.name = "min";
    }
    leave_to_glslang(one.parts);
  }
}

// Takes out what FXC is free to compute in another way, and does. It rounds halves of constants upward, and
// those of other values to the nearest even number; its remainder of two floats is made of a quotient that is
// rounded.
void leave_to_glslang(std::vector<Statement>& body) {
  for (Statement& statement : body) {
    if (statement.name == "%=" && statement.parts[0].type.base == Base::real) statement.name = "=";
    leave_to_glslang(statement.parts);
    for (std::vector<Statement>& inner : statement.bodies) leave_to_glslang(inner);
  }
}

std::optional<Fit> fit_program(std::uint32_t seed, Compiler compiler) {
  Fit fit{seed, random_program(seed, "p" + std::to_string(seed) + "_"), {}};
  if (compiler == Compiler::fxc)
    for (Function& function : fit.program.functions) leave_to_glslang(function.body);
  try {
    for (int set = 0; set < kSets; ++set) {
      const auto first = inputs().begin() + set * kInputs;
      fit.answers.push_back(run(fit.program, Words(first, first + kInputs)));
    }
  } catch (const Unfit&) {
    return std::nullopt;
  }
  return fit;
}

std::string described(const Fit& fit, const std::string& what) {
  return "seed " + std::to_string(fit.seed) + ": " + what + "\n" + program_text(fit.program);
}

class Batch {
 public:
  explicit Batch(Compiler compiler) : compiler_(compiler) {}

  BatchResult run(std::uint32_t first, int count) {
    std::vector<Fit> together;
    for (std::uint32_t seed = first; result_.programs + static_cast<int>(together.size()) < count; ++seed) {
      std::optional<Fit> fit = fit_program(seed, compiler_);
      if (!fit) {
        ++result_.unfit;
        continue;
      }
      together.push_back(*std::move(fit));
      if (together.size() == kTogether) compare_all(together);
    }
    compare_all(together);
    return std::move(result_);
  }

 private:
  void compare_all(std::vector<Fit>& fits) {
    std::vector<const Fit*> all;
    for (const Fit& fit : fits) all.push_back(&fit);
    if (!all.empty()) compare(all);
    result_.programs += static_cast<int>(fits.size());
    fits.clear();
  }

  // Programs that do not compile together are halved, until it is known which program it is.
  void compare(const std::vector<const Fit*>& fits) {
    std::vector<const Program*> programs;
    for (const Fit* fit : fits) programs.push_back(&fit->program);
    const DeviceRun device = run_on_device(programs, inputs(), compiler_);
    if (!device.refusal.empty() && fits.size() == 1) {
      result_.refusals.push_back(described(*fits[0], device.refusal));
    } else if (!device.error.empty() && fits.size() == 1) {
      result_.differences.push_back(described(*fits[0], device.error));
    } else if (!device.error.empty() || !device.refusal.empty()) {
      const auto middle = fits.begin() + static_cast<std::ptrdiff_t>(fits.size() / 2);
      compare({fits.begin(), middle});
      compare({middle, fits.end()});
    } else {
      for (std::size_t i = 0; i < fits.size(); ++i) compare(*fits[i], i, fits.size(), device.words);
    }
  }

  void compare(const Fit& fit, std::size_t number, std::size_t programs, const Words& words) {
    for (std::size_t set = 0; set < kSets; ++set) {
      for (const Statement& statement : fit.program.functions.back().body) {
        if (statement.kind != Statement::Kind::store) continue;
        const auto output = static_cast<std::size_t>(statement.number);
        const std::uint32_t got = words.at((set * programs + number) * kOutputs + output);
        const std::uint32_t wanted = fit.answers[set][output];
        const bool real = statement.parts[0].type.base == Base::real;
        const std::int64_t apart = real ? ulps_apart(got, wanted) : got == wanted ? 0 : kUlps + 1;
        if (apart <= kUlps) {
          result_.most_ulps = std::max(result_.most_ulps, apart);
          continue;
        }
        result_.differences.push_back(described(fit, "output " + std::to_string(output) + " of inputs " +
                                                         std::to_string(set) + " is " + std::to_string(got) +
                                                         ", by the rules " + std::to_string(wanted)));
        return;
      }
    }
  }

  Compiler compiler_;
  BatchResult result_;
};

}  // namespace

BatchResult run_batch(std::uint32_t first, int count, Compiler compiler) {
  return Batch(compiler).run(first, count);
}

}  // namespace penumbra::programs
