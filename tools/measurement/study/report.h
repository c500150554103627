// report.html: all results of one run of `penumbra measure`, in one self-contained file.
//
// The page contains its style, its script, its charts (inline SVG) and its pictures (PNG in base64, decoded
// when they are viewed), and a content security policy that forbids loading anything. It follows the reader's
// light or dark setting and prints. Its script draws the table of figures and the picture viewer from data
// that the page contains; without it, the charts and the words are there.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "study/chart.h"
#include "study/picture.h"
#include "study/results.h"
#include "study/technique_facts.h"

namespace penumbra::study {

// The pictures of one record, all of one size. error_scale is the error shown in full colour; fetch_scale is
// the number of fetches shown white.
struct PictureRow {
  std::string scene;
  std::string technique;
  double light_degrees = 0.0;
  PackedPicture reference;
  PackedPicture result;
  PackedPicture error;
  PackedPicture fetches;
  PackedPicture fetch_counts{};  // grey: fetches per pixel, 255 for more; empty where they were not counted
  PackedPicture mask{};  // white where the full filter runs, black where one fetch does; empty without a mask
  std::map<std::string, PackedPicture> debug_views{};  // keyed by pass
  double error_scale = 0.5;
  double fetch_scale = 64.0;
};

struct ReportChart {
  Chart chart;
  std::string caption;
};

struct ReportContent {
  Results results;
  std::vector<ReportChart> charts;
  std::vector<PictureRow> pictures;
  FactsOfTechniques facts{};
};

// The same content gives the same bytes.
std::string render_report(const ReportContent& content);

// Returns the charts of report_charts.h that have something to show.
std::vector<ReportChart> report_charts(const Results& results);

}  // namespace penumbra::study
