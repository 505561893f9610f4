#include "meta_fields.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::image {

namespace {

constexpr const char* last_name = "ElementDataFile";

std::optional<double> number_of(const std::string& word) {
  const char* first = word.data() + (word[0] == '+' ? 1 : 0);
  const char* last = word.data() + word.size();
  double value = 0.;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value))
    return {};
  return value;
}

} // namespace

MetaFields::MetaFields(const std::string& text, std::string file) : file_(std::move(file)) {
  while (!has(last_name)) {
    const std::size_t end = text.find('\n', length_);
    const std::string line = text.substr(length_, end - length_);
    if (length_ >= text.size())
      refuse(std::string("has no line '") + last_name + " = ...'");
    length_ = end == std::string::npos ? text.size() : end + 1;
    if (trimmed(line).empty())
      continue;
    const std::size_t separator = line.find_first_of("=:");
    if (separator == std::string::npos)
      refuse("has the line '" + trimmed(line).substr(0, 40) + "', which is not 'Name = value'");
    values_[trimmed(line.substr(0, separator))] = trimmed(line.substr(separator + 1));
  }
}

void MetaFields::refuse(const std::string& what) const {
  throw Error("The MetaImage header of '" + file_ + "' " + what +
              "; correct it or save the image again.");
}

std::string MetaFields::text(const std::string& name) const {
  const auto value = values_.find(name);
  return value == values_.end() ? std::string() : value->second;
}

bool MetaFields::flag(const std::string& name, bool otherwise) const {
  const std::string value = text(name);
  if (value.empty())
    return otherwise;
  const std::string yes = "Tt1", no = "Ff0";
  if (yes.find(value[0]) == std::string::npos && no.find(value[0]) == std::string::npos)
    refuse("has '" + name + " = " + value + "', where True and False are allowed");
  return yes.find(value[0]) != std::string::npos;
}

std::optional<std::vector<double>> MetaFields::numbers(const std::string& name,
                                                       std::size_t n) const {
  if (!has(name))
    return {};
  std::vector<double> values;
  std::istringstream words(text(name));
  for (std::string word; words >> word;) {
    const std::optional<double> value = number_of(word);
    if (!value)
      refuse("has '" + word + "' in " + name + ", which is no number");
    values.push_back(*value);
  }
  if (values.size() != n)
    refuse(format("has %zu numbers in %s, where %zu are needed", values.size(), name.c_str(), n));
  return values;
}

std::optional<double> MetaFields::number(const std::string& name) const {
  const auto values = numbers(name, 1);
  return values ? std::optional<double>(values->front()) : std::nullopt;
}

std::optional<std::vector<double>> MetaFields::numbers(const std::vector<std::string>& names,
                                                       std::size_t n) const {
  std::optional<std::vector<double>> found;
  std::string found_name;
  for (const std::string& name : names) {
    const auto values = numbers(name, n);
    if (values && found && *values != *found)
      refuse("has different numbers in " + found_name + " and " + name + ", which mean the same");
    if (values && !found) {
      found = values;
      found_name = name;
    }
  }
  return found;
}

} // namespace prosup::image
