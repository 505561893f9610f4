#include "nrrd_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/text.h"

namespace prosup::image {

namespace {

/// Values of keys hold line ends as "\n" and backslashes as "\\".
std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t c = 0; c < text.size(); ++c) {
    const bool escape = text[c] == '\\' && c + 1 < text.size();
    if (escape && text[c + 1] == 'n')
      result += '\n';
    else if (escape && text[c + 1] == '\\')
      result += '\\';
    else {
      result += text[c];
      continue;
    }
    ++c;
  }
  return result;
}

template <typename Number>
std::optional<Number> number(const std::string& text) {
  Number value{};
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc() || end != last)
    return {};
  return value;
}

/// "(1,0,0) none (0, 1, 0)" as {"1,0,0", "none", "0, 1, 0"}.
std::vector<std::string> vectors(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != std::string::npos;) {
    const bool in_brackets = text[at] == '(';
    const std::size_t first = in_brackets ? at + 1 : at;
    const std::size_t end = std::min(
        in_brackets ? text.find(')', first) : text.find_first_of(" \t(", first), text.size());
    result.push_back(text.substr(first, end - first));
    at = std::min(in_brackets ? end + 1 : end, text.size());
  }
  return result;
}

[[noreturn]] void refuse_vector(const std::string& text, const std::string& field,
                                const std::string& file) {
  refuse_nrrd_header(file, "has '(" + text.substr(0, 60) + ")' in '" + field +
                               "', which are no three numbers");
}

/// Three numbers; in a space with time there is a fourth, which is left out.
std::array<double, 3> vector(const std::string& text, const std::string& field,
                             const std::string& file) {
  std::vector<double> values;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto value = number<double>(trimmed(part));
    // No arithmetic of a breast is exact beyond a kilometre; in micrometres it is 1e9.
    if (!value || !(std::abs(*value) <= 1e9))
      refuse_vector(text, field, file);
    values.push_back(*value);
  }
  if (values.size() != 3 && values.size() != 4)
    refuse_vector(text, field, file);
  return {values[0], values[1], values[2]};
}

/// Takes the lines of a header one by one.
void read_line(NrrdHeader& header, const std::string& line, const std::string& file) {
  const bool in_list = lower_case(header.field("data file").substr(0, 4)) == "list";
  if (in_list) {
    header.data_files.push_back(line);
    return;
  }
  const std::size_t key = line.find(":="), field = line.find(": ");
  if (key != std::string::npos && key < field) {
    header.keys[unescaped(line.substr(0, key))] = unescaped(line.substr(key + 2));
    return;
  }
  if (field == std::string::npos && (line.empty() || line.back() != ':'))
    refuse_nrrd_header(file, "has the line '" + line.substr(0, 40) +
                                 "', which is neither a field nor a key");
  const std::size_t colon = std::min(field, line.size() - 1);
  std::string name = lower_case(trimmed(line.substr(0, colon)));
  if (name == "datafile")
    name = "data file";
  if (!header.fields.emplace(name, trimmed(line.substr(colon + 1))).second)
    refuse_nrrd_header(file, "has the field '" + name + "' twice");
}

void read_axes(NrrdHeader& header, const std::string& file) {
  const auto dimension = number<unsigned>(header.field("dimension"));
  if (!dimension || *dimension < 1 || *dimension > 16)
    refuse_nrrd_header(file, "has no valid field 'dimension'");
  std::istringstream sizes(header.field("sizes"));
  for (std::string text; sizes >> text;) {
    const auto size = number<std::size_t>(text);
    if (!size || *size < 1)
      refuse_nrrd_header(file, "has the size '" + text + "', which is no positive number");
    header.axes.push_back({*size, {}});
  }
  if (header.axes.size() != *dimension)
    refuse_nrrd_header(file, "has " + std::to_string(header.axes.size()) +
                                 " sizes for its dimension of " + std::to_string(*dimension));
  const std::vector<std::string> directions = vectors(header.field("space directions"));
  if (!directions.empty() && directions.size() != header.axes.size())
    refuse_nrrd_header(file, "has " + std::to_string(directions.size()) + " space directions for " +
                                 std::to_string(header.axes.size()) + " axes");
  for (std::size_t a = 0; a < directions.size(); ++a)
    if (lower_case(trimmed(directions[a])) != "none") {
      const auto direction = vector(directions[a], "space directions", file);
      if (direction != std::array<double, 3>{0., 0., 0.} || a < 3) // a later one may be time
        header.axes[a].direction = direction;
    }
}

} // namespace

void refuse_nrrd_header(const std::string& file, const std::string& what) {
  throw Error("The NRRD header of '" + file + "' " + what +
              "; correct it or save the image again.");
}

std::string NrrdHeader::field(const std::string& name) const {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string() : found->second;
}

NrrdHeader parse_nrrd_header(const std::string& text, const std::string& file) {
  NrrdHeader header;
  if (text.compare(0, 6, "NRRD00") != 0)
    refuse_nrrd_header(file, "does not begin with NRRD00 and a version");
  bool is_first = true;
  for (std::size_t at = 0; at < text.size() && !header.ends; is_first = false) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    at = end + 1;
    header.length = std::min(at, text.size());
    header.ends = line.empty();
    if (!is_first && !line.empty() && line[0] != '#')
      read_line(header, line, file);
  }
  read_axes(header, file);
  if (!header.field("space origin").empty())
    header.origin = vector(vectors(header.field("space origin"))[0], "space origin", file);
  return header;
}

} // namespace prosup::image
