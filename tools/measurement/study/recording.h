// Records the results of a subject: figures and pictures. Internal to this folder.
#pragma once

#include <optional>
#include <string>

#include "study/case_setup.h"
#include "study/prepared_subject.h"
#include "study/report.h"
#include "study/results.h"

namespace penumbra::study {

MeasuredFrame measured_frame(const CaseSetup& setup);

// If there is a window, the figures are those of the window alone. `unlimited` is the subject's answer with
// unlimited samples.
Record record_of(const CaseSetup& setup, const View& view, const Subject& subject, const Answer& answer,
                 const std::optional<PictureWindow>& window,
                 const std::optional<reference::VisibilityImage>& unlimited, const std::string& device);

// The error of the answer on the pixels of reference::shadow_overlaps().
OverlapRecord overlap_record(const CaseSetup& setup, const Answer& answer,
                             std::span<const std::uint8_t> overlaps);

PictureRow pictures_of(const CaseSetup& setup, const Subject& subject, const Answer& answer);

}  // namespace penumbra::study
