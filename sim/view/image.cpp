#include "sim/view/image.hpp"

#include <jpeglib.h>
#include <png.h>

#include <cassert>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it, and does not include it
#include <cstdlib>
#include <stdexcept>

namespace palpate::sim {
namespace {

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngWriter()
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr)),
        info(png == nullptr ? nullptr : png_create_info_struct(png)) {
    if (info == nullptr) throw std::runtime_error("PNG: no memory");
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  [[noreturn]] static void fail(png_structp, png_const_charp message) {
    throw std::runtime_error(std::string("PNG: ") + message);
  }
  static void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
  }
};

[[noreturn]] void jpeg_fail(j_common_ptr jpeg) {
  char message[JMSG_LENGTH_MAX];
  jpeg->err->format_message(jpeg, message);
  throw std::runtime_error(std::string("JPEG: ") + message);
}

struct JpegWriter {
  jpeg_error_mgr errors{};
  jpeg_compress_struct jpeg{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  JpegWriter() {
    jpeg.err = jpeg_std_error(&errors);
    errors.error_exit = jpeg_fail;
    jpeg_create_compress(&jpeg);
  }
  ~JpegWriter() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }
  JpegWriter(const JpegWriter&) = delete;
  JpegWriter& operator=(const JpegWriter&) = delete;
};

const std::uint8_t* row_of(const Image& image, int row) {
  return image.rgb.data() + 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(row);
}

}  // namespace

std::string encode_png(const Image& image) {
  assert(image.rgb.size() ==
         3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  std::string bytes;
  PngWriter writer;
  png_set_write_fn(writer.png, &bytes, PngWriter::append, nullptr);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png, writer.info);
  for (int row = 0; row < image.height; ++row) png_write_row(writer.png, row_of(image, row));
  png_write_end(writer.png, nullptr);
  return bytes;
}

std::string encode_jpeg(const Image& image, int quality) {
  assert(image.rgb.size() ==
         3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  JpegWriter writer;
  jpeg_mem_dest(&writer.jpeg, &writer.bytes, &writer.size);
  writer.jpeg.image_width = static_cast<JDIMENSION>(image.width);
  writer.jpeg.image_height = static_cast<JDIMENSION>(image.height);
  writer.jpeg.input_components = 3;
  writer.jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&writer.jpeg);
  jpeg_set_quality(&writer.jpeg, quality, TRUE);
  jpeg_start_compress(&writer.jpeg, TRUE);
  for (int row = 0; row < image.height; ++row) {
    JSAMPROW pointer = const_cast<JSAMPROW>(row_of(image, row));  // libjpeg reads it only
    jpeg_write_scanlines(&writer.jpeg, &pointer, 1);
  }
  jpeg_finish_compress(&writer.jpeg);
  return std::string(reinterpret_cast<const char*>(writer.bytes), writer.size);
}

}  // namespace palpate::sim
