#include "nrrd_data.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <regex>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::image {

namespace {

namespace fs = std::filesystem;

/// The names that "slice%03d.raw 1 20 1" stands for. The number in it becomes a format of printf in
/// ITK, so that nothing but a plain one may pass.
std::vector<std::string> numbered_names(const std::string& value, const fs::path& file) {
  static const std::regex pattern(
      "([^%]*)%0?([0-9]?)d([^%]*) +(-?[0-9]{1,9}) +(-?[0-9]{1,9}) +(-?[0-9]{1,9})( +[0-9]+)?");
  constexpr long largest_number_of_files = 100000;
  std::smatch parts;
  if (value.size() > 4096 || !std::regex_match(value, parts, pattern))
    refuse_nrrd_header(file.string(), "has 'data file: " + value.substr(0, 60) +
                                          "', which is not of the form 'name%03d.raw 1 20 1'");
  const long first = std::stol(parts[4]), last = std::stol(parts[5]), step = std::stol(parts[6]);
  const bool zeros = value[value.find('%') + 1] == '0';
  const int width = parts[2].length() == 0 ? 0 : std::stoi(parts[2]);
  if (step == 0 || (last - first) / step < 0 || (last - first) / step > largest_number_of_files)
    refuse_nrrd_header(file.string(),
                       "has 'data file: " + value.substr(0, 60) + "', which names no files");
  std::vector<std::string> names;
  for (long n = first; step > 0 ? n <= last : n >= last; n += step)
    names.push_back(parts[1].str() + format(zeros ? "%0*ld" : "%*ld", width, n) + parts[3].str());
  return names;
}

/// The length of the data that gzip packed from `offset` on, up to a bit more than is `needed`.
std::uintmax_t unpacked_length(const fs::path& file, std::uintmax_t offset, std::uintmax_t needed) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const bool placed = descriptor >= 0 && lseek(descriptor, off_t(offset), SEEK_SET) >= 0;
  const gzFile stream = placed ? gzdopen(descriptor, "rb") : nullptr;
  if (stream == nullptr && descriptor >= 0)
    close(descriptor);
  std::vector<unsigned char> buffer(1u << 18);
  std::uintmax_t found = 0;
  int n_read = 0;
  while (stream != nullptr && found <= needed &&
         (n_read = gzread(stream, buffer.data(), unsigned(buffer.size()))) > 0)
    found += unsigned(n_read);
  // The checksum is compared at the end of the data, and closing tells whether that was there.
  const int closed = stream != nullptr ? gzclose(stream) : Z_STREAM_ERROR;
  if (stream == nullptr || n_read < 0 || (n_read == 0 && closed != Z_OK))
    throw Error(
        format("'%s' is damaged or incomplete: its data end after %ju bytes; copy it again.",
               file.string().c_str(), found));
  return found;
}

/// Skipping lines or bytes leads to data whose length is not compared.
bool skips(const NrrdHeader& header) {
  return !header.field("line skip").empty() || !header.field("byte skip").empty();
}

/// The number of bytes, unpacked, that a file has from `offset` on.
std::uintmax_t length(const NrrdHeader& header, const fs::path& file, std::uintmax_t offset,
                      std::uintmax_t needed) {
  const std::string encoding = lower_case(header.field("encoding"));
  if ((encoding == "gzip" || encoding == "gz") && !skips(header))
    return unpacked_length(file, offset, needed);
  return fs::file_size(file) - offset;
}

/// The least number of bytes in which `n_bytes` of voxels are encoded.
std::uintmax_t least_bytes(const NrrdHeader& header, std::uintmax_t n_bytes, const fs::path& file) {
  const std::string encoding = lower_case(header.field("encoding"));
  if (encoding == "raw" || encoding == "hex")
    return n_bytes; // hex needs twice as many
  if (encoding == "gzip" || encoding == "gz")
    return skips(header) ? 0 : n_bytes;
  if (encoding == "ascii" || encoding == "text" || encoding == "txt")
    return n_bytes / 8; // a digit for each value of 8 bytes
  if (encoding == "bzip2" || encoding == "bz2")
    throw Error(
        format("'%s' is packed by bzip2, which cannot be read; save it with 'encoding: gzip' "
               "or 'encoding: raw'.",
               file.string().c_str()));
  refuse_nrrd_header(file.string(), "has the encoding '" + encoding.substr(0, 40) +
                                        "', which is none of raw, gzip, ascii and hex");
}

} // namespace

std::vector<fs::path> nrrd_data_files(const NrrdHeader& header, const fs::path& file) {
  const std::string value = header.field("data file");
  std::vector<std::string> names = header.data_files;
  static const std::regex numbered(".*%[^ ]*d.* +-?[0-9]+ +-?[0-9]+ +-?[0-9]+.*");
  const bool is_list = lower_case(value.substr(0, 4)) == "list";
  if (is_list && names.empty())
    refuse_nrrd_header(file.string(), "has 'data file: LIST', but no names of files behind it");
  if (!is_list && value.size() < 4096 && std::regex_match(value, numbered))
    names = numbered_names(value, file);
  else if (!is_list && !value.empty())
    names = {value};
  std::vector<fs::path> result;
  for (const std::string& name : names) {
    const fs::path data = file.parent_path() / trimmed(name);
    std::error_code ignored;
    if (!fs::is_regular_file(data, ignored))
      throw Error(format("'%s' names '%s' as a file of its voxels, which does not exist; copy it "
                         "too.",
                         file.string().c_str(), data.string().c_str()));
    result.push_back(data);
  }
  return result;
}

void check_nrrd_data(const NrrdHeader& header, const fs::path& file) {
  const std::uintmax_t needed = least_bytes(header, n_data_bytes(header, file.string()), file);
  const std::vector<fs::path> files = nrrd_data_files(header, file);
  std::uintmax_t found = files.empty() ? length(header, file, header.length, needed) : 0;
  for (const fs::path& data : files)
    found += length(header, data, 0, needed);
  if (found < needed)
    throw Error(
        format("'%s' is damaged or incomplete: its voxels need at least %ju bytes, but there "
               "are %ju; copy it again.",
               file.string().c_str(), needed, found));
}

} // namespace prosup::image
