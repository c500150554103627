#include "study/lit_view.h"

#include <stdexcept>
#include <utility>

#include "study/colour_map.h"

namespace penumbra::study {
namespace {

Picture painted(const lighting::LitFrame& frame, std::span<const float> visibility) {
  return colour_picture(frame.width(), frame.height(), frame.picture(visibility));
}

}  // namespace

LitView::LitView(lighting::LitSettings settings, StudyProgress progress)
    : settings_(std::move(settings)), progress_(std::move(progress)) {}

void LitView::add(const SubjectAnswer& answer) {
  const double degrees = answer.record.light_degrees;
  if (!frame_ || scene_ != answer.scene.name || light_degrees_ != degrees) {
    frame_.reset();  // frees the frame before the next one is made, because a frame is large
    settings_.light_degrees = degrees;
    frame_.emplace(answer.scene, answer.frame, settings_, progress_);
    scene_ = answer.scene.name;
    light_degrees_ = degrees;
    reference_ = painted(*frame_, answer.reference.visibility);
  }
  references_.push_back(reference_);
  results_.push_back(painted(*frame_, answer.visibility));
}

void LitView::replace_pictures(std::vector<PictureRow>& rows) const {
  if (rows.size() != results_.size()) throw std::invalid_argument("a lit view of another study");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    PictureRow& row = rows[i];
    row.reference = references_[i];
    row.result = results_[i];
    for (PackedPicture* picture : {&row.error, &row.fetches, &row.mask}) {
      if (!picture->empty()) *picture = shrunk(*picture, settings_.supersampling);
    }
    for (auto& [name, picture] : row.debug_views) picture = shrunk(picture, settings_.supersampling);
  }
}

}  // namespace penumbra::study
