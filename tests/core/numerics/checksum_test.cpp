#include "core/numerics/checksum.h"

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

// Values by the definition in integers of any size (Python).
TEST(ChecksumTest, HasTheValuesThatFilesKeep) {
  Checksum words, bytes;
  EXPECT_EQ(words.text(), "cbf29ce484222325");
  words.add("alltact!", 8);
  bytes.add("abc", 3);
  EXPECT_EQ(words.text(), "d1b3749784a3c41b");
  EXPECT_EQ(bytes.text(), "3be5b87edc91fa43");
}

TEST(ChecksumTest, NoticesEveryBitOfAPicture) {
  std::string image(1003, '\x40');
  Checksum before;
  before.add(image.data(), image.size());
  for (std::size_t at = 0; at < image.size(); at += 13)
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = image;
      other[at] = static_cast<char>(other[at] ^ (1 << bit));
      Checksum after;
      after.add(other.data(), other.size());
      EXPECT_NE(after.value(), before.value()) << at << " " << bit;
    }
}

}  // namespace
}  // namespace alltact::test
