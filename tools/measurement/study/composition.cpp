#include "study/composition.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "study/lettering.h"

namespace penumbra::study {
namespace {

constexpr int kCaptionGap = 4;   // pixels between a caption and its picture
constexpr Rgb kInk{34, 34, 34};  // grey: sheets in shades of grey fit a palette

std::vector<std::string> lines_of(const std::string& caption) {
  std::vector<std::string> lines;
  std::istringstream text(caption);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

int most_lines(const std::vector<CaptionedPicture>& pictures) {
  std::size_t most = 1;
  for (const CaptionedPicture& item : pictures) most = std::max(most, lines_of(item.caption).size());
  return static_cast<int>(most);
}

void fill(Picture& picture, int left, int top, int right, int bottom, Rgb colour) {
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x) set_pixel(picture, x, y, colour);
  }
}

// Writes captions of one size into a canvas.
class Captions {
 public:
  Captions(Picture& canvas, int text_size) : canvas_(canvas), letters_(text_size) {}

  // Draws the caption's lines from the top, and the legend in the last of them.
  void draw(int left, int top, int width, const CaptionedPicture& item) {
    const std::vector<std::string> lines = lines_of(item.caption);
    const int last = std::max(static_cast<int>(lines.size()) - 1, 0);
    int last_right = left + width;
    if (item.legend) {
      last_right = draw_legend(left + width, top + last * letters_.line_height(), *item.legend, width / 5) -
                   kPictureGap;
    }
    for (int row = 0; row < static_cast<int>(lines.size()); ++row) {
      const int right = row == last ? last_right : left + width;
      letters_.draw(canvas_, left, top + row * letters_.line_height(),
                    letters_.cut_to(lines[static_cast<std::size_t>(row)], right - left), kInk);
    }
  }

 private:
  // Draws "from" [======] "to", right-aligned in the caption's row. Returns its left end.
  int draw_legend(int right, int top, const Legend& legend, int strip_width) {
    const int strip_right = right - letters_.width(legend.to) - kPictureGap / 2;
    const int strip_left = strip_right - strip_width;
    letters_.draw(canvas_, right - letters_.width(legend.to), top, legend.to, kInk);
    const int strip_top = top + letters_.line_height() / 4;
    for (int x = 0; x < strip_width; ++x) {
      const Rgb colour = pixel(legend.strip, x * (legend.strip.width - 1) / std::max(strip_width - 1, 1), 0);
      fill(canvas_, strip_left + x, strip_top, strip_left + x + 1, strip_top + letters_.line_height() / 2,
           colour);
    }
    const int left = strip_left - kPictureGap / 2 - letters_.width(legend.from);
    letters_.draw(canvas_, left, top, legend.from, kInk);
    return left;
  }

  Picture& canvas_;
  Lettering letters_;
};

}  // namespace

int caption_width(const std::string& caption, int text_size) {
  const Lettering letters(text_size);
  int width = 0;
  for (const std::string& line : lines_of(caption)) width = std::max(width, letters.width(line));
  return width;
}

std::string wrapped_caption(const std::string& caption, int width, int text_size) {
  const Lettering letters(text_size);
  std::string wrapped;
  for (const std::string& line : lines_of(caption)) {
    std::istringstream words(line);
    std::string begun;
    for (std::string word; words >> word;) {
      const std::string longer = begun.empty() ? word : begun + " " + word;
      if (begun.empty() || letters.width(longer) <= width) {
        begun = longer;
        continue;
      }
      const std::size_t comma = longer.rfind(", ");
      const bool at_comma = comma != std::string::npos && letters.width(longer.substr(comma + 2)) <= width;
      const std::size_t space = at_comma ? comma + 1 : begun.size();
      wrapped += longer.substr(0, space) + "\n";
      begun = longer.substr(space + 1);
    }
    wrapped += begun + "\n";
  }
  if (!wrapped.empty()) wrapped.pop_back();
  return wrapped;
}

Picture compose(const std::vector<CaptionedPicture>& pictures, int columns, int least_width, int text_size) {
  if (pictures.empty() || columns < 1) throw std::invalid_argument("nothing to compose");
  const int width = pictures.front().picture.width;
  const int height = pictures.front().picture.height;
  const int cell_width = std::max(width, least_width);
  const int used = std::min(columns, static_cast<int>(pictures.size()));
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  const int caption_rows = most_lines(pictures);
  const int caption_height = caption_rows * Lettering(text_size).line_height() + kCaptionGap;
  const int cell_height = caption_height + height + kPictureGap;
  Picture canvas = filled_picture(used * (cell_width + kPictureGap) + kPictureGap,
                                  rows * cell_height + kPictureGap, kPaper);

  Captions captions(canvas, text_size);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const CaptionedPicture& item = pictures[i];
    if (item.picture.width != width || item.picture.height != height || item.picture.channels != 3) {
      throw std::invalid_argument("pictures to compose differ in size");
    }
    const int left = kPictureGap + static_cast<int>(i) % columns * (cell_width + kPictureGap);
    const int top = kPictureGap + static_cast<int>(i) / columns * cell_height;
    captions.draw(left, top, cell_width, item);
    place_picture(canvas, left, top + caption_height, item.picture);
  }
  return canvas;
}

}  // namespace penumbra::study
