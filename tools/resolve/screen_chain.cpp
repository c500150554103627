#include "resolve/screen_chain.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "resolve/screen_uniforms.h"
#include "resolve/texel_counter.h"
#include "shaders/counted_module.h"

namespace penumbra::resolve {
namespace {

int rounded_up(int size, int scale) {
  return (size + scale - 1) / scale;
}

double sum(const std::vector<std::uint32_t>& counts) {
  double total = 0.0;
  for (const std::uint32_t count : counts) total += count;
  return total;
}

// Per pixel of the screen, rows from the top: what `of` says of the texel of a smaller image that covers it.
template <typename Texel, typename Of>
auto at_each_pixel(const std::vector<Texel>& texels, int width, int scale, const CameraImage& camera, Of of) {
  std::vector<decltype(of(texels.front()))> pixels;
  pixels.reserve(camera.depth.size());
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      pixels.push_back(of(texels[static_cast<std::size_t>(y / scale) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x / scale)]));
    }
  }
  return rows_from_top(pixels, camera.width, camera.rows);
}

// Whether the mask is 0 there.
std::vector<std::uint8_t> masked_out(const gpu::Image& mask, int scale, const CameraImage& camera) {
  return at_each_pixel(mask.download<float>(), mask.width(), scale, camera,
                       [](float texel) { return static_cast<std::uint8_t>(texel == 0.0f ? 1 : 0); });
}

void add(std::vector<float>& sums, const std::vector<float>& terms) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += terms[i];
}

}  // namespace

// One image per step, kept for a run, and of counting passes the counts.
struct ScreenChain::Targets {
  Targets(const gpu::Device& device, const ScreenChainDescription& description,
          const FrameOnDevice& on_device, const CameraImage& camera_image, ScreenPass::Module module)
      : frame(on_device),
        camera(camera_image),
        depth(device, gpu::Format::r32f, camera_image.width, camera_image.height) {
    depth.upload(camera.depth);
    for (const ScreenStep& step : description.steps) {
      images.emplace_back(device, ScreenPass::target_format(module), rounded_up(camera.width, step.scale),
                          rounded_up(camera.height, step.scale));
      if (module == ScreenPass::Module::counting)
        counters.emplace_back(device, images.back().width(), images.back().height());
    }
  }

  const FrameOnDevice& frame;
  const CameraImage& camera;
  gpu::Image depth;
  std::vector<gpu::Image> images;
  std::vector<TexelCounter> counters;
};

ScreenChain::ScreenChain(const gpu::Device& device, const shaders::PackageShader& shader,
                         ScreenChainDescription description, bool reversed_z,
                         const platform::WorkerPool& process)
    : device_(device), description_(std::move(description)) {
  if (description_.steps.empty() || description_.steps.back().scale != 1) {
    throw std::invalid_argument("a chain ends in a step at full resolution");
  }
  for (const ScreenStep& step : description_.steps) {
    const CompiledScreenPass compiled =
        compile(shader, step.pass, description_.keywords, reversed_z, process);
    plain_.emplace_back(device, compiled, ScreenPass::Module::as_shipped);
    counting_.emplace_back(device, compiled, ScreenPass::Module::counting);
  }
}

double ScreenChain::draw(std::vector<ScreenPass>& passes, Targets& targets, int seed) {
  UniformValues values = targets.frame.uniforms(seed);
  values.merge(description_.parameters);
  set_screen(values, targets.camera);
  ScreenResources resources{targets.frame.images(), targets.frame.samplers()};
  resources.images["_CameraDepthTexture"] = &targets.depth;
  double nanoseconds = 0.0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const gpu::Image& target = targets.images[i];
    const int source = description_.steps[i].source;
    values.set("_PenumbraTargetSize", texture_size(target));
    if (source >= 0) {
      const gpu::Image& read = targets.images.at(static_cast<std::size_t>(source));
      resources.images["_PenumbraSourceTexture"] = &read;
      values.set("_PenumbraSourceSize", texture_size(read));
    }
    if (!targets.counters.empty())
      resources.buffers[shaders::texel_counts_name] = &targets.counters[i].buffer();
    nanoseconds += passes[i].draw(target, resources, values);
    if (static_cast<int>(i) == description_.mask) resources.images["_PenumbraMaskTexture"] = &target;
  }
  return nanoseconds;
}

ScreenChainResult ScreenChain::run(const FrameOnDevice& frame, const CameraImage& camera,
                                   const ResolveOptions& options) {
  const double pixels = static_cast<double>(camera.width) * camera.height;
  ScreenChainResult result;
  Targets plain(device_, description_, frame, camera, ScreenPass::Module::as_shipped);
  const int seeds = description_.uses_noise ? std::max(1, options.noise_seeds) : 1;
  for (int seed = 0; seed < seeds; ++seed) {
    draw(plain_, plain, options.first_seed + seed);
    result.image.visibility.push_back(
        rows_from_top(plain.images.back().download<float>(), camera.width, camera.rows));
  }
  for (int repeat = 0; repeat < options.timing_repeats; ++repeat) {
    result.image.time_ns.push_back(draw(plain_, plain, 0));
  }
  if (description_.mask >= 0) {
    const gpu::Image& mask = plain.images.at(static_cast<std::size_t>(description_.mask));
    result.masked_out =
        masked_out(mask, description_.steps.at(static_cast<std::size_t>(description_.mask)).scale, camera);
  }
  std::set<std::string> unset;
  for (const ScreenPass& pass : plain_) {
    for (const std::string& name : pass.unset_uniforms()) unset.insert(name);
  }
  result.image.unset_uniforms.assign(unset.begin(), unset.end());
  if (!options.count_fetches) return result;

  Targets counted(device_, description_, frame, camera, ScreenPass::Module::counting);
  draw(counting_, counted, 0);
  result.image.fetches.assign(camera.depth.size(), 0);
  result.fetches_of_others_at.assign(camera.depth.size(), 0.0f);
  for (std::size_t i = 0; i < counting_.size(); ++i) {
    const auto [counts, written] = counted.counters[i].counts();
    const int width = counted.images[i].width();
    const int scale = description_.steps[i].scale;
    result.fetches.push_back(sum(counts) / pixels);
    result.texels_written.push_back(sum(written) / pixels);
    if (scale == 1) {
      const std::vector<std::uint32_t> rows = rows_from_top(counts, width, camera.rows);
      for (std::size_t pixel = 0; pixel < rows.size(); ++pixel) result.image.fetches[pixel] += rows[pixel];
    } else {
      result.fetches_of_others += result.fetches.back();
      const auto share = [scale](std::uint32_t count) {
        return static_cast<float>(count) / static_cast<float>(scale * scale);
      };
      add(result.fetches_of_others_at, at_each_pixel(counts, width, scale, camera, share));
    }
  }
  return result;
}

}  // namespace penumbra::resolve
