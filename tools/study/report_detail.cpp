#include "study/report_detail.h"

#include <fmt/format.h>

#include <optional>

#include "study/html_text.h"

namespace penumbra::study {
namespace {

// Terms and what they are, under one heading. Absent figures are not added.
class Group {
 public:
  explicit Group(std::string title) : title_(std::move(title)) {}

  void add_text(const std::string& term, const std::string& text) {
    entries_ += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(term), escape_html(text));
  }

  void add(const char* term, const std::optional<double>& value, const char* format, double scale = 1.0) {
    if (value) add_text(term, fmt::format(fmt::runtime(format), *value * scale));
  }

  std::string html(const std::string& id = {}) const {
    if (entries_.empty()) return {};
    const std::string name = id.empty() ? "" : " id=\"" + id + "\"";
    return "<div class=\"group\"" + name + "><h4>" + escape_html(title_) + "</h4>\n<dl>\n" + entries_ +
           "</dl></div>\n";
  }

 private:
  std::string title_;
  std::string entries_;
};

std::string about(const Record& record, const std::string& id) {
  Group group(record.title.empty() ? record.technique : record.title);
  for (const auto& [name, values] : record.parameters) {
    group.add_text(name, fmt::format("{}", fmt::join(values, " ")));
  }
  group.add_text("shadow map",
                 fmt::format("{} texels wide, {}, {} cascade{}", record.map_size, record.map_format,
                             record.cascades, record.cascades == 1 ? "" : "s"));
  return group.html(id);
}

std::string errors(const Metrics& metrics) {
  Group group("Error");
  group.add("bias", metrics.bias, "{:+.4f}");
  group.add("variance over seeds", metrics.variance, "{:.5f}");
  group.add("99th percentile", metrics.p99, "{:.3f}");
  group.add("largest", metrics.max_error, "{:.3f}");
  return group.html();
}

std::string split(const ErrorSplit& split) {
  Group group("Where the error comes from");
  const auto add = [&group](const char* term, const std::optional<ErrorShare>& share) {
    if (share) group.add_text(term, fmt::format("mean {:+.4f}, RMSE {:.4f}", share->mean, share->rmse));
  };
  add("map", split.map);
  add("algorithm", split.algorithm);
  add("sampling", split.sampling);
  return group.html();
}

std::string fetches(const Metrics& metrics) {
  Group group("Fetches per pixel");
  group.add("of the shadow function", metrics.fetches_mean, "{:.1f}");
  group.add("95th percentile", metrics.fetches_p95, "{:.0f}");
  group.add("in penumbra", metrics.fetches_penumbra_mean, "{:.1f}");
  if (metrics.preprocess_fetches_per_pixel > 0.0) {
    group.add("of passes at lower resolution", metrics.preprocess_fetches_per_pixel, "{:.2f}");
  }
  if (metrics.mask) {
    group.add("pixels the mask spares, %", metrics.mask->pixels_saved, "{:.1f}", 100.0);
    group.add("penumbra it misses, %", metrics.mask->penumbra_pixels_missed, "{:.2f}", 100.0);
  }
  return group.html();
}

std::string motion(const Record& record) {
  Group group("Shimmer");
  if (!record.shimmer) return {};
  group.add("static noise", record.shimmer->static_noise, "{:.4f}");
  group.add("noise of each frame", record.shimmer->per_frame_noise, "{:.4f}");
  return group.html();
}

std::string provenance(const Results& results, const Record& record) {
  const Metrics& metrics = record.metrics;
  Group group("Measured on");
  group.add_text("pixels", fmt::format("{}", metrics.pixels));
  group.add_text("noise seeds", fmt::format("{}", metrics.seeds));
  if (metrics.invalid > 0) group.add_text("invalid results", fmt::format("{}", metrics.invalid));
  if (record.time) {
    group.add_text(
        std::string(time_kind(results)),
        fmt::format("{:.2f} ms, spread {:.2f} ms", record.time->median_ms, record.time->spread_ms));
  }
  group.add_text("reference", fmt::format("{}, {} rays per pixel, noise floor {:.4f}", record.reference.kind,
                                          record.reference.samples, record.reference.noise_floor));
  return group.html();
}

}  // namespace

std::string record_detail(const Results& results, const Record& record, const std::string& about_id) {
  return "<div class=\"groups\">\n" + about(record, about_id) + errors(record.metrics) +
         split(record.metrics.split) + fetches(record.metrics) + motion(record) +
         provenance(results, record) + "</div>\n";
}

}  // namespace penumbra::study
