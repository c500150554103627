// The script that watches a page from the inside and leaves what it saw in the page's last element.
#pragma once

#include <string_view>

namespace penumbra::browser {

inline constexpr std::string_view kAnswerBegin = "<pre id=\"penumbra-page-check\">";
inline constexpr std::string_view kAnswerEnd = "</pre>";

// The answer is JSON, percent-encoded, so that no character of it can be mistaken for markup. A policy that
// forbids inline scripts would also stop the probe: then there is no answer, which counts as a failure.
inline constexpr std::string_view kProbe = R"js(<script>
(() => {
  const problems = [];
  const note = (kind, text) => problems.push(kind + ": " + String(text).slice(0, 300));
  addEventListener("error", event => {
    if (event.target instanceof Element) note("not loaded", event.target.outerHTML);
    else note("script error", event.message);
  }, true);
  addEventListener("unhandledrejection", event => note("unhandled rejection", event.reason));
  addEventListener("securitypolicyviolation", event =>
    note("policy violation", event.violatedDirective + " " + event.blockedURI));
  for (const level of ["error", "warn", "assert"]) {
    const original = console[level];
    console[level] = (...words) => {
      if (level !== "assert" || !words[0]) note("console." + level, words.join(" "));
      original.apply(console, words);
    };
  }
  // Loading reads a picture's head only; drawing it decodes all of it. Where data is missing nothing is drawn, and
  // a report's pictures have no transparent pixel. (image.decode() would ask the same, but may never answer in a
  // browser that shows no frames.)
  const isWhole = image => {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height).data.every((v, i) => i % 4 !== 3 || v === 255);
  };
  addEventListener("load", async () => {
    const images = [...document.images];
    for (const image of images) {
      if (!(image.complete && image.naturalWidth > 0 && image.naturalHeight > 0)) note("empty picture", image.alt);
      try {
        if (!isWhole(image)) note("picture not decoded", image.alt);
      } catch (error) { note("picture not decoded", image.alt + " " + error); }
    }
    const charts = [...document.querySelectorAll("svg")];
    for (const chart of charts) {
      const box = chart.getBoundingClientRect();
      if (!(box.width > 0 && box.height > 0)) note("empty chart", chart.outerHTML);
    }
    const buttons = [...document.querySelectorAll("button")];
    for (const button of buttons) { button.click(); button.click(); }
    await new Promise(resolve => setTimeout(resolve, 50));
    const answer = document.createElement("pre");
    answer.id = "penumbra-page-check";
    answer.textContent = encodeURIComponent(JSON.stringify(
      { problems, images: images.length, charts: charts.length, buttons: buttons.length }));
    document.body.append(answer);
  });
})();
</script>)js";

}  // namespace penumbra::browser
