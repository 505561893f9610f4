#include "prosup/core/checksum.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

// The check value that all descriptions of this CRC give.
TEST(Checksum, IsThatOfTheStandard) {
  const TemporaryFolder folder;
  const auto file = text_file(folder / "digits", "123456789");
  EXPECT_EQ(digest_of(file).crc32, 0xcbf43926u);
  EXPECT_EQ(digest_text({file}), "9:cbf43926");
  EXPECT_EQ(digest_of(text_file(folder / "more", "123456789 and more"), 9).crc32, 0xcbf43926u);
  EXPECT_EQ(digest_text({text_file(folder / "empty", "")}), "0:00000000");
}

TEST(Checksum, ReadsFilesOfSeveralBlocks) {
  const TemporaryFolder folder;
  std::string text(5000000, 'a');
  const std::string before = digest_text({text_file(folder / "a", text)});
  text[4500000] = 'b';
  EXPECT_NE(digest_text({text_file(folder / "a", text)}), before);
}

TEST(Checksum, OfSeveralFilesIsThatOfAllTheirBytes) {
  const TemporaryFolder folder;
  const std::vector<std::filesystem::path> parts{text_file(folder / "a", "1234"),
                                                 text_file(folder / "b", ""),
                                                 text_file(folder / "c", "56789")};
  EXPECT_EQ(digest_text(parts), "9:cbf43926");
  EXPECT_EQ(digest_text({}), "0:00000000");
  expect_error([&] { digest_text({parts[0], folder / "missing"}); }, {"missing", "cannot be read"});
}

} // namespace
} // namespace prosup::tests
