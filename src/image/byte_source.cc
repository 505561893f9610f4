#include "byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t n_at_once = 1u << 18; // a multiple of the size of any number

[[noreturn]] void refuse_damaged(const fs::path& file, std::uintmax_t n_read) {
  throw Error(format("'%s' is damaged or incomplete: what it holds cannot be unpacked beyond byte "
                     "%ju; copy it again.",
                     file.string().c_str(), n_read));
}

[[noreturn]] void refuse_unreadable(const fs::path& file) {
  throw Error("'" + file.string() + "' cannot be opened; check its permissions.");
}

class PlainBytes : public ByteSource {
public:
  PlainBytes(const fs::path& file, std::uintmax_t offset) : in_(file, std::ios::binary) {
    if (!in_)
      refuse_unreadable(file);
    in_.seekg(static_cast<std::streamoff>(offset));
  }

  std::size_t read(unsigned char* bytes, std::size_t n) override {
    in_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(n));
    return static_cast<std::size_t>(in_.gcount());
  }

private:
  std::ifstream in_;
};

class UnpackedBytes : public ByteSource {
public:
  explicit UnpackedBytes(const fs::path& file)
      : file_(file), stream_(gzopen(file.c_str(), "rb"), gzclose) {
    if (!stream_)
      refuse_unreadable(file);
  }

  std::size_t read(unsigned char* bytes, std::size_t n) override {
    std::size_t n_read = 0;
    while (n_read < n) {
      const auto wanted = static_cast<unsigned>(std::min(n - n_read, n_at_once));
      const int found = gzread(stream_.get(), bytes + n_read, wanted);
      int error = Z_OK;
      gzerror(stream_.get(), &error);
      if (found < 0 || (found == 0 && error != Z_OK && error != Z_STREAM_END))
        refuse_damaged(file_, n_before_ + n_read);
      n_read += static_cast<std::size_t>(found);
      if (found == 0)
        break;
    }
    n_before_ += n_read;
    return n_read;
  }

private:
  const fs::path file_;
  std::unique_ptr<gzFile_s, int (*)(gzFile)> stream_;
  std::uintmax_t n_before_ = 0;
};

class InflatedBytes : public ByteSource {
public:
  InflatedBytes(const fs::path& file, std::uintmax_t offset)
      : file_(file), packed_(file, offset), buffer_(n_at_once) {
    constexpr int zlib_or_gzip = 15 + 32;
    if (inflateInit2(&stream_, zlib_or_gzip) != Z_OK)
      throw Error("'" + file.string() + "' cannot be unpacked: there is not enough memory.");
  }
  ~InflatedBytes() override { inflateEnd(&stream_); }
  InflatedBytes(const InflatedBytes&) = delete;
  InflatedBytes& operator=(const InflatedBytes&) = delete;

  std::size_t read(unsigned char* bytes, std::size_t n) override {
    std::size_t n_read = 0;
    while (n_read < n && !is_over_) {
      if (stream_.avail_in == 0) {
        stream_.next_in = buffer_.data();
        stream_.avail_in = static_cast<uInt>(packed_.read(buffer_.data(), buffer_.size()));
      }
      const auto wanted = static_cast<uInt>(std::min(n - n_read, n_at_once));
      stream_.next_out = bytes + n_read;
      stream_.avail_out = wanted;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      n_read += wanted - stream_.avail_out;
      is_over_ = status == Z_STREAM_END;
      if (status != Z_OK && !is_over_) // also at the end of the file
        refuse_damaged(file_, stream_.total_out);
    }
    return n_read;
  }

private:
  const fs::path file_;
  PlainBytes packed_;
  std::vector<unsigned char> buffer_;
  z_stream stream_{};
  bool is_over_ = false;
};

} // namespace

void ByteSource::skip(std::uintmax_t n) {
  std::vector<unsigned char> buffer(std::min<std::uintmax_t>(n, n_at_once));
  while (n > 0) {
    const std::size_t found = read(buffer.data(), std::min<std::uintmax_t>(n, buffer.size()));
    if (found == 0)
      return;
    n -= found;
  }
}

std::unique_ptr<ByteSource> plain_bytes(const fs::path& file, std::uintmax_t offset) {
  return std::make_unique<PlainBytes>(file, offset);
}

std::unique_ptr<ByteSource> unpacked_bytes(const fs::path& file) {
  return std::make_unique<UnpackedBytes>(file);
}

std::unique_ptr<ByteSource> inflated_bytes(const fs::path& file, std::uintmax_t offset) {
  return std::make_unique<InflatedBytes>(file, offset);
}

bool is_gzip(const fs::path& file) {
  unsigned char bytes[2];
  return PlainBytes(file, 0).read(bytes, 2) == 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

std::uintmax_t most_bytes(std::uintmax_t n_stored, bool is_packed) {
  constexpr std::uintmax_t most_per_byte = 1032; // of the method of zlib and gzip
  return saturated_product({n_stored, is_packed ? most_per_byte : 1});
}

std::vector<float> read_values(ByteSource& source, const StoredValues& stored,
                               std::uintmax_t n_numbers, const fs::path& file) {
  std::vector<float> values;
  values.reserve(n_numbers);
  std::vector<unsigned char> buffer(n_at_once);
  const std::size_t size = stored.bytes_per_number();
  while (values.size() < n_numbers) {
    const std::uintmax_t missing = (n_numbers - values.size()) * size;
    const std::size_t wanted = std::min<std::uintmax_t>(missing, n_at_once);
    const std::size_t found = source.read(buffer.data(), wanted);
    stored.append(buffer.data(), found / size, values);
    if (found < wanted)
      refuse_incomplete(file, values.size() * size, n_numbers * size);
  }
  return values;
}

void refuse_incomplete(const fs::path& file, std::uintmax_t found, std::uintmax_t expected) {
  throw Error(format("'%s' is damaged or incomplete: it holds %ju of %ju bytes of voxels; copy it "
                     "again.",
                     file.string().c_str(), found, expected));
}

} // namespace prosup::image
