#include "csv_records.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "text_input.h"

namespace prosup::evaluation::csv {

namespace {

/// Takes one record after the other from a text.
class Scanner {
public:
  Scanner(const std::string& text, const std::string& name) : text_(text), name_(name) {}

  bool at_end() const { return at_ >= text_.size(); }

  Record next() {
    Record record{{}, line_, {}};
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string line = trimmed(text_.substr(at_, end - at_));
    // A comment may hold a lone quote, which must not swallow the lines behind it.
    const bool is_comment = !line.empty() && line[0] == '#';
    if (is_comment)
      record.comment = line;
    bool more = true;
    while (more)
      more = take_value(record.values, !is_comment);
    return record;
  }

private:
  /// @returns whether the record goes on behind the value.
  bool take_value(std::vector<std::string>& values, bool quotes) {
    std::string value;
    bool in_quotes = false;
    std::size_t opened = line_;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n')
        ++line_;
      if (in_quotes && c == '"' && at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
        value += c;
        ++at_;
      } else if (in_quotes && c == '"') {
        in_quotes = false;
      } else if (in_quotes) {
        value += c;
      } else if (quotes && c == '"' && trimmed(value).empty()) {
        in_quotes = true;
        opened = line_;
        value.clear();
      } else if (c == ',' || c == '\n') {
        ++at_;
        values.push_back(trimmed(value));
        return c == ',';
      } else {
        value += c;
      }
    }
    if (in_quotes)
      throw Error("In " + where(name_, opened) +
                  ": a quotation mark is opened and never closed; close it, or remove it.");
    values.push_back(trimmed(value));
    return false;
  }

  const std::string& text_;
  const std::string& name_;
  std::size_t at_ = 0, line_ = 1;
};

} // namespace

bool Record::is_blank() const {
  return std::all_of(values.begin(), values.end(), [](const auto& value) { return value.empty(); });
}

bool Record::names_separator() const {
  return values.size() == 2 && lower_case(values[0]) == "sep=" && values[1].empty();
}

std::vector<Record> records(const std::string& text, const std::string& name) {
  if (text.find('\n') == std::string::npos && trimmed(text).find('\r') != std::string::npos)
    throw Error("The lines of the file '" + name +
                "' end with carriage returns only, as on old Macintosh computers; save it with the "
                "line ends of Unix or Windows.");
  std::vector<Record> result;
  for (Scanner scanner(text, name); !scanner.at_end();) {
    Record record = scanner.next();
    // A spreadsheet leaves lines of separators behind where rows were deleted.
    if (!record.is_blank())
      result.push_back(std::move(record));
  }
  return result;
}

bool comment_value(const std::string& comment, const std::string& key, std::string& value) {
  const auto separator = comment.find_first_of("=:");
  if (comment.empty() || separator == std::string::npos)
    return false;
  if (lower_case(trimmed(comment.substr(1, separator - 1))) != lower_case(key))
    return false;
  value = trimmed(comment.substr(separator + 1));
  return true;
}

} // namespace prosup::evaluation::csv
