// The pictures of a study as photographs: each subject's shadows on lit materials.
//
// The view collects every result of a study and lights its frame; the reference's picture is lit by the
// ray-traced visibility. Such a study runs at `supersampling` times the size of the pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lighting/lit_frame.h"
#include "study/picture.h"
#include "study/report.h"
#include "study/study.h"

namespace penumbra::study {

class LitView {
 public:
  LitView(lighting::LitSettings settings, StudyProgress progress);

  // It is called by StudySettings::answered. Throws what lighting::LitFrame does.
  void add(const SubjectAnswer& answer);

  // Replaces references and results by the lit pictures, and scales all others down to their size. `rows` are
  // those of the same study. Throws std::invalid_argument for another number of rows.
  void replace_pictures(std::vector<PictureRow>& rows) const;

 private:
  lighting::LitSettings settings_;
  StudyProgress progress_;
  std::optional<lighting::LitFrame> frame_;  // the frame of the scene and light that answers come from
  std::string scene_;
  double light_degrees_ = -1.0;
  Picture reference_;
  std::vector<Picture> references_, results_;  // one picture per answer
};

}  // namespace penumbra::study
