#include "sim/view/image.hpp"

#include <gmock/gmock.h>
#include <jpeglib.h>
#include <png.h>

#include <cstdio>
#include <cstdlib>

namespace palpate::sim {
namespace {

/// Smooth colours, every level of red in it.
Image gradient() {
  Image image{.width = 256, .height = 64};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (const int level : {x, 4 * y, (x + y) / 2}) image.rgb.push_back(static_cast<std::uint8_t>(level));
  return image;
}

TEST(EncodePng, DecodesToTheSamePixels) {
  const Image image = gradient();
  const std::string bytes = encode_png(image);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()), 0) << png.message;
  EXPECT_EQ(png.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  Image decoded{.width = static_cast<int>(png.width), .height = static_cast<int>(png.height)};
  decoded.rgb.resize(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, decoded.rgb.data(), 0, nullptr), 0) << png.message;
  EXPECT_EQ(decoded.width, image.width);
  EXPECT_EQ(decoded.height, image.height);
  EXPECT_EQ(decoded.rgb, image.rgb);
}

TEST(EncodeJpeg, DecodesToNearlyTheSamePixels) {
  const Image image = gradient();
  std::string bytes = encode_jpeg(image);
  jpeg_error_mgr errors{};
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&errors);  // ends the test program with a message if the bytes are no JPEG
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  jpeg_start_decompress(&jpeg);
  ASSERT_EQ(static_cast<int>(jpeg.output_width), image.width);
  ASSERT_EQ(static_cast<int>(jpeg.output_height), image.height);
  ASSERT_EQ(jpeg.output_components, 3);
  std::vector<std::uint8_t> rgb(image.rgb.size());
  while (jpeg.output_scanline < jpeg.output_height) {
    JSAMPROW row = &rgb[3 * jpeg.output_width * jpeg.output_scanline];
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_destroy_decompress(&jpeg);
  double sum = 0.0;
  for (std::size_t i = 0; i < rgb.size(); ++i) sum += std::abs(rgb[i] - image.rgb[i]);
  EXPECT_LT(sum / static_cast<double>(rgb.size()), 3.0);  // levels of 255; a colour out of place gives tens
}

}  // namespace
}  // namespace palpate::sim
