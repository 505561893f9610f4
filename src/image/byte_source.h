#ifndef PROSUP_SRC_IMAGE_BYTE_SOURCE_H
#define PROSUP_SRC_IMAGE_BYTE_SOURCE_H

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "stored_values.h"

namespace prosup::image {

/// Bytes of a file, in turn. Errors name the file.
class ByteSource {
public:
  virtual ~ByteSource() = default;

  /// Up to `n` bytes; fewer only at the end. @throws Error if the file is damaged.
  virtual std::size_t read(unsigned char* bytes, std::size_t n) = 0;

  /// Leaves out `n` bytes, or all if there are fewer.
  void skip(std::uintmax_t n);
};

/// A file as it is, from byte `offset` on.
std::unique_ptr<ByteSource> plain_bytes(const std::filesystem::path& file,
                                        std::uintmax_t offset = 0);

/// A file unpacked if it is a gzip file, whatever its name, or else as it is.
std::unique_ptr<ByteSource> unpacked_bytes(const std::filesystem::path& file);

/// What was packed by zlib or gzip into a file from byte `offset` on.
std::unique_ptr<ByteSource> inflated_bytes(const std::filesystem::path& file,
                                           std::uintmax_t offset);

/// How many bytes `n_stored` can at most be unpacked to; as many if they are not packed.
std::uintmax_t most_bytes(std::uintmax_t n_stored, bool is_packed);

/// Whether a file is a gzip file by its first bytes.
bool is_gzip(const std::filesystem::path& file);

/// What the next `n_numbers` mean, which fill the voxels of `file`; memory for all is taken at
/// once, so that most_bytes() has to be asked before. @throws Error if there are fewer.
std::vector<float> read_values(ByteSource& source, const StoredValues& stored,
                               std::uintmax_t n_numbers, const std::filesystem::path& file);

/// @throws Error that tells how much of `file` is there.
[[noreturn]] void refuse_incomplete(const std::filesystem::path& file, std::uintmax_t found,
                                    std::uintmax_t expected);

} // namespace prosup::image

#endif
