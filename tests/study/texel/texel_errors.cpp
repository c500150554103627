// Measures how much of a penumbra narrower than a texel can be told from the texels' bits: errors of several
// estimators, on random blockers of one height. It writes JSON, from which scripts/pages makes the tables
// of Documentation~/tiled-pcss.md.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <string>

#include "input/json_lines.h"
#include "platform/atomic_file.h"
#include "platform/source_commit.h"
#include "study/texel/estimators.h"
#include "study/texel/learned.h"

namespace penumbra::texel {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kReceivers = 250'000;   // receivers of each kind
constexpr int kTraining = 2'000'000;  // receivers of each kind, others than those
constexpr std::uint32_t kSeed = 1, kTrainingSeed = 101;

constexpr double kKernels[] = {0.0, 0.5, 0.75, 0.9, 1.0, 1.125, 1.25};
constexpr double kShipped[] = {0.75, 0.875, 1.0, 1.125, 1.25};
constexpr double kEdgeKernel = 0.9;  // smallest radius of the kernel where no edge fits

// The sum of squared errors and of their squares.
struct Errors {
  double sum = 0.0, squares = 0.0;
  std::size_t count = 0;

  void add(double error) {
    const double square = error * error;
    sum += square;
    squares += square * square;
    ++count;
  }
  double rmse() const { return std::sqrt(sum / static_cast<double>(count)); }
  // Half the width of the error's 95 % confidence interval.
  double half() const {
    const double all = static_cast<double>(count), mean = sum / all;
    return 1.96 * std::sqrt((squares / all - mean * mean) / all) / (2.0 * std::sqrt(mean));
  }
};

struct Estimator {
  std::string name;
  double floor;  // smallest radius, texels; negative: it has none
  std::function<double(const Receiver&, std::size_t radius)> covered;
};

struct Training {
  TrainingSums penumbra{true}, all{false};
};

Training trained(Kind kind) {
  Training sums;
  Random random(kTrainingSeed + static_cast<std::uint32_t>(kind));
  for (int i = 0; i < kTraining; ++i) {
    const Receiver receiver = drawn(kind, random, 2, 24);
    sums.penumbra.add(receiver);
    sums.all.add(receiver);
  }
  return sums;
}

std::vector<Estimator> estimators(const Learned& own, const Learned& penumbra, const Learned& all) {
  std::vector<Estimator> estimators;
  const auto add = [&](const std::string& name, double floor, auto&& covered) {
    estimators.push_back({name, floor, covered});
  };
  const auto learned = [](const Learned& table) {
    return [&table](const Receiver& receiver, std::size_t radius) {
      return table.covered(receiver.place, receiver.texels.block(), radius);
    };
  };
  add("bilinear", -1.0,
      [](const Receiver& receiver, std::size_t) { return bilinear(receiver.place, receiver.texels); });
  for (const double floor : kKernels)
    add("disc", floor, [floor](const Receiver& receiver, std::size_t radius) {
      return disc_kernel(receiver.place, receiver.texels, std::max(kRadii[radius], floor));
    });
  for (const double floor : kShipped)
    add("shipped", floor, [floor](const Receiver& receiver, std::size_t) {
      return shipped_kernel(receiver.place, receiver.texels, floor);
    });
  add("edge", -1.0, [](const Receiver& receiver, std::size_t radius) {
    return fit_of_edge(receiver.place, receiver.texels, kRadii[radius],
                       std::max(kRadii[radius], kEdgeKernel));
  });
  add("mean edge", -1.0, [](const Receiver& receiver, std::size_t radius) {
    return mean_fit_of_edge(receiver.place, receiver.texels, kRadii[radius],
                            std::max(kRadii[radius], kEdgeKernel));
  });
  for (const int reach : {2, Texels::kReach})
    for (const double floor : {0.0, 0.5})
      add(fmt::format("revectorised {0} x {0}", 2 * reach), floor,
          [reach, floor](const Receiver& receiver, std::size_t radius) {
            return revectorised(receiver.place, receiver.texels, std::max(kRadii[radius], floor), reach);
          });
  add("learned of its kind", -1.0, learned(own));
  add("learned", -1.0, learned(penumbra));
  add("learned everywhere", -1.0, learned(all));
  return estimators;
}

Json errors_of(Kind kind, const std::vector<Estimator>& estimators) {
  struct OfRadius {
    Errors penumbra, all;
  };
  std::vector<std::array<OfRadius, kRadii.size()>> errors(estimators.size());
  Random random(kSeed + static_cast<std::uint32_t>(kind));
  for (int i = 0; i < kReceivers; ++i) {
    const Receiver receiver = drawn(kind, random, Texels::kReach, 64);
    for (std::size_t estimator = 0; estimator < estimators.size(); ++estimator)
      for (std::size_t radius = 0; radius < kRadii.size(); ++radius) {
        const double error = estimators[estimator].covered(receiver, radius) - receiver.covered[radius];
        errors[estimator][radius].all.add(error);
        if (receiver.in_penumbra(radius)) errors[estimator][radius].penumbra.add(error);
      }
  }
  const auto rounded = [](double value) { return std::round(1e5 * value) / 1e5; };
  Json records = Json::array();
  for (std::size_t estimator = 0; estimator < estimators.size(); ++estimator)
    for (std::size_t radius = 0; radius < kRadii.size(); ++radius) {
      const OfRadius& own = errors[estimator][radius];
      Json record = {{"shapes", name_of(kind)},
                     {"radius_texels", kRadii[radius]},
                     {"estimator", estimators[estimator].name}};
      if (estimators[estimator].floor >= 0.0) record["floor_texels"] = estimators[estimator].floor;
      record["rmse_penumbra"] = rounded(own.penumbra.rmse());
      record["half_penumbra"] = rounded(own.penumbra.half());
      record["receivers_penumbra"] = own.penumbra.count;
      record["rmse_all"] = rounded(own.all.rmse());
      record["half_all"] = rounded(own.all.half());
      records.push_back(std::move(record));
    }
  return records;
}

// Runs the task for each kind, on as many threads as the machine has.
template <class Task>
auto of_all_kinds(const Task& task) {
  std::vector<std::future<decltype(task(Kind::kEdges))>> results;
  for (const Kind kind : kKinds) results.push_back(std::async(std::launch::async, task, kind));
  std::vector<decltype(task(Kind::kEdges))> all;
  for (auto& result : results) all.push_back(result.get());
  return all;
}

Json run() {
  std::vector<Training> sums = of_all_kinds(trained);
  std::vector<Learned> own;
  Training sum;
  for (const Training& one : sums) {
    own.emplace_back(one.penumbra);
    sum.penumbra.add(one.penumbra);
    sum.all.add(one.all);
  }
  sums.clear();
  const Learned penumbra(sum.penumbra), all(sum.all);
  const std::vector<Json> of_kinds = of_all_kinds([&](Kind kind) {
    return errors_of(kind, estimators(own[static_cast<std::size_t>(kind)], penumbra, all));
  });
  Json records = Json::array();
  for (const Json& one : of_kinds) records.insert(records.end(), one.begin(), one.end());
  return {{"command", "penumbra_texel_errors FILE"},
          {"commit", platform::source_commit().value_or("")},
          {"receivers", kReceivers},
          {"trained", kTraining},
          {"records", std::move(records)}};
}

}  // namespace
}  // namespace penumbra::texel

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: penumbra_texel_errors FILE\n");
    return 2;
  }
  try {
    penumbra::platform::write_file_atomically(arguments[1],
                                              penumbra::json_lines(penumbra::texel::run().dump()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "penumbra_texel_errors: {}\n", error.what());
    return 1;
  }
  return 0;
}
