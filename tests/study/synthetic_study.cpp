#include "study/synthetic_study.h"

#include <algorithm>

#include "study/colour_map.h"

namespace penumbra::study::synthetic {
namespace {

Record record(const std::string& scene, const std::string& technique, double light, int rank) {
  Record record;
  record.scene = scene;
  record.technique = technique;
  record.title = "Title of " + technique;
  record.parameters = {{"samples", {4.0 * rank, 0.5}}, {"floor", {1.25}}};
  record.light_degrees = light;
  record.map_size = 2048;
  record.map_format = "D32";
  record.cascades = 4;
  record.settings.splits = {0.067, 0.2, 0.467};
  record.device = "made-up device";
  const double error = 0.25 / (rank + 1.0) + 0.01 * light + (scene == "fence" ? 0.02 : 0.0);
  Metrics& metrics = record.metrics;
  metrics.pixels = 129600;
  metrics.penumbra_pixels = 9000;
  metrics.seeds = 16;
  metrics.rmse_penumbra = error;
  metrics.rmse_all = error / 3.0;
  metrics.bias = -0.1 * error;
  metrics.variance = error * error / 7.0;
  metrics.p99 = 2.0 * error;
  metrics.max_error = 3.0 * error;
  metrics.leak_rate = 0.001;
  metrics.false_shadow_rate = 0.002;
  metrics.fetches_mean = 1.0 + 9.0 * rank;
  metrics.fetches_p95 = 2.0 + 15.0 * rank;
  metrics.fetches_penumbra_mean = 1.5 + 14.0 * rank;
  metrics.split = {ErrorShare{0.01, 0.05}, ErrorShare{-0.02, 0.06}, std::nullopt};
  metrics.intervals.rmse_penumbra = Interval{error - 0.003, error + 0.004, 0.0018};
  metrics.intervals.rmse_all = Interval{error / 3.0 - 0.002, error / 3.0 + 0.002, 0.001};
  metrics.intervals.leak_rate = Interval{0.0, 0.002, 0.0006};
  metrics.intervals.fetches_mean = Interval{1.0 + 9.0 * rank, 1.25 + 9.0 * rank, 0.125};
  record.time = Timing{1.0 / 3.0 + rank, 0.1};
  record.reference = {"ray-traced disc light", 1024, 0.004};
  return record;
}

MeasuredFrame frame(const std::string& scene, double light) {
  MeasuredFrame frame;
  frame.scene = scene;
  frame.light_degrees = light;
  frame.width = 480;
  frame.height = 270;
  frame.shadow_distance_metres = 40.0;
  return frame;
}

}  // namespace

Results results(const std::vector<std::string>& techniques) {
  Results results;
  results.library_version = "0.1.0";
  results.commit = "0123456789abcdef0123456789abcdef01234567";
  results.packages = {{"com.example.shadows", "17.0.3"}, {"com.example.core", std::nullopt}};
  results.command = "penumbra measure --seed 1";
  results.hardware = "made-up processor, 2 cores";
  results.device = "made-up device";
  results.driver = "made-up driver 1.2";
  for (const char* scene : {"boxes", "fence"}) {
    for (const double light : {0.53, 2.0}) results.frames.push_back(frame(scene, light));
    for (std::size_t rank = 0; rank < techniques.size(); ++rank) {
      for (const double light : {0.53, 2.0}) {
        results.records.push_back(record(scene, techniques[rank], light, static_cast<int>(rank)));
      }
    }
  }
  return results;
}

Results results() {
  return results({"bilinear", "tent-5x5", "pcss-24-16", "pcss-64-64"});
}

PictureRow picture_row(const std::string& scene, const std::string& technique) {
  constexpr std::size_t kWidth = 48;
  constexpr std::size_t kHeight = 24;
  const float edge = technique == "bilinear" ? 4.0F : 8.0F;  // pixels from 0 to 1
  std::vector<std::uint8_t> valid(kWidth * kHeight, 1);
  std::vector<float> reference(valid.size());
  std::vector<float> result(valid.size());
  std::vector<std::uint32_t> fetches(valid.size());
  for (std::size_t i = 0; i < valid.size(); ++i) {
    const auto x = static_cast<float>(i % kWidth);
    reference[i] = std::clamp((x - 16.0F) / 16.0F, 0.0F, 1.0F);
    result[i] = std::clamp((x - 20.0F) / edge, 0.0F, 1.0F);
    fetches[i] = x > 12.0F && x < 36.0F ? 40U : 4U;
    if (i < kWidth * 4) valid[i] = 0;  // these are sky
  }
  const PixelGrid grid{static_cast<int>(kWidth), static_cast<int>(kHeight), valid};
  PictureRow row{scene, technique, 2.0, {}, {}, {}, {}};
  row.reference = visibility_picture(grid, reference);
  row.result = visibility_picture(grid, result);
  row.error = error_picture(grid, result, reference, row.error_scale);
  row.fetches = fetch_picture(grid, fetches, row.fetch_scale);
  row.fetch_counts = count_picture(grid, fetches);
  return row;
}

ReportContent report_content() {
  ReportContent content;
  content.results = results();
  content.charts = report_charts(content.results);
  for (const char* scene : {"boxes", "fence"}) {
    for (const char* technique : {"bilinear", "pcss-24-16"}) {
      content.pictures.push_back(picture_row(scene, technique));
    }
  }
  return content;
}

}  // namespace penumbra::study::synthetic
