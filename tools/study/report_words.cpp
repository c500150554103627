#include "study/report_words.h"

#include <utility>

namespace penumbra::study {
namespace {

using Entry = std::pair<const char*, const char*>;

template <std::size_t Count>
std::string definition_list(const Entry (&entries)[Count]) {
  std::string html = "<dl class=\"words\">\n";
  for (const auto& [term, meaning] : entries) {
    html += std::string("<dt>") + term + "</dt><dd>" + meaning + "</dd>\n";
  }
  return html + "</dl>\n";
}

}  // namespace

std::string reference_definitions_html() {
  constexpr Entry kEntries[] = {
      {"T1: ray tracing",
       "Rays from each pixel's surface point to points spread over the light's disc, on the real geometry. "
       "All "
       "errors are taken against T1. Its own noise floor is the RMSE between two independent T1 images over "
       "the "
       "penumbra, divided by √2: a difference below it means nothing."},
      {"T2: the same map, exhaustively",
       "Every texel of the shadow map taken as a square at its stored depth, projected back onto the light, "
       "and "
       "the union of what it hides. A defined estimate from what the map holds: a reference, not a bound. A "
       "technique may be better."},
      {"T3: the technique, unlimited",
       "The technique's own function with so many samples that more change nothing."},
      {"Error split",
       "Per pixel, with its sign: map T2 − T1, algorithm T3 − T2, sampling result − T3. The three add up "
       "to the error, and their means to the bias. Their RMSEs do not add up and must not be subtracted: the "
       "shares are correlated."},
  };
  return definition_list(kEntries);
}

std::string metric_definitions_html() {
  constexpr Entry kEntries[] = {
      {"Visibility", "1 where the whole light disc is seen, 0 where none of it is."},
      {"Pixels",
       "Only pixels that show a surface within the shadow distance. By T1: umbra below 0.02, penumbra "
       "between 0.02 and 0.98, lit above 0.98."},
      {"RMSE penumbra", "Root of the mean squared error against T1, over penumbra pixels and noise seeds."},
      {"RMSE all", "The same over all pixels."},
      {"Bias", "Mean of result − T1 over penumbra pixels and seeds. Above 0: too bright."},
      {"Variance",
       "Sample variance (n − 1) over the noise seeds, averaged over penumbra pixels: the noise a "
       "temporal filter would have to remove."},
      {"p99", "99th percentile (nearest rank) of the absolute error in penumbra."},
      {"Max", "Largest absolute error of any pixel and seed, penumbra or not."},
      {"Leak", "Share of umbra results above 0.1: light where there is none."},
      {"False shadow", "Share of lit results below 0.9: shadow where there is none."},
      {"Fetches",
       "Counted in the shader itself: a load, a gather, a bilinear or bilinear-compare sample counts "
       "one. Mean and 95th percentile over all pixels, mean over penumbra pixels; preparation is what "
       "passes over the map or the screen add per pixel."},
      {"Time",
       "Median of a frame and the distance between its quartiles. On a software device it is the time of "
       "a processor and says little about a graphics card: it ranks nothing here."},
      {"Invalid",
       "Results that are no number or outside [0, 1]. They are findings, and enter no other figure."},
      {"–", "No pixel to measure on, or not measured. Not zero."},
  };
  return definition_list(kEntries);
}

}  // namespace penumbra::study
