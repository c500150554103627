#include "study/insets.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "study/colour_map.h"

namespace penumbra::study {
namespace {

constexpr int kFrame = 4;  // pixels around an inset
constexpr int kMark = 2;   // around its place in the picture
constexpr int kGap = 8;
constexpr Rgb kPaper{255, 255, 255};

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

// Around the window, not upon it.
void draw_frame(Picture& picture, const PictureWindow& window, int thickness, Rgb colour) {
  const int wide = window.width + 2 * thickness;
  fill(picture, {window.x - thickness, window.y - thickness, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y + window.height, wide, thickness}, colour);
  fill(picture, {window.x - thickness, window.y, thickness, window.height}, colour);
  fill(picture, {window.x + window.width, window.y, thickness, window.height}, colour);
}

void place(Picture& canvas, int left, int top, const Picture& picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) set_pixel(canvas, left + x, top + y, pixel(picture, x, y));
  }
}

}  // namespace

int inset_factor(int width, const std::vector<PictureWindow>& windows) {
  const int count = static_cast<int>(windows.size());
  int sum = 0;
  for (const PictureWindow& window : windows) sum += window.width;
  return sum == 0 ? 0 : std::max(width - 2 * kFrame * count - kGap * (count - 1), 0) / sum;
}

Picture with_insets(const Picture& picture, int zoom, const std::vector<PictureWindow>& windows) {
  Picture marked = enlarged(picture, zoom);
  if (windows.empty()) return marked;
  const int factor = inset_factor(marked.width, windows);
  if (factor == 0) throw std::invalid_argument("the insets do not fit beneath the picture");
  int tallest = 0;
  int rest = marked.width - kGap * (static_cast<int>(windows.size()) - 1);
  for (const PictureWindow& window : windows) {
    tallest = std::max(tallest, window.height);
    rest -= window.width * factor + 2 * kFrame;
  }
  Picture canvas = filled_picture(marked.width, marked.height + kGap + tallest * factor + 2 * kFrame, kPaper);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const PictureWindow& window = windows[i];
    draw_frame(marked, {window.x * zoom, window.y * zoom, window.width * zoom, window.height * zoom}, kMark,
               frame_colour(i));
  }
  place(canvas, 0, 0, marked);
  // What is left of the width stands between them, so that the outer ones align with the picture.
  const int between = windows.size() > 1 ? rest / (static_cast<int>(windows.size()) - 1) : 0;
  int left = windows.size() > 1 ? kFrame : kFrame + rest / 2;
  const int top = marked.height + kGap + kFrame;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Picture inset = enlarged(cropped(picture, windows[i]), factor);
    place(canvas, left, top, inset);
    draw_frame(canvas, {left, top, inset.width, inset.height}, kFrame, frame_colour(i));
    left += inset.width + 2 * kFrame + kGap + between;
  }
  return canvas;
}

}  // namespace penumbra::study
