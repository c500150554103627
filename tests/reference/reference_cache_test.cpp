#include "reference/reference_cache.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "input/input_error.h"
#include "reference/hand_built.h"
#include "reference/scratch_folder.h"
#include "reference/trace_visibility.h"

namespace penumbra::reference {
namespace {

const std::string key = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef";

VisibilityImage some_image(float value = 0.25F) {
  return {3, 2, {0.0F, value, 0.5F, 0.75F, 1.0F, 0.125F}, {1, 1, 0, 1, 1, 1}, 0.003, 1024};
}

std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write(const std::filesystem::path& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

TEST(ReferenceCache, GivesBackWhatWasStored) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path() / "made" / "on demand");
  EXPECT_FALSE(cache.find(key).has_value());
  cache.store(key, some_image());
  EXPECT_EQ(cache.find(key), some_image());
  EXPECT_FALSE(cache.find("other").has_value());
}

TEST(ReferenceCache, EveryTruncationReadsAsAbsent) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  cache.store(key, some_image());
  const std::string whole = read(cache.image_file(key));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    write(cache.image_file(key), whole.substr(0, length));
    EXPECT_FALSE(cache.find(key).has_value()) << length << " of " << whole.size() << " bytes";
  }
  write(cache.image_file(key), whole + " ");
  EXPECT_FALSE(cache.find(key).has_value()) << "a byte too many";
  cache.store(key, some_image());
  EXPECT_EQ(cache.find(key), some_image());
}

TEST(ReferenceCache, EveryDamagedByteIsNoticed) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  cache.store(key, some_image());
  const std::string whole = read(cache.image_file(key));
  for (std::size_t place = 0; place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    write(cache.image_file(key), damaged);
    EXPECT_FALSE(cache.find(key).has_value()) << "byte " << place;
  }
}

// The entry has a right hash, as somebody who can write the folder can make one.
TEST(ReferenceCache, WhatIsNoVisibilityReadsAsAbsent) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  for (const float share : {-0.1F, 1.1F, std::numeric_limits<float>::quiet_NaN()}) {
    cache.store(key, some_image(share));
    EXPECT_FALSE(cache.find(key).has_value()) << share;
  }
  for (const double noise : {-1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
    VisibilityImage image = some_image();
    image.noise_floor = noise;
    cache.store(key, image);
    EXPECT_FALSE(cache.find(key).has_value()) << noise;
  }
}

TEST(ReferenceCache, AnEntryUnderAnotherNameIsNotBelieved) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  cache.store(key, some_image());
  const std::string another(key.rbegin(), key.rend());
  std::filesystem::create_directories(cache.image_file(another).parent_path());
  std::filesystem::copy_file(cache.image_file(key), cache.image_file(another));
  EXPECT_FALSE(cache.find(another).has_value());
}

TEST(ReferenceCache, WhatCannotBeWrittenIsNotKept) {
  const ScratchFolder folder;
  write(folder.path() / "file", "in the way");
  const ReferenceCache cache(folder.path() / "file" / "below");
  EXPECT_FALSE(cache.find(key).has_value());
  EXPECT_FALSE(cache.store(key, some_image()));
  EXPECT_EQ(read(folder.path() / "file"), "in the way");
}

TEST(ReferenceCache, AFolderInPlaceOfAnEntryIsNoEntry) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  std::filesystem::create_directories(cache.image_file(key));
  EXPECT_FALSE(cache.find(key).has_value());
  EXPECT_FALSE(cache.store(key, some_image()));
  EXPECT_TRUE(std::filesystem::is_directory(cache.image_file(key)));
}

// Four processes write two images in turn while this one reads: every read is one of them, whole, or absent.
TEST(ReferenceCache, ProcessesMayShareADirectory) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  std::vector<pid_t> writers;
  for (int writer = 0; writer < 4; ++writer) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      try {
        for (int round = 0; round < 25; ++round) cache.store(key, some_image(round % 2 == 0 ? 0.25F : 0.75F));
      } catch (...) {
        ::_exit(1);
      }
      ::_exit(0);
    }
    writers.push_back(child);
  }
  int running = 4;
  bool seen = false;
  while (running > 0) {
    const std::optional<VisibilityImage> image = cache.find(key);
    if (image) {
      EXPECT_TRUE(*image == some_image(0.25F) || *image == some_image(0.75F));
      seen = true;
    } else {
      EXPECT_FALSE(seen) << "an entry once there is never seen broken";
    }
    int status = 0;
    const pid_t ended = ::waitpid(-1, &status, WNOHANG);
    if (ended > 0) {
      EXPECT_EQ(status, 0);
      --running;
    }
  }
  EXPECT_TRUE(cache.find(key).has_value());
  const auto entry = cache.image_file(key).parent_path();
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(entry), {}), 1) << "no temporary file is left";
}

TEST(ReferenceCache, EveryInputOfATraceIsInItsKey) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  const hand_built::Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-9.0, 0.0, -9.0, 9.0}, 3.0);
  const scene::Receivers receivers =
      hand_built::receivers(setting, {4, 4}, [](int x, int y) { return glm::dvec2(0.02 * x, 0.1 * y); });
  int runs = 0;
  RunOptions run;
  run.progress = [&](double done, double) { runs += done == 0.0 ? 1 : 0; };
  const auto runs_for = [&](const scene::Scene& shown, const scene::Receivers& seen,
                            const parameters::Light& light, const TraceOptions& options) {
    runs = 0;
    trace_visibility(shown, seen, light, options, run, &cache);
    return runs;
  };
  EXPECT_EQ(runs_for(scene, receivers, setting.light, {}), 1);
  EXPECT_EQ(runs_for(scene, receivers, setting.light, {}), 0) << "kept";
  EXPECT_EQ(runs_for(scene, receivers, setting.light, {2048, 1}), 1);
  EXPECT_EQ(runs_for(scene, receivers, setting.light, {1024, 2}), 1);
  parameters::Light light = setting.light;
  light.angular_diameter_degrees += 1e-9;
  EXPECT_EQ(runs_for(scene, receivers, light, {}), 1);
  light = setting.light;
  light.direction.x += 1e-12;
  EXPECT_EQ(runs_for(scene, receivers, light, {}), 1);
  scene::Scene moved = scene;
  moved.mesh.positions[0].x += 1e-3F;
  EXPECT_EQ(runs_for(moved, receivers, setting.light, {}), 1);
  moved = scene;
  std::swap(moved.mesh.indices[0], moved.mesh.indices[1]);
  EXPECT_EQ(runs_for(moved, receivers, setting.light, {}), 1);
  scene::Receivers elsewhere = receivers;
  elsewhere.position_relative[5].z += 1e-4F;
  EXPECT_EQ(runs_for(scene, elsewhere, setting.light, {}), 1);
  elsewhere = receivers;
  elsewhere.normal_ws[5] *= 0.999F;
  EXPECT_EQ(runs_for(scene, elsewhere, setting.light, {}), 1);
  EXPECT_EQ(runs_for(scene, receivers, setting.light, {}), 0) << "still kept";
}

TEST(ReferenceCache, ADamagedTraceIsTracedAgain) {
  const ScratchFolder folder;
  const ReferenceCache cache(folder.path());
  const hand_built::Setting setting;
  scene::Scene scene;
  hand_built::add_rectangle(scene.mesh, setting, {-9.0, 0.0, -9.0, 9.0}, 3.0);
  const scene::Receivers receivers =
      hand_built::receivers(setting, {4, 4}, [](int x, int y) { return glm::dvec2(0.02 * x, 0.1 * y); });
  const VisibilityImage first = trace_visibility(scene, receivers, setting.light, {}, {}, &cache);
  const std::filesystem::path part = std::filesystem::directory_iterator(folder.path())->path();
  const std::filesystem::path entry = std::filesystem::directory_iterator(part)->path();
  const std::string whole = read(entry);
  write(entry, whole.substr(0, whole.size() / 2));
  EXPECT_EQ(trace_visibility(scene, receivers, setting.light, {}, {}, &cache), first);
  EXPECT_EQ(read(entry), whole) << "and the entry is mended";
}

}  // namespace
}  // namespace penumbra::reference
