#include "study/packed_picture.h"

namespace penumbra::study {

PackedPicture::PackedPicture(const Picture& picture) {
  if (picture.samples.empty()) return;
  png_ = encode_png(picture);
  png_.shrink_to_fit();
}

PackedPicture::PackedPicture(std::span<const std::byte> png) : png_(png.begin(), png.end()) {
  if (!png.empty()) decode_png(png, "a kept picture");
}

Picture PackedPicture::unpacked() const {
  return empty() ? Picture{} : decode_png(png_, "a kept picture");
}

}  // namespace penumbra::study
