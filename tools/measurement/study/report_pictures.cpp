#include "study/report_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "study/colour_map.h"
#include "study/html_text.h"
#include "study/short_title.h"

namespace penumbra::study {
namespace {

using Json = nlohmann::ordered_json;

// The data of a picture of visibility, by pixel.
struct Planes {
  Picture visibility;  // in 255ths; 0 where there is none
  Picture receivers;   // 255 where there is one
  Picture invalid;     // 255 where the result is no visibility; empty without such a pixel
};

Planes planes_of(const Picture& painted) {
  const Picture empty{painted.width, painted.height, 1, {}};
  Planes planes{empty, empty, empty};
  bool all_valid = true;
  for (int y = 0; y < painted.height; ++y) {
    for (int x = 0; x < painted.width; ++x) {
      const Rgb colour = pixel(painted, x, y);
      const bool receiver = !(colour == kNoReceiver);
      const bool valid = !(colour == kInvalid);
      planes.visibility.samples.push_back(receiver && valid ? colour.g : 0);
      planes.receivers.samples.push_back(receiver ? 255 : 0);
      planes.invalid.samples.push_back(valid ? 0 : 255);
      all_valid = all_valid && valid;
    }
  }
  if (all_valid) planes.invalid.samples.clear();
  return planes;
}

// Returns a ramp as the bytes of its colours, in base64.
std::string ramp(Rgb (*colour)(double), double from, double to) {
  const Picture strip = ramp_strip(colour, from, to);
  return base64(std::as_bytes(std::span(strip.samples)));
}

std::string css_colour(Rgb colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

class Album {
 public:
  Album(const Results& results, const std::vector<PictureRow>& rows) : results_(results) {
    for (std::size_t i = 0; i < rows.size(); ++i) add(i, rows[i]);
  }

  std::string html() const {
    Json index;
    index["ramps"] = {{"error", ramp(error_colour, -1.0, 1.0)}, {"fetches", ramp(fetch_colour, 0.0, 1.0)}};
    index["noReceiver"] = css_colour(kNoReceiver);
    index["invalid"] = css_colour(kInvalid);
    index["stages"] = stages_;
    return json_script("picture-index", index) + data_;
  }

 private:
  void add(std::size_t place, const PictureRow& row) {
    Json& stage = stage_of(row);
    const Planes result = planes_of(row.result);
    Json item;
    item["id"] = place;
    item["technique"] = row.technique;
    const Record* record = record_of(row);
    item["shown"] = record == nullptr ? row.technique : short_title(record->technique, record->title);
    if (record != nullptr && record->metrics.rmse_penumbra) item["rmse"] = *record->metrics.rmse_penumbra;
    item["errorScale"] = row.error_scale;
    item["fetchScale"] = row.fetch_scale;
    item["result"] = store(result.visibility);
    if (!result.invalid.samples.empty()) item["invalid"] = store(result.invalid);
    if (!row.fetch_counts.empty()) item["fetches"] = store(row.fetch_counts.png());
    if (!row.mask.empty()) item["mask"] = store(planes_of(row.mask).visibility);
    stage["items"].push_back(std::move(item));
  }

  Json& stage_of(const PictureRow& row) {
    for (Json& stage : stages_) {
      if (stage["scene"] == row.scene && stage["light"] == row.light_degrees) return stage;
    }
    const Planes reference = planes_of(row.reference);
    const Picture& size = reference.visibility;
    stages_.push_back({{"scene", row.scene},
                       {"light", row.light_degrees},
                       {"width", size.width},
                       {"height", size.height},
                       {"reference", store(reference.visibility)},
                       {"receivers", store(reference.receivers)},
                       {"items", Json::array()}});
    return stages_.back();
  }

  const Record* record_of(const PictureRow& row) const {
    const auto found =
        std::find_if(results_.records.begin(), results_.records.end(), [&row](const Record& record) {
          return record.scene == row.scene && record.technique == row.technique &&
                 record.light_degrees == row.light_degrees;
        });
    return found == results_.records.end() ? nullptr : &*found;
  }

  std::size_t store(const Picture& grey) { return store(encode_png(grey)); }

  std::size_t store(std::span<const std::byte> png) {
    data_ += fmt::format("<script type=\"text/plain\" id=\"png-{}\">{}</script>\n", stored_, base64(png));
    return stored_++;
  }

  const Results& results_;
  Json stages_ = Json::array();
  std::string data_;
  std::size_t stored_ = 0;
};

constexpr std::string_view kViewer =
    R"html(<p class="no-script">The viewer needs JavaScript. The same pictures are in the folder
<code>pictures</code> next to this file.</p>
<div class="viewer needs-script" id="viewer">
<form class="controls">
<div class="line">
<label>Scene <select name="scene"></select></label>
<label>Light <select name="light"></select></label>
<label>Left <select name="left"></select></label>
<fieldset><legend>Right</legend>
<label><input type="radio" name="kind" value="result" checked><span>Result</span></label>
<label><input type="radio" name="kind" value="error"><span>Error</span></label>
<label><input type="radio" name="kind" value="fetches"><span>Fetches</span></label>
<label><input type="radio" name="kind" value="mask"><span>Mask</span></label></fieldset>
<fieldset><legend>Compare by</legend>
<label><input type="radio" name="mode" value="slider" checked><span>Slider</span></label>
<label><input type="radio" name="mode" value="blink"><span>Blink</span></label></fieldset>
</div>
<div class="techniques" role="group" aria-label="Technique on the right"></div>
</form>
<div class="stage" tabindex="0" role="group" aria-label="Comparison" aria-describedby="viewer-keys">
<canvas role="img"></canvas>
<span class="tag left" aria-hidden="true"></span><span class="tag right" aria-hidden="true"></span>
<div class="divider" role="slider" tabindex="0" aria-label="Border between left and right, percent from the left"
 aria-valuemin="0" aria-valuemax="100" aria-valuenow="50"><span class="grip" aria-hidden="true"></span></div>
</div>
<div class="line below">
<div class="zoom" role="group" aria-label="Zoom"><button type="button" name="out" aria-label="Zoom out">−</button>
<output></output><button type="button" name="in" aria-label="Zoom in">+</button>
<button type="button" name="fit">Fit</button></div>
<label class="scale">Full colour at an error of ± <input type="range" name="scale" min="0" max="100" step="1">
<output></output></label>
<span class="legend"><span class="from"></span><canvas width="256" height="1" role="img"></canvas><span class="to"></span></span>
</div>
<p class="readout">Point at the picture to read the values of a pixel.</p>
</div>
)html";

constexpr std::string_view kExplanation =
    R"html(<p class="quiet" id="viewer-keys">Drag the border, or the picture when it is enlarged.
Ctrl and the wheel, or two fingers, zoom. Keys on the picture: + and − zoom, 0 fits the picture to the window, arrow keys move it, comma and full stop move the
border, B blinks, X swaps left and right, N and P select the next and the previous technique.</p>
<p class="quiet">One frame, of the first noise seed. Pictures hold 8 bits: differences below 1/255 (0.004) do not show, and
fetches are cut off at 255. <span class="swatch no-receiver"></span> no surface; <span class="swatch invalid"></span> invalid
result, reported as a finding.</p>
)html";

constexpr std::string_view kNone =
    R"html(<p>This report was made from a results file, which contains no pictures. The command
below measures again and adds the pictures:</p>
)html";

}  // namespace

std::string pictures_html(const Results& results, const std::vector<PictureRow>& pictures) {
  if (results.records.empty()) return {};
  if (pictures.empty()) return std::string(kNone) + command_html(results.command + " --output report");
  return std::string(kViewer) + std::string(kExplanation) + Album(results, pictures).html();
}

}  // namespace penumbra::study
