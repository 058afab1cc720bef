#include "sim/view/freetype.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>

namespace palpate::sim {
namespace {

constexpr const char* kFreeTypeFile = "libfreetype.so.6";

template <class Function>
void find_in_freetype(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (function == nullptr)
    throw std::runtime_error(fmt::format("no words can be drawn: {} has no {}", kFreeTypeFile, name));
}

FreeType load() {
  void* file = ::dlopen(kFreeTypeFile, RTLD_NOW | RTLD_LOCAL);
  if (file == nullptr)
    throw std::runtime_error(
        fmt::format("no words can be drawn: {} cannot be loaded ({}); it is in the package libfreetype6",
                    kFreeTypeFile, ::dlerror()));  // NOLINT(concurrency-mt-unsafe): glibc keeps one a thread
  FreeType loaded;
  decltype(&::FT_Init_FreeType) begin = nullptr;
  find_in_freetype(file, "FT_Init_FreeType", begin);
  find_in_freetype(file, "FT_New_Face", loaded.new_face);
  find_in_freetype(file, "FT_Set_Pixel_Sizes", loaded.set_pixel_sizes);
  find_in_freetype(file, "FT_Load_Char", loaded.load_char);
  find_in_freetype(file, "FT_Done_Face", loaded.done_face);
  if (begin(&loaded.library) != 0) throw std::runtime_error("no words can be drawn: FreeType does not start");
  return loaded;
}

}  // namespace

const FreeType& freetype() {
  static const FreeType loaded = load();
  return loaded;
}

}  // namespace palpate::sim
