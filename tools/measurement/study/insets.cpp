#include "study/insets.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "study/colour_map.h"
#include "study/composition.h"

namespace penumbra::study {
namespace {

constexpr int kFrame = 4;  // pixels around an inset
constexpr int kMark = 2;   // pixels around an inset's place in the picture
Rgb frame_colour(std::size_t inset) {
  static constexpr std::array kOrder{Category::vermillion, Category::blue, Category::yellow,
                                     Category::bluish_green};
  return category_colour(kOrder[inset % kOrder.size()]);
}

void fill(Picture& picture, const PictureWindow& area, Rgb colour) {
  for (int y = std::max(area.y, 0); y < std::min(area.y + area.height, picture.height); ++y) {
    for (int x = std::max(area.x, 0); x < std::min(area.x + area.width, picture.width); ++x) {
      set_pixel(picture, x, y, colour);
    }
  }
}

// The frame lies around the window, not upon it.
void draw_frame(Picture& picture, const PictureWindow& window, int thickness, Rgb colour) {
  const int wide = window.width + 2 * thickness;
  fill(picture, {window.x - thickness, window.y - thickness, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y + window.height, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y, thickness, window.height}, colour);
  fill(picture, {window.x + window.width, window.y, thickness, window.height}, colour);
}

}  // namespace

int inset_factor(int width, const std::vector<PictureWindow>& windows) {
  const int count = static_cast<int>(windows.size());
  int sum = 0;
  for (const PictureWindow& window : windows) sum += window.width;
  return sum == 0 ? 0 : std::max(width - 2 * kFrame * count - kPictureGap * (count - 1), 0) / sum;
}

Picture with_insets(const Picture& picture, int zoom, const std::vector<PictureWindow>& windows) {
  Picture marked = enlarged(picture, zoom);
  if (windows.empty()) return marked;
  const int factor = inset_factor(marked.width, windows);
  if (factor == 0) throw std::invalid_argument("the insets do not fit beneath the picture");
  int tallest = 0;
  int rest = marked.width - kPictureGap * (static_cast<int>(windows.size()) - 1);
  for (const PictureWindow& window : windows) {
    tallest = std::max(tallest, window.height);
    rest -= window.width * factor + 2 * kFrame;
  }
  Picture canvas =
      filled_picture(marked.width, marked.height + kPictureGap + tallest * factor + 2 * kFrame, kPaper);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const PictureWindow& window = windows[i];
    draw_frame(marked, {window.x * zoom, window.y * zoom, window.width * zoom, window.height * zoom}, kMark,
               frame_colour(i));
  }
  place_picture(canvas, 0, 0, marked);
  // The remaining width is distributed between them, so that the outer ones align with the picture.
  const int between = windows.size() > 1 ? rest / (static_cast<int>(windows.size()) - 1) : 0;
  int left = windows.size() > 1 ? kFrame : kFrame + rest / 2;
  const int top = marked.height + kPictureGap + kFrame;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Picture inset = enlarged(cropped(picture, windows[i]), factor);
    place_picture(canvas, left, top, inset);
    draw_frame(canvas, {left, top, inset.width, inset.height}, kFrame, frame_colour(i));
    left += inset.width + 2 * kFrame + kPictureGap + between;
  }
  return canvas;
}

}  // namespace penumbra::study
