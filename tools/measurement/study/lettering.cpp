#include "study/lettering.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

#include "input/input_error.h"
#include "input/text_line.h"

namespace penumbra::study {
namespace {

constexpr std::array kFontFiles{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",  // the path on Debian
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
};

struct Font {
  std::vector<unsigned char> file;
  stbtt_fontinfo info{};
};

// The file must not be a device, which may have no end.
bool could_be_a_font(const std::filesystem::path& file) {
  constexpr std::uintmax_t kLargest = std::uintmax_t{64} << 20;
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) &&
         std::filesystem::file_size(file, error) <= kLargest && !error;
}

bool read(Font& font, const char* file) {
  if (!could_be_a_font(file)) return false;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return false;
  font.file.assign(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  if (font.file.size() < 16) return false;
  const int offset = stbtt_GetFontOffsetForIndex(font.file.data(), 0);
  return offset >= 0 && stbtt_InitFont(&font.info, font.file.data(), offset) != 0;
}

Font found_font() {
  Font font;
  if (const char* named = std::getenv("PENUMBRA_FONT"); named != nullptr && *named != '\0') {
    if (read(font, named)) return font;
    throw EnvironmentError(std::string("PENUMBRA_FONT: '") + named +
                           "' is not a TrueType font that can be read");
  }
  for (const char* file : kFontFiles) {
    if (read(font, file)) return font;
  }
  throw EnvironmentError(
      "captions need the font DejaVu Sans from the Debian package fonts-dejavu-core, or another one that "
      "PENUMBRA_FONT names");
}

const stbtt_fontinfo& font() {
  static const Font kept = found_font();
  return kept.info;
}

// Removes one character from the front of the text and returns it.
char32_t next_letter(std::string_view& text) {
  const TextCharacter letter = character_at(text, 0);
  text.remove_prefix(letter.bytes);
  const bool drawable = letter.is_valid && letter.code >= 32 &&
                        stbtt_FindGlyphIndex(&font(), static_cast<int>(letter.code)) != 0;
  return drawable ? letter.code : U'?';
}

std::u32string letters_of(std::string_view text) {
  std::u32string letters;
  while (!text.empty()) letters.push_back(next_letter(text));
  return letters;
}

// Coverage of one letter, and where it stands relative to the pen.
struct Glyph {
  int left = 0, top = 0, width = 0, height = 0;
  std::vector<unsigned char> coverage;
};

Glyph glyph_of(char32_t letter, float scale, float shift) {
  Glyph glyph;
  int right = 0;
  int bottom = 0;
  const int code = static_cast<int>(letter);
  stbtt_GetCodepointBitmapBoxSubpixel(&font(), code, scale, scale, shift, 0.0F, &glyph.left, &glyph.top,
                                      &right, &bottom);
  glyph.width = right - glyph.left;
  glyph.height = bottom - glyph.top;
  glyph.coverage.resize(static_cast<std::size_t>(glyph.width) * static_cast<std::size_t>(glyph.height));
  if (!glyph.coverage.empty()) {
    stbtt_MakeCodepointBitmapSubpixel(&font(), glyph.coverage.data(), glyph.width, glyph.height, glyph.width,
                                      scale, scale, shift, 0.0F, code);
  }
  return glyph;
}

void blend(Picture& picture, int x, int y, Rgb ink, int coverage) {
  if (coverage == 0 || x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
  const Rgb under = pixel(picture, x, y);
  const auto mixed = [&](int from, int to) {
    return static_cast<std::uint8_t>((from * (255 - coverage) + to * coverage + 127) / 255);
  };
  set_pixel(picture, x, y, {mixed(under.r, ink.r), mixed(under.g, ink.g), mixed(under.b, ink.b)});
}

}  // namespace

Lettering::Lettering(int size) : size_(size) {
  int ascent = 0;
  int descent = 0;
  int gap = 0;
  stbtt_GetFontVMetrics(&font(), &ascent, &descent, &gap);
  scale_ = float(size) / float(ascent - descent);
  ascent_ = float(ascent) * scale_;
}

float Lettering::advance(char32_t letter, char32_t next) const {
  int width = 0;
  int bearing = 0;
  stbtt_GetCodepointHMetrics(&font(), static_cast<int>(letter), &width, &bearing);
  const int kerning =
      next == 0 ? 0
                : stbtt_GetCodepointKernAdvance(&font(), static_cast<int>(letter), static_cast<int>(next));
  return float(width + kerning) * scale_;
}

int Lettering::width(std::string_view text) const {
  const std::u32string letters = letters_of(text);
  float pen = 0.0F;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    pen += advance(letters[i], i + 1 < letters.size() ? letters[i + 1] : 0);
  }
  return static_cast<int>(std::ceil(pen));
}

std::string Lettering::cut_to(std::string_view text, int most) const {
  if (width(text) <= most) return std::string(text);
  std::size_t kept = 0;
  std::string_view rest = text;
  while (!rest.empty()) {
    next_letter(rest);
    const std::size_t longer = text.size() - rest.size();
    if (width(text.substr(0, longer)) > most) break;
    kept = longer;
  }
  return std::string(text.substr(0, kept));
}

void Lettering::draw(Picture& picture, int left, int top, std::string_view text, Rgb ink) const {
  const std::u32string letters = letters_of(text);
  const int baseline = top + static_cast<int>(std::lround(ascent_));
  float pen = 0.0F;  // measured from `left`, so that a text looks the same at every position
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const float whole = std::floor(pen);
    const Glyph glyph = glyph_of(letters[i], scale_, pen - whole);
    for (int y = 0; y < glyph.height; ++y) {
      const int row = baseline + glyph.top + y;
      if (row < top || row >= top + size_) continue;
      for (int x = 0; x < glyph.width; ++x) {
        blend(picture, left + static_cast<int>(whole) + glyph.left + x, row, ink,
              glyph.coverage[static_cast<std::size_t>(y * glyph.width + x)]);
      }
    }
    pen += advance(letters[i], i + 1 < letters.size() ? letters[i + 1] : 0);
  }
}

}  // namespace penumbra::study
