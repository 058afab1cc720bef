#pragma once

#include <memory>
#include <string_view>

#include "sim/view/image.hpp"
#include "sim/view/picture.hpp"

namespace palpate::sim {

/// Writes words into pictures, with FreeType, which is loaded when something is written.
class Lettering {
 public:
  /// @param size  of the letters [pixel], 6 to 400
  /// Throws std::runtime_error that names the package where FreeType or its font cannot be had.
  explicit Lettering(int size);
  ~Lettering();
  Lettering(const Lettering&) = delete;
  Lettering& operator=(const Lettering&) = delete;

  int size() const;

  /// Of a text in UTF-8 [pixel].
  int width(std::string_view text) const;

  /// @param left, baseline  where the first letter stands [pixel from the upper left corner]; what lies outside
  /// the image is left out
  void write(Image& image, std::string_view text, int left, int baseline, const Colour& colour) const;

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace palpate::sim
