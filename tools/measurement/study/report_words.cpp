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
       "All errors are differences from T1. Its noise floor is half the RMS difference, over the penumbra, "
       "between "
       "the visibilities by either half of its rays: differences below it are not significant."},
      {"T2: all the information in the shadow map",
       "Every texel of the shadow map is taken as a square at its stored depth and projected onto the light; "
       "T2 is the part of the light that no texel covers. It is an estimate from what the map contains, not "
       "a bound: a technique may be better."},
      {"T3: the technique without a sample limit",
       "The technique's own function with so many samples that more would not change the result."},
      {"Error split",
       "Per pixel, with its sign: map T2 − T1, algorithm T3 − T2, sampling result − T3. The three add up "
       "to the error, and their means to the bias. Their RMSEs do not add up and must not be subtracted: the "
       "shares are correlated."},
  };
  return definition_list(kEntries);
}

std::string metric_definitions_html() {
  constexpr Entry kEntries[] = {
      {"Visibility", "1 where the whole disc of the light is visible, 0 where none of it is."},
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
      {"Leak", "Share of umbra results above 0.1: light where there should be full shadow."},
      {"False shadow", "Share of fully lit results below 0.9: shadow where there should be none."},
      {"Fetches",
       "Counted in the shader itself: a load, a gather, a bilinear sample and a bilinear comparison sample "
       "count as one each. Mean and 95th percentile are over all pixels, the mean in penumbra is over "
       "penumbra pixels. Passes at lower resolution are counted separately, per pixel of the picture."},
      {"Time",
       "Median time of a frame and the distance between the quartiles. On a software device it is CPU time "
       "and says little about a GPU; do not rank techniques by it."},
      {"Invalid",
       "Results that are NaN, infinite or outside [0, 1]. They are reported as findings and left out of all "
       "other figures."},
      {"–", "Not measured, or there is no pixel to measure. It does not mean zero."},
  };
  return definition_list(kEntries);
}

}  // namespace penumbra::study
