#include "prosup/output/result_table.h"

#include <algorithm>
#include <map>

#include "html.h"
#include "prosup/core/csv_cell.h"
#include "prosup/core/error.h"
#include "prosup/core/file_system.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "summary_json.h"

namespace prosup::output {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr const char *finished = "finished", *unfinished = "unfinished", *unreadable = "unreadable";

/// Of the last step that was evaluated, which is where the errors of a registration stand.
std::string last_step(const Json& summary) {
  for (const char* step : {"image_forces", "material", "unloaded"})
    if (summary.contains(Json::json_pointer("/tre") / step))
      return std::string("/tre/") + step;
  return "/tre";
}

const std::string last_error = "LAST";

std::optional<double> number(const Json& summary, std::string pointer) {
  if (pointer.rfind(last_error, 0) == 0)
    pointer.replace(0, last_error.size(), last_step(summary));
  const Json::json_pointer place(pointer);
  if (!summary.contains(place) || !summary.at(place).is_number())
    return {};
  return summary.at(place).get<double>();
}

std::string words(const Json& summary, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  return summary.contains(place) && summary.at(place).is_string()
             ? one_printable_line(summary.at(place).get<std::string>())
             : std::string();
}

/// One sentence on why there is no summary.json.
std::string why_unfinished(const fs::path& folder) {
  std::error_code ignored;
  const fs::path target = without_links(folder), parent = target.parent_path();
  const std::string name = target.filename().string();
  if (fs::exists(target / unfinished_name(target, "prosup"), ignored) ||
      fs::exists(parent / unfinished_name(parent, name), ignored))
    return "A run into this folder is going on, or was killed.";
  if (const std::string state = name + ".checkpoint"; fs::exists(parent / state, ignored))
    return "A run failed or was ended; its last state and its log are in " +
           one_printable_line(state) + ".";
  if (!fs::exists(folder, ignored))
    return "There is no such folder: no run has begun, or it failed and wrote nothing.";
  return "The folder holds no summary.json: no run has ended there.";
}

/// The last parts of the paths; the paths as they are given where these are the same.
std::vector<std::string> names_of(const std::vector<fs::path>& folders) {
  std::vector<std::string> names;
  std::map<std::string, unsigned> n_of;
  for (const fs::path& folder : folders) {
    const fs::path path = fs::absolute(folder).lexically_normal();
    names.push_back((path.has_filename() ? path : path.parent_path()).filename().string());
    ++n_of[names.back()];
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (n_of[names[i]] > 1)
      names[i] = folders[i].string();
  return names;
}

/// The name as HTML, which leads to the report from a page in `folder` if there is a report.
std::string linked(const std::string& name, const fs::path& report, const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(report, ignored))
    return html::escaped(name);
  return html::link(without_links(report).lexically_relative(without_links(folder)), name);
}

} // namespace

ResultTable::ResultTable(const std::vector<fs::path>& results,
                         const std::vector<TableColumn>& properties)
    : columns_{{"/tre/initial/mean", "tre_initial_mean_mm", "TRE before, mm"},
               {last_error + "/mean", "tre_mean_mm", "TRE mean, mm"},
               {last_error + "/max", "tre_max_mm", "TRE max, mm"},
               {last_error + "/n", "landmarks", "Landmarks"},
               {"/time/total", "time_s", "Time, s"}} {
  columns_.insert(columns_.end(), properties.begin(), properties.end());
  const std::vector<std::string> names = names_of(results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Row row;
    row.name = one_printable_line(names[i]);
    row.folder = results[i];
    row.figures.resize(columns_.size());
    read(row);
    rows_.push_back(row);
  }
}

void ResultTable::read(Row& row) const {
  std::error_code error;
  const bool is_there = fs::exists(row.folder / "summary.json", error);
  // A part of the path that is missing or a file is no error here but an answer.
  if (!is_there) {
    row.state = error && error != std::errc::not_a_directory ? unreadable : unfinished;
    row.reasons = {row.state == unreadable ? "It cannot be read: " + error.message() + "."
                                           : why_unfinished(row.folder)};
    return;
  }
  try {
    const Json summary = read_summary(row.folder);
    row.state = finished;
    row.verdict = words(summary, "/quality/verdict");
    row.metric = words(summary, "/metric");
    row.version = words(summary, "/version");
    for (std::size_t r = 0; summary.contains(Json::json_pointer("/quality/reasons") / r); ++r)
      row.reasons.push_back(words(summary, "/quality/reasons/" + std::to_string(r)));
    for (std::size_t c = 0; c < columns_.size(); ++c)
      row.figures[c] = number(summary, columns_[c].pointer);
  } catch (const Error&) {
    row.state = unreadable;
    row.reasons = {"Its summary.json is damaged, or of another command than register."};
  }
}

std::string ResultTable::header() const {
  std::string text = "name,state,verdict,reasons";
  for (const TableColumn& column : columns_)
    text += "," + column.name;
  return text + ",metric,version,folder";
}

std::string ResultTable::csv() const {
  std::string text = header() + "\n";
  for (const Row& row : rows_) {
    text += csv_words(row.name) + "," + row.state + "," + csv_words(row.verdict) + "," +
            csv_words(joined(row.reasons, " "));
    for (const std::optional<double>& figure : row.figures)
      text += figure ? format(",%.6g", *figure) : ",";
    text += "," + csv_words(row.metric) + "," + csv_words(row.version) + "," +
            csv_words(one_printable_line(row.folder.string())) + "\n";
  }
  return text;
}

std::size_t ResultTable::n_unfinished() const {
  return static_cast<std::size_t>(std::count_if(
      rows_.begin(), rows_.end(), [](const Row& row) { return row.state != finished; }));
}

std::size_t ResultTable::count(const std::string& verdict) const {
  return static_cast<std::size_t>(std::count_if(
      rows_.begin(), rows_.end(), [&](const Row& row) { return row.verdict == verdict; }));
}

std::string ResultTable::overview() const {
  const std::size_t n_failed = count("failed"), n_doubtful = count("doubtful");
  const char* worst = n_failed + n_unfinished() > 0 ? "failed"
                      : n_doubtful > 0              ? "doubtful"
                                                    : "good";
  return std::string("<div class=\"verdict ") + worst + "\">\n<p>" +
         format("%zu results: %zu good, %zu doubtful, %zu failed, %zu without a finished "
                "registration",
                rows_.size(), count("good"), n_doubtful, n_failed, n_unfinished()) +
         "</p>\n</div>\n";
}

std::string ResultTable::rows_of_page(const fs::path& folder) const {
  std::vector<bool> is_shown;
  std::vector<std::string> headings{"Case", "Verdict"};
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    is_shown.push_back(std::any_of(rows_.begin(), rows_.end(),
                                   [&](const Row& row) { return row.figures[c].has_value(); }));
    if (is_shown[c])
      headings.push_back(columns_[c].heading);
  }
  headings.insert(headings.end(), {"Metric", "Version"});
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : rows_) {
    rows.push_back({linked(row.name, row.folder / report_html, folder),
                    html::escaped(row.state == finished ? row.verdict : row.state)});
    for (std::size_t c = 0; c < columns_.size(); ++c)
      if (is_shown[c])
        rows.back().push_back(row.figures[c] ? format("%.4g", *row.figures[c]) : "");
    rows.back().push_back(html::escaped(row.metric));
    rows.back().push_back(html::escaped(row.version));
  }
  return html::table_of_html(headings, rows);
}

std::string ResultTable::reasons() const {
  std::vector<ReportRow> rows;
  for (const Row& row : rows_)
    if (!row.reasons.empty())
      rows.push_back(
          {row.name, row.state == finished ? row.verdict : row.state, joined(row.reasons, " ")});
  return rows.empty() ? "<p>All are good.</p>\n" : html::table(rows);
}

std::string ResultTable::html(const fs::path& folder) const {
  return std::string(page_mark) + "\n" + html::page_start("Prone-to-supine breast registrations") +
         overview() + html::section("Results", rows_of_page(folder)) +
         html::section("Reasons", reasons()) + html::page_end();
}

} // namespace prosup::output
