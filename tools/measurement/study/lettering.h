// Text in pictures, from a font of the system: DejaVu Sans, or the TrueType file that the environment
// variable PENUMBRA_FONT names.
//
// The same font and text give the same pixels (stb_truetype: no hinting, kerning as the font has it). UTF-8;
// invalid UTF-8 and characters that the font lacks are drawn as '?'.
#pragma once

#include <string>
#include <string_view>

#include "study/picture.h"

namespace penumbra::study {

class Lettering {
 public:
  // `size` is the height of a line in pixels. Throws EnvironmentError where there is no font, naming the
  // package that brings one.
  explicit Lettering(int size);

  int line_height() const { return size_; }
  int width(std::string_view text) const;  // width in pixels, rounded up

  // Returns as much of the text as is no wider than this, in whole characters.
  std::string cut_to(std::string_view text, int width) const;

  // The line's left upper corner is at (left, top); what lies beyond the picture, or above or below the line,
  // is left out.
  void draw(Picture& picture, int left, int top, std::string_view text, Rgb ink) const;

 private:
  float advance(char32_t letter, char32_t next) const;

  int size_;
  float scale_;
  float ascent_;
};

}  // namespace penumbra::study
