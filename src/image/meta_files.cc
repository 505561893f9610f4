#include "meta_files.h"

#include <charconv>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

namespace fs = std::filesystem;

namespace {

constexpr long most_files = 100000;

std::optional<long> number_of(const std::string& word) {
  long value = 0;
  const char* last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  return error == std::errc() && end == last ? std::optional<long>(value) : std::nullopt;
}

/// Cuts the last word off if it is a number.
std::optional<long> cut_number(std::string& text) {
  const std::size_t blank = text.find_last_of(" \t");
  if (blank == std::string::npos)
    return {};
  const auto number = number_of(text.substr(blank + 1));
  if (number)
    text.resize(text.find_last_not_of(" \t", blank) + 1);
  return number;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    if (!line.empty())
      lines.push_back(line);
  }
  return lines;
}

void check(const std::vector<fs::path>& files, std::size_t n_needed, const fs::path& header) {
  if (n_needed != files.size())
    throw Error(format("'%s' names %zu files of voxels, but has %zu slices; complete the list or "
                       "correct DimSize.",
                       header.string().c_str(), files.size(), n_needed));
}

} // namespace

std::vector<std::string> names_of_pattern(const std::string& text) {
  std::string name = text;
  std::vector<long> numbers; // from the last to the first
  while (numbers.size() < 3)
    if (const auto number = cut_number(name))
      numbers.push_back(*number);
    else
      break;
  if (numbers.size() < 2)
    return {};
  const long first = numbers.back(), last = numbers[numbers.size() - 2];
  const long step = numbers.size() == 3 ? numbers.front() : 1;
  const std::size_t percent = name.find('%');
  const std::size_t kind = name.find_first_not_of("0123456789", percent + 1);
  if (percent == std::string::npos || kind == std::string::npos ||
      (name[kind] != 'd' && name[kind] != 'i' && name[kind] != 'u') ||
      name.find('%', kind) != std::string::npos || first < 0 || step < 1 || last < first ||
      (last - first) / step >= most_files)
    return {};
  const std::string width = name.substr(percent + 1, kind - percent - 1);
  const char filler = !width.empty() && width[0] == '0' ? '0' : ' ';
  const auto n_digits = static_cast<std::size_t>(number_of(width).value_or(0));
  if (n_digits > 20)
    return {};
  std::vector<std::string> names;
  for (long number = first; number <= last; number += step) {
    std::string digits = std::to_string(number);
    if (digits.size() < n_digits)
      digits.insert(0, n_digits - digits.size(), filler);
    names.push_back(name.substr(0, percent) + digits + name.substr(kind + 1));
  }
  return names;
}

std::vector<fs::path> voxel_files(const MetaHeader& header, const std::string& behind,
                                  const fs::path& file) {
  if (header.is_local())
    return {file};
  // A file of that very name is meant, whatever signs are in it.
  const fs::path literal = file.parent_path() / header.data_file;
  std::vector<fs::path> files;
  if (fs::is_regular_file(literal)) {
    files = {literal};
  } else if (header.data_file.compare(0, 4, "LIST") == 0) {
    for (const std::string& name : lines_of(behind))
      files.push_back(file.parent_path() / name);
    // "LIST 3" stands for files of three dimensions each, and "LIST" for slices.
    const bool of_volumes = header.data_file.find('3') != std::string::npos;
    check(files, of_volumes ? 1 : header.size[2], file);
  } else {
    for (const std::string& name : names_of_pattern(header.data_file))
      files.push_back(file.parent_path() / name);
    if (!files.empty())
      check(files, header.size[2], file);
    else
      files = {literal};
  }
  for (const fs::path& data : files)
    if (!fs::is_regular_file(data))
      throw Error(format("'%s' names '%s' as the file of its voxels, which does not exist; copy it "
                         "too.",
                         file.string().c_str(), data.string().c_str()));
  return files;
}

} // namespace prosup::image
