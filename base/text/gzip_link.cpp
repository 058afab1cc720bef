#include "base/text/gzip_link.hpp"

#include <openssl/evp.h>
#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace palpate::base {
namespace {

std::string gzip(std::string_view text) {
  constexpr int kWindow = 15, kGzip = 16, kMemory = 9;
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWindow + kGzip, kMemory, Z_DEFAULT_STRATEGY) !=
      Z_OK)
    throw std::runtime_error("zlib refused to begin a compression");
  std::string packed(deflateBound(&stream, text.size()), '\0');
  std::string source(text);  // zlib takes no constant bytes
  stream.next_in = reinterpret_cast<Bytef*>(source.data());
  stream.avail_in = static_cast<uInt>(source.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int done = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (done != Z_STREAM_END) throw std::runtime_error("zlib refused to compress a text");
  return packed;
}

std::string base64(const std::string& bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // OpenSSL ends it with a 0
  const int length =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  if (length < 0) throw std::runtime_error("OpenSSL refused to encode a text");
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace

std::string gzip_link(std::string_view text) {
  if (text.size() > std::numeric_limits<int>::max() / 2)
    throw std::runtime_error("a table is too large to stand inside a page");
  return "data:application/gzip;base64," + base64(gzip(text));
}

}  // namespace palpate::base
