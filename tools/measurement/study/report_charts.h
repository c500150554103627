// The charts of a report as HTML: drawings whose points respond to the pointer and can be reached by
// keyboard.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/chart.h"
#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

// Returns one figure per chart, its panels beside each other. Each point is a link to the table's rows of its
// technique, with its texts in data-label and data-note.
std::string charts_html(const std::vector<ReportChart>& charts);

// Shows mean fetches per pixel against mean penumbra RMSE over all scenes, with the Pareto front.
Chart fetches_chart(const Results& results);

// Shows the same over milliseconds per frame; on a software device without a front, and labelled as CPU time,
// which ranks nothing. The chart has no panel when nothing was timed.
Chart time_chart(const Results& results);

// The Pareto front: the choices for which nothing is both cheaper and better.
struct CostAndError {
  double cost = 0.0;
  double error = 0.0;
};

// Returns the indices of the points that no other point dominates, by rising cost. A point dominates another
// when it is not worse in either figure and better in one; equal points are kept together. Points that are
// not finite are excluded.
std::vector<std::size_t> pareto_front(const std::vector<CostAndError>& points);

}  // namespace penumbra::study
