// The mean of the visibility over frames: against the same mean in C++ at rest, in motion, and where history
// must not count.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "resolve/drawn_scenes.h"
#include "resolve/kept_runners.h"
#include "resolve/run_once.h"

namespace penumbra::resolve {
namespace {

using Picture = std::vector<float>;

// Frames of one scene, oldest first, with the cameras that see them.
class Frames {
 public:
  void add(const scene::Frame& frame) {
    on_device_.emplace_back(test_device(), frame);
    cameras_.push_back(camera_image(frame));
  }
  const FrameOnDevice& last() const { return on_device_.back(); }
  CameraImage& camera(std::size_t i) { return cameras_[i]; }
  const CameraImage& last_camera() const { return cameras_.back(); }
  RunOptions options() const {
    RunOptions options = kOnce;
    for (std::size_t i = 0; i + 1 < on_device_.size(); ++i)
      options.earlier.push_back({&on_device_[i], &cameras_[i]});
    return options;
  }

 private:
  std::deque<FrameOnDevice> on_device_;
  std::deque<CameraImage> cameras_;
};

// A picture's neighbours of the mean, two pixels away, and itself.
Picture around(const Picture& picture, int width, int x, int y) {
  const int height = static_cast<int>(picture.size()) / width;
  Picture found;
  for (int row = y - 2; row <= y + 2; row += 2)
    for (int column = x - 2; column <= x + 2; column += 2)
      found.push_back(picture[static_cast<std::size_t>(std::clamp(row, 0, height - 1) * width +
                                                       std::clamp(column, 0, width - 1))]);
  return found;
}

bool is_uniform(const Picture& values) {
  return std::all_of(values.begin(), values.end(), [&](float value) { return value == values.front(); });
}

// Whether the picture is in penumbra around the pixel, and bends by less than noise does.
bool is_smooth(const Picture& values) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::abs(0.5F * (values[i] + values[8 - i]) - values[4]) > 0.03F) return false;
  return values[4] > 0.05F && values[4] < 0.95F;
}

double rms_in_smooth_penumbrae(const Picture& a, const Picture& b, const Picture& reference, int width) {
  double squares = 0.0, count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int at = static_cast<int>(i);
    if (!is_smooth(around(reference, width, at % width, at / width))) continue;
    squares += (static_cast<double>(a[i]) - b[i]) * (static_cast<double>(a[i]) - b[i]);
    ++count;
  }
  EXPECT_GT(count, 500.0);
  return std::sqrt(squares / count);
}

class Accumulation : public testing::TestWithParam<bool> {
 protected:
  static GraphRunner& runner(const std::string& technique) {
    static KeptRunners runners;
    return runners.of(technique, GetParam(), [&] { return library_graph(technique, GetParam()); });
  }

  static scene::Frame frame(double degrees = 5.0) {
    return under_disc(drawn("street", 4, GetParam()), degrees);
  }

  // The picture moves to the left by so many pixels in each frame, and rests at the scene's own place.
  static Frames moving(int count, double pixels, double degrees) {
    scene::Rasteriser rasteriser(test_device(), street());
    Frames frames;
    for (int k = count - 1; k >= 0; --k) {
      scene::FrameSettings settings = frame(degrees).settings;
      settings.lens_shift.x -= k * pixels * 2.0 / settings.width;
      frames.add(rasteriser.frame(settings));
    }
    return frames;
  }

  static const scene::Scene& street() {
    static const scene::Scene scene = scene::built_in("street");
    return scene;
  }

  static Picture accumulated(const Frames& frames, int seed = 0) {
    RunOptions options = frames.options();
    options.first_seed = seed;
    return runner("screen-medium-accumulated")
        .run(frames.last(), &frames.last_camera(), options)
        .visibility[0];
  }

  // What the chain gives in the last frame, with the noise that the last of so many frames has.
  static Picture source(const Frames& frames, int seed = 0) {
    const int count = static_cast<int>(frames.options().earlier.size()) + 1;
    RunOptions options = kOnce;
    options.first_seed = (seed + 1) * count - 1;
    return runner("preset-medium").run(frames.last(), &frames.last_camera(), options).visibility[0];
  }

  static Picture mean_of_noise(const Frames& frames) {
    RunOptions options = kOnce;
    options.noise_seeds = 64;
    const auto pictures =
        runner("preset-medium").run(frames.last(), &frames.last_camera(), options).visibility;
    Picture mean(pictures[0].size());
    for (const Picture& picture : pictures)
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += picture[i] / 64.0F;
    return mean;
  }
};

TEST_P(Accumulation, TheFirstFrameIsItsSource) {
  Frames frames;
  frames.add(frame());
  EXPECT_EQ(accumulated(frames), source(frames));
}

// At rest a pixel's history is its own: the mean in C++, from the pictures of the single frames.
TEST_P(Accumulation, AtRestItIsTheMeanOfItsFrames) {
  constexpr int kFrames = 12;
  Frames frames;
  for (int i = 0; i < kFrames; ++i) frames.add(frame());
  RunOptions options = kOnce;
  options.noise_seeds = kFrames;
  const auto pictures = runner("preset-medium").run(frames.last(), &frames.last_camera(), options).visibility;
  const int width = frames.last_camera().width;
  Picture mean = pictures[0];
  std::vector<int> count(mean.size(), 0);
  for (int n = 0; n < kFrames; ++n) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
      const auto near = around(pictures[n], width, x, y);
      const double here = pictures[n][i];
      if (is_uniform(near)) {
        mean[i] = pictures[n][i];
        count[i] = 0;
        continue;
      }
      double sum = 0.0, squares = 0.0;
      for (const float value : near) {
        sum += value / 9.0;
        squares += static_cast<double>(value) * value / 9.0;
      }
      const double reach = 1.5 * std::sqrt(std::max(squares - sum * sum, 0.0));
      const double limited =
          std::clamp(static_cast<double>(mean[i]), std::min(sum - reach, here), std::max(sum + reach, here));
      count[i] = std::min(count[i] + 1, 8);
      mean[i] = static_cast<float>(limited + (here - limited) / count[i]);
    }
  }
  const Picture shown = accumulated(frames);
  std::size_t apart = 0;
  for (std::size_t i = 0; i < mean.size(); ++i)
    if (std::abs(shown[i] - mean[i]) > 2e-3F) ++apart;  // history is rounded to 12 bits in each frame
  EXPECT_LT(apart, mean.size() / 1000);
}

// Noise is what differs from one run to the next. Within wide penumbrae there is less of it, and less error
// against the mean of many frames.
TEST_P(Accumulation, ThereIsLessNoiseAtRestAndInMotion) {
  for (const double pixels : {0.0, 0.5, 1.3}) {
    const Frames frames = moving(16, pixels, 20.0);
    const Picture mean = mean_of_noise(frames);
    const auto rms = [&](const Picture& a, const Picture& b) {
      return rms_in_smooth_penumbrae(a, b, mean, frames.last_camera().width);
    };
    const double share = pixels == 0.0 ? 0.5 : 0.8;
    EXPECT_GT(rms(source(frames, 0), source(frames, 1)), 0.005) << "only a test with noise";
    EXPECT_LT(rms(accumulated(frames, 0), accumulated(frames, 1)),
              share * rms(source(frames, 0), source(frames, 1)))
        << pixels;
    EXPECT_LT(rms(accumulated(frames, 0), mean), share * rms(source(frames, 0), mean)) << pixels;
  }
}

// The sun jumps: what was dark stays dark nowhere but within the noise of this frame.
TEST_P(Accumulation, NoShadowStaysWhereItWas) {
  scene::Scene moved = street();
  moved.light_direction = glm::normalize(moved.light_direction + glm::dvec3(0.35, 0.0, 0.2));
  scene::Rasteriser before(test_device(), moved);
  Frames frames;
  const scene::Frame now = frame();
  for (int i = 0; i < 8; ++i) frames.add(before.frame(now.settings));
  frames.add(now);
  const Picture mean = accumulated(frames), single = source(frames);
  const int width = frames.last_camera().width;
  std::size_t uniform = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const auto near = around(single, width, static_cast<int>(i) % width, static_cast<int>(i) / width);
    if (is_uniform(near)) {
      ++uniform;
      EXPECT_EQ(mean[i], single[i]) << i;
    } else {
      const auto [least, most] = std::minmax_element(near.begin(), near.end());
      EXPECT_GE(mean[i], *least - 0.5F * (*most - *least) - 1e-3F) << i;
      EXPECT_LE(mean[i], *most + 0.5F * (*most - *least) + 1e-3F) << i;
    }
  }
  EXPECT_GT(uniform, mean.size() / 4);
  EXPECT_LT(uniform, mean.size());
}

// In the frames before, everything was a fifth nearer or further away: other surfaces were seen there.
TEST_P(Accumulation, OtherSurfacesHaveNoHistory) {
  for (const float share : {0.8F, 1.25F}) {
    Frames frames;
    for (int i = 0; i < 5; ++i) frames.add(frame());
    for (std::size_t i = 0; i < 4; ++i)
      for (float& depth : frames.camera(i).depth)
        depth = GetParam() ? std::min(depth * share, 1.0F) : std::max(1.0F - (1.0F - depth) * share, 0.0F);
    EXPECT_EQ(accumulated(frames), source(frames)) << share;
  }
}

INSTANTIATE_TEST_SUITE_P(BothDirections, Accumulation, testing::Bool(), direction_name);

}  // namespace
}  // namespace penumbra::resolve
