#include "study/composition.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace penumbra::study {
namespace {

constexpr int kGap = 8;        // pixels between and around pictures
constexpr int kTextScale = 2;  // stb_easy_font's letters are 7 pixels high
constexpr int kTextHeight = 12 * kTextScale;
constexpr int kStripHeight = 10;
constexpr Rgb kPaper{255, 255, 255};
constexpr Rgb kInk{34, 34, 34};  // a grey: sheets of greys keep within a palette

std::string printable(std::string text) {
  for (char& c : text) {
    if (c < 32 || c > 126) c = '?';
  }
  return text;
}

int text_width(std::string text) {
  return stb_easy_font_width(text.data()) * kTextScale;
}

std::vector<std::string> lines_of(const std::string& caption) {
  std::vector<std::string> lines;
  std::istringstream text(caption);
  for (std::string line; std::getline(text, line);) lines.push_back(printable(line));
  return lines;
}

int most_lines(const std::vector<CaptionedPicture>& pictures) {
  std::size_t most = 1;
  for (const CaptionedPicture& item : pictures) most = std::max(most, lines_of(item.caption).size());
  return static_cast<int>(most);
}

std::string cut_to(std::string text, int width) {
  while (!text.empty() && text_width(text) > width) text.pop_back();
  return text;
}

void fill(Picture& picture, int left, int top, int right, int bottom, Rgb colour) {
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x) set_pixel(picture, x, y, colour);
  }
}

// stb_easy_font turns text into axis-parallel rectangles; each is a quad of four vertices.
void draw_text(Picture& picture, int left, int top, std::string text) {
  struct Vertex {
    float x, y, z;
    std::array<unsigned char, 4> colour;
  };
  constexpr std::size_t kMostBytesPerLetter = 512;
  std::vector<Vertex> vertices((text.size() + 1) * kMostBytesPerLetter / sizeof(Vertex));
  const int quads = stb_easy_font_print(0.0F, 0.0F, text.data(), nullptr, vertices.data(),
                                        static_cast<int>(vertices.size() * sizeof(Vertex)));
  for (int i = 0; i < quads; ++i) {
    const Vertex& low = vertices[static_cast<std::size_t>(i) * 4];
    const Vertex& high = vertices[static_cast<std::size_t>(i) * 4 + 2];
    const auto scaled = [](float value) { return static_cast<int>(std::lround(value)) * kTextScale; };
    fill(picture, left + scaled(low.x), top + scaled(low.y), left + scaled(high.x), top + scaled(high.y),
         kInk);
  }
}

void place(Picture& canvas, int left, int top, const Picture& picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) set_pixel(canvas, left + x, top + y, pixel(picture, x, y));
  }
}

// "from" [======] "to", right-aligned in the caption's row.
int draw_legend(Picture& canvas, int right, int top, const Legend& legend, int strip_width) {
  const std::string from = printable(legend.from);
  const std::string to = printable(legend.to);
  const int strip_right = right - text_width(to) - kGap / 2;
  const int strip_left = strip_right - strip_width;
  draw_text(canvas, right - text_width(to), top, to);
  const int strip_top = top + 2;
  for (int x = 0; x < strip_width; ++x) {
    const Rgb colour = pixel(legend.strip, x * (legend.strip.width - 1) / std::max(strip_width - 1, 1), 0);
    fill(canvas, strip_left + x, strip_top, strip_left + x + 1, strip_top + kStripHeight, colour);
  }
  const int left = strip_left - kGap / 2 - text_width(from);
  draw_text(canvas, left, top, from);
  return left;
}

// The caption's lines from the top, and the legend in the last of `rows`.
void draw_caption(Picture& canvas, int left, int top, int width, int rows, const CaptionedPicture& item) {
  const int last = rows - 1;
  int last_right = left + width;
  if (item.legend) {
    last_right = draw_legend(canvas, left + width, top + last * kTextHeight, *item.legend, width / 5) - kGap;
  }
  const std::vector<std::string> lines = lines_of(item.caption);
  for (int row = 0; row < static_cast<int>(lines.size()); ++row) {
    const int right = row == last ? last_right : left + width;
    draw_text(canvas, left, top + row * kTextHeight,
              cut_to(lines[static_cast<std::size_t>(row)], right - left));
  }
}

}  // namespace

int caption_width(const std::string& caption) {
  int width = 0;
  for (const std::string& line : lines_of(caption)) width = std::max(width, text_width(line));
  return width;
}

Picture compose(const std::vector<CaptionedPicture>& pictures, int columns, int least_width) {
  if (pictures.empty() || columns < 1) throw std::invalid_argument("nothing to compose");
  const int width = pictures.front().picture.width;
  const int height = pictures.front().picture.height;
  const int cell_width = std::max(width, least_width);
  const int used = std::min(columns, static_cast<int>(pictures.size()));
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  const int caption_rows = most_lines(pictures);
  const int caption_height = caption_rows * kTextHeight;
  const int cell_height = caption_height + height + kGap;
  Picture canvas = filled_picture(used * (cell_width + kGap) + kGap, rows * cell_height + kGap, kPaper);

  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const CaptionedPicture& item = pictures[i];
    if (item.picture.width != width || item.picture.height != height || item.picture.channels != 3) {
      throw std::invalid_argument("pictures to compose differ in size");
    }
    const int left = kGap + static_cast<int>(i) % columns * (cell_width + kGap);
    const int top = kGap + static_cast<int>(i) / columns * cell_height;
    draw_caption(canvas, left, top, cell_width, caption_rows, item);
    place(canvas, left, top + caption_height, item.picture);
  }
  return canvas;
}

}  // namespace penumbra::study
