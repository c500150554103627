#include "study/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "reference/same_map_estimate.h"
#include "study/colour_map.h"
#include "study/metrics.h"

namespace penumbra::study {
namespace {

constexpr double kErrorScale = 0.5;
constexpr double kFetchScale = 128.0;

std::string map_format_name(scene::DepthFormat format) {
  switch (format) {
    case scene::DepthFormat::d16:
      return "D16";
    case scene::DepthFormat::d24:
      return "D24";
    case scene::DepthFormat::d32:
      break;
  }
  return "D32";
}

// Only receivers inside of the window count.
std::vector<std::uint8_t> counted_receivers(const reference::VisibilityImage& t1,
                                            const std::optional<PictureWindow>& window) {
  std::vector<std::uint8_t> counted = t1.valid;
  if (!window) return counted;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const int x = static_cast<int>(i) % t1.width;
    const int y = static_cast<int>(i) / t1.width;
    if (!window->contains(x, y)) counted[i] = 0;
  }
  return counted;
}

double fetches_of_others(const Answer& answer, int width, const std::optional<PictureWindow>& window) {
  if (!window || answer.fetches_of_others_at.empty()) return answer.fetches_of_others;
  double sum = 0.0;
  for (int y = window->y; y < window->y + window->height; ++y) {
    const auto row = answer.fetches_of_others_at.begin() + static_cast<std::ptrdiff_t>(y) * width + window->x;
    sum = std::accumulate(row, row + window->width, sum);
  }
  return sum / (static_cast<double>(window->width) * window->height);
}

// Returns the fetches of every pass at each pixel.
std::vector<std::uint32_t> all_fetches(const Answer& answer) {
  std::vector<std::uint32_t> all = answer.fetches;
  for (std::size_t i = 0; i < answer.fetches_of_others_at.size(); ++i) {
    all[i] += static_cast<std::uint32_t>(std::lround(answer.fetches_of_others_at[i]));
  }
  return all;
}

Picture mask_picture(const PixelGrid& grid, const std::vector<std::uint8_t>& masked_out) {
  std::vector<float> runs;
  runs.reserve(masked_out.size());
  for (const std::uint8_t left_out : masked_out) runs.push_back(left_out != 0 ? 0.0F : 1.0F);
  return visibility_picture(grid, runs);
}

RunSettings run_settings(const View& view) {
  const parameters::ShadowSettings& shadows = view.frame.settings.shadows;
  RunSettings settings;
  settings.depth_bias = shadows.depth_bias;
  settings.normal_bias = shadows.normal_bias;
  settings.soft_quality = shadows.soft_quality;
  settings.constant_bias = view.frame.settings.raster_bias.constant;
  settings.slope_bias = view.frame.settings.raster_bias.slope;
  settings.light_scale = view.request.light_scale;
  settings.reversed_z = shadows.reversed_z;
  settings.cascade_choices = view.request.cascade_choices;
  const std::array<double, 3> splits = parameters::effective_splits(shadows);
  settings.splits.assign(splits.begin(), splits.begin() + (shadows.cascades - 1));
  return settings;
}

// The figures are taken at the counted pixels, which have to outlive the result.
MeasuredImages images_of(const CaseSetup& setup, const Answer& answer,
                         std::span<const std::uint8_t> counted) {
  MeasuredImages images;
  images.width = setup.t1.width;
  images.t1 = setup.t1.visibility;
  images.valid = counted;
  for (const std::vector<float>& image : answer.visibility) images.results.emplace_back(image);
  images.fetches.emplace_back(answer.fetches);
  return images;
}

// Returns the cascade of each counted pixel, and -1 for the others.
std::vector<int> cascades_read(const std::vector<std::uint8_t>& counted, const CaseSetup& setup,
                               const scene::Frame& frame) {
  std::vector<int> result(counted.size(), -1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (counted[i] == 0) continue;
    const glm::dvec3 surface = setup.scene.origin + glm::dvec3(frame.receivers.position_relative[i]);
    const int cascade = reference::select_cascade(frame.cascades, surface);
    if (cascade < static_cast<int>(frame.cascades.cascades.size())) result[i] = cascade;
  }
  return result;
}

std::vector<std::uint8_t> readers(const std::vector<int>& cascades, int cascade) {
  std::vector<std::uint8_t> result;
  for (const int read : cascades) result.push_back(read == cascade ? 1 : 0);
  return result;
}

void name_rule(CascadeRecord& record, const Subject& subject, int cascade) {
  for (const techniques::CascadeRule& rule : subject.cascades) {
    if (rule.from > cascade) break;
    record.technique = rule.technique.empty() ? subject.name : rule.technique;
    record.parameters = rule.values;
  }
}

std::vector<CascadeRecord> per_cascade(const CaseSetup& setup, const View& view, const Subject& subject,
                                       const Answer& answer, const std::vector<int>& read) {
  std::vector<CascadeRecord> records;
  const auto cascades = static_cast<int>(view.frame.cascades.cascades.size());
  for (int cascade = 0; cascade < cascades; ++cascade) {
    const std::vector<std::uint8_t> reading = readers(read, cascade);
    const Metrics metrics = measure(images_of(setup, answer, reading));
    records.push_back({metrics.pixels, metrics.penumbra_pixels, metrics.rmse_penumbra, metrics.bias,
                       metrics.leak_rate, metrics.false_shadow_rate, metrics.fetches_mean,
                       metrics.intervals});
    name_rule(records.back(), subject, cascade);
    records.back().texel_size_metres =
        view.frame.cascades.cascades[static_cast<std::size_t>(cascade)].texel_size_metres;
  }
  return records;
}

// The limits from the camera are the last fifth before the shadow distance and the fourth part behind it,
// where far shadows take over from cascades, then octaves.
std::vector<double> distance_limits(double shadow_distance, double seen_distance) {
  std::vector<double> limits{0.0, 0.8 * shadow_distance, shadow_distance, 1.25 * shadow_distance};
  for (double limit = 2.0 * shadow_distance; limit < seen_distance; limit *= 2.0) limits.push_back(limit);
  limits.push_back(seen_distance);
  return limits;
}

double distance_of(const CaseSetup& setup, const scene::Frame& frame, std::size_t pixel) {
  return glm::distance(glm::dvec3(frame.receivers.position_relative[pixel]), setup.scene.camera.position);
}

std::vector<DistanceRecord> by_distance(const CaseSetup& setup, const View& view, const Answer& answer,
                                        const std::vector<std::uint8_t>& counted) {
  const std::vector<double> limits =
      distance_limits(setup.scene.shadow_distance_metres, setup.scene.seen_distance_metres);
  std::vector<DistanceRecord> records;
  for (std::size_t ring = 0; ring + 1 < limits.size(); ++ring) {
    std::vector<std::uint8_t> inside = counted;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (inside[i] == 0) continue;
      const double distance = distance_of(setup, view.frame, i);
      inside[i] = distance >= limits[ring] && distance < limits[ring + 1] ? 1 : 0;
    }
    const Metrics metrics = measure(images_of(setup, answer, inside));
    records.push_back({limits[ring], limits[ring + 1], metrics.pixels, metrics.penumbra_pixels,
                       metrics.rmse_penumbra, metrics.rmse_all, metrics.bias, metrics.leak_rate,
                       metrics.false_shadow_rate, metrics.fetches_mean});
  }
  return records;
}

// Returns 0 within the shadow distance, 1 beyond.
std::vector<int> sides_of_shadow_distance(const CaseSetup& setup, const View& view,
                                          const std::vector<std::uint8_t>& counted) {
  std::vector<int> sides(counted.size(), -1);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (counted[i] != 0)
      sides[i] = distance_of(setup, view.frame, i) < setup.scene.shadow_distance_metres ? 0 : 1;
  return sides;
}

Metrics metrics_of(const CaseSetup& setup, const View& view, const Answer& answer,
                   const std::vector<std::uint8_t>& counted, const std::optional<PictureWindow>& window,
                   const std::optional<reference::VisibilityImage>& unlimited) {
  MeasuredImages images = images_of(setup, answer, counted);
  images.preprocess_fetches_per_pixel = fetches_of_others(answer, setup.t1.width, window);
  images.masked_out = answer.masked_out;
  if (view.t2) {
    images.t2 = view.t2->visibility;
    images.t3 = unlimited ? std::span<const float>(unlimited->visibility) : images.results.front();
  }
  return measure(images);
}

PassRecord pass_record(const resolve::PassCounts& counts) {
  PassRecord record;
  record.pass = counts.pass;
  record.runs = techniques::name_of(counts.frequency);
  record.fetches_per_pixel = counts.fetches;
  record.texels_written_per_pixel = counts.texels_written;
  record.fetches_per_cascade = counts.fetches_per_cascade;
  record.operations_per_pixel = counts.operations;
  record.invocations_per_pixel = counts.invocations;
  record.bytes_read_per_pixel = counts.bytes_read;
  record.bytes_written_per_pixel = counts.bytes_written;
  (counts.groups ? record.dispatches : record.draws) = counts.steps;
  record.groups = counts.groups;
  record.barriers_per_group = counts.barriers_per_group;
  return record;
}

std::optional<Timing> timing_of(std::vector<double> nanoseconds) {
  for (double& time : nanoseconds) time *= 1e-6;
  return summarise(std::move(nanoseconds));
}

std::string reference_kind(int edge_samples) {
  return edge_samples == 0 ? "ray-traced disc light"
                           : fmt::format("ray-traced disc light, mean of {} samples at edges", edge_samples);
}

}  // namespace

MeasuredFrame measured_frame(const CaseSetup& setup) {
  const scene::Frame& frame = setup.views.front().frame;
  MeasuredFrame note;
  note.scene = setup.scene.name;
  note.light_degrees = setup.light_degrees;
  // The direction is that of the light of the case, whatever the age of the maps.
  note.sun_direction = glm::normalize(setup.scene.light_direction);
  note.width = setup.t1.width;
  note.height = setup.t1.height;
  note.shadow_distance_metres = frame.settings.shadows.distance_metres;
  note.camera = frame.camera;
  return note;
}

Record record_of(const CaseSetup& setup, const View& view, const Subject& subject, const Answer& answer,
                 const std::optional<PictureWindow>& window,
                 const std::optional<reference::VisibilityImage>& unlimited, const std::string& device) {
  Record record;
  record.scene = setup.scene.name;
  record.technique = subject.name;
  record.title = subject.title;
  record.parameters = subject.parameters;
  record.light_degrees = setup.light_degrees;
  record.map_size = view.frame.atlas.width;
  record.map_format = map_format_name(view.frame.atlas.format);
  record.cascades = std::max(1, static_cast<int>(view.frame.cascades.cascades.size()));
  record.settings = run_settings(view);
  record.device = device;
  const std::vector<std::uint8_t> counted = counted_receivers(setup.t1, window);
  record.metrics = metrics_of(setup, view, answer, counted, window, unlimited);
  if (!view.frame.cascades.cascades.empty()) {
    const std::vector<int> read = cascades_read(counted, setup, view.frame);
    const SeamImages images{setup.t1.width, read, setup.t1.visibility, answer.visibility.front()};
    record.group_step = group_step_of(images);
    if (record.cascades > 1) {
      record.per_cascade = per_cascade(setup, view, subject, answer, read);
      record.seam = seam_of(images);
    }
  }
  if (setup.scene.seen_distance_metres > setup.scene.shadow_distance_metres) {
    record.by_distance = by_distance(setup, view, answer, counted);
    const std::vector<int> sides = sides_of_shadow_distance(setup, view, counted);
    record.far_seam = seam_of({setup.t1.width, sides, setup.t1.visibility, answer.visibility.front(), true});
  }
  if (const std::vector<techniques::Need>& needs = subject.graph.graph.needs; !needs.empty())
    record.baked_mebibytes = baked_mebibytes(*setup.inputs, needs);
  if (!answer.passes.empty())
    record.operations_per_pixel =
        std::accumulate(answer.passes.begin(), answer.passes.end(), 0.0,
                        [](double sum, const resolve::PassCounts& pass) { return sum + pass.operations; });
  for (const resolve::PassCounts& pass : answer.passes) record.passes.push_back(pass_record(pass));
  if (answer.pass_times_ns.size() == record.passes.size())
    for (std::size_t i = 0; i < record.passes.size(); ++i)
      if (const std::optional<Timing> time = timing_of(answer.pass_times_ns[i]))
        record.passes[i].time_ms_median = time->median_ms;
  record.time = timing_of(answer.time_ns);
  record.reference = {reference_kind(setup.edge_samples), setup.t1.samples, setup.t1.noise_floor};
  return record;
}

OverlapRecord overlap_record(const CaseSetup& setup, const Answer& answer,
                             std::span<const std::uint8_t> overlaps) {
  const Metrics metrics = measure(images_of(setup, answer, overlaps));
  return {metrics.pixels, metrics.rmse_all, metrics.bias};
}

PictureRow pictures_of(const CaseSetup& setup, const Subject& subject, const Answer& answer) {
  const PixelGrid grid{setup.t1.width, setup.t1.height, setup.t1.valid};
  PictureRow row;
  row.scene = setup.scene.name;
  row.technique = subject.name;
  row.light_degrees = setup.light_degrees;
  row.reference = visibility_picture(grid, setup.t1.visibility);
  row.result = visibility_picture(grid, answer.visibility.front());
  row.error = error_picture(grid, answer.visibility.front(), setup.t1.visibility, kErrorScale);
  row.fetches = fetch_picture(grid, all_fetches(answer), kFetchScale);
  row.fetch_counts = count_picture(grid, all_fetches(answer));
  if (!answer.masked_out.empty()) row.mask = mask_picture(grid, answer.masked_out);
  row.error_scale = kErrorScale;
  row.fetch_scale = kFetchScale;
  return row;
}

}  // namespace penumbra::study
