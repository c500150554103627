// The charts of a study: the cost of each technique against its error, one panel per light.
#pragma once

#include "study/chart.h"
#include "study/results.h"

namespace penumbra::study {

// Shows mean fetches per pixel against mean penumbra RMSE over all scenes, with the Pareto front.
Chart fetches_chart(const Results& results);

// Shows the same over milliseconds per frame; on a software device without a front, and labelled as CPU time,
// which ranks nothing. The chart has no panel when nothing was timed.
Chart time_chart(const Results& results);

}  // namespace penumbra::study
