// penumbra_synthetic_report KIND: the report of a made-up study on standard output. Kinds: whole; evil, whose
// names are markup, scripts, quotes and lines; figures, without pictures; findings, with results that are no
// visibility.
#include <cstdio>
#include <string>

#include "study/report.h"
#include "study/synthetic_study.h"

namespace {

using penumbra::study::PictureRow;
using penumbra::study::Record;
using penumbra::study::ReportContent;

void make_evil(ReportContent& content) {
  const std::string evil =
      "\"></script></style><script>console.error('evil')</script><img src=x "
      "onerror=\"console.error('evil')\">'\n&amp;";
  content.results.command = content.results.driver = content.results.device = evil;
  for (Record& record : content.results.records) {
    record.scene += evil;
    record.technique += evil;
    record.title = record.map_format = record.reference.kind = evil;
    record.parameters = {{evil, {1.0}}};
  }
  for (PictureRow& row : content.pictures) {
    row.scene += evil;
    row.technique += evil;
  }
  content.charts = penumbra::study::report_charts(content.results);
}

void add_findings(ReportContent& content) {
  content.results.records[5].metrics.invalid = 3;
  penumbra::study::Picture marked = content.pictures[1].result;
  for (int x = 0; x < 3; ++x) set_pixel(marked, x, 20, {255, 0, 255});
  content.pictures[1].result = marked;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kind = argc == 2 ? argv[1] : "";
  ReportContent content = penumbra::study::synthetic::report_content();
  // Sorting must not mistake these: an absent figure, one that text would put last, two that are equal when
  // rounded.
  content.results.records[3].metrics.rmse_all = std::nullopt;
  content.results.records[5].metrics.rmse_all = 1e-5;
  content.results.records[6].metrics.rmse_all = 0.05001;
  content.results.records[7].metrics.rmse_all = 0.05002;
  if (kind == "evil") {
    make_evil(content);
  } else if (kind == "figures") {
    content.pictures.clear();
  } else if (kind == "findings") {
    add_findings(content);
  } else if (kind != "whole") {
    std::fputs("usage: penumbra_synthetic_report whole|evil|figures|findings\n", stderr);
    return 2;
  }
  const std::string html = penumbra::study::render_report(content);
  return std::fwrite(html.data(), 1, html.size(), stdout) == html.size() ? 0 : 1;
}
