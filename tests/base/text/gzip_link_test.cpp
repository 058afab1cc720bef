#include "base/text/gzip_link.hpp"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <rapidcheck.h>
#include <zlib.h>

#include <string>

namespace palpate::base {
namespace {

constexpr std::string_view kBegin = "data:application/gzip;base64,";

std::string opened(const std::string& link, std::size_t size) {
  const std::string text = link.substr(kBegin.size());
  std::string packed(text.size() / 4 * 3 + 1, '\0');
  const int length =
      EVP_DecodeBlock(reinterpret_cast<unsigned char*>(packed.data()),
                      reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  EXPECT_GT(length, 0);
  std::string plain(size + 1, '\0');
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_in = static_cast<uInt>(length);
  stream.next_out = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  plain.resize(stream.total_out);
  inflateEnd(&stream);
  return plain;
}

TEST(GzipLink, OpensToTheText) {
  EXPECT_TRUE(rc::check([](const std::string& text) {
    const std::string link = gzip_link(text);
    RC_ASSERT(link.starts_with(kBegin));
    RC_ASSERT(opened(link, text.size()) == text);
  }));
}

}  // namespace
}  // namespace palpate::base
