#pragma once

// What is called of FreeType. It is loaded when something is written: a statistic needs none of it.
#include <ft2build.h>
#include FT_FREETYPE_H

namespace palpate::sim {

struct FreeType {
  FT_Library library = nullptr;
  decltype(&::FT_New_Face) new_face = nullptr;
  decltype(&::FT_Set_Pixel_Sizes) set_pixel_sizes = nullptr;
  decltype(&::FT_Load_Char) load_char = nullptr;
  decltype(&::FT_Done_Face) done_face = nullptr;
};

/// Loaded at the first call, and kept. Throws std::runtime_error that names the package where it cannot be had.
const FreeType& freetype();

}  // namespace palpate::sim
