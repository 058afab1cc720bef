#include "sim/view/freetype.hpp"

#include <stdexcept>

#include "base/machine/shared_library.hpp"

namespace palpate::sim {
namespace {

FreeType load() {
  const base::SharedLibrary library("libfreetype.so.6", "libfreetype6", "no words can be drawn");
  FreeType loaded;
  decltype(&::FT_Init_FreeType) begin = nullptr;
  library.find("FT_Init_FreeType", begin);
  library.find("FT_New_Face", loaded.new_face);
  library.find("FT_Set_Pixel_Sizes", loaded.set_pixel_sizes);
  library.find("FT_Load_Char", loaded.load_char);
  library.find("FT_Done_Face", loaded.done_face);
  if (begin(&loaded.library) != 0) throw std::runtime_error("no words can be drawn: FreeType does not start");
  return loaded;
}

}  // namespace

const FreeType& freetype() {
  static const FreeType loaded = load();
  return loaded;
}

}  // namespace palpate::sim
