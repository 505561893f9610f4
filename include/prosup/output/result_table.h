#ifndef PROSUP_OUTPUT_RESULT_TABLE_H
#define PROSUP_OUTPUT_RESULT_TABLE_H

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosup::output {

/// A figure of summary.json that is a column of the table.
struct TableColumn {
  std::string pointer; ///< where it stands, such as /time/total
  std::string name;    ///< in the CSV file
  std::string heading; ///< on the page
};

/// Many registrations side by side: one row for each result folder, also for one without a
/// finished registration, which says so. Nothing that a folder holds or lacks is an error.
class ResultTable {
public:
  /// Reads the folders. `properties` are columns besides verdict, errors, metric, time and version.
  ResultTable(const std::vector<std::filesystem::path>& results,
              const std::vector<TableColumn>& properties);

  /// Of the CSV file; depends on the properties only.
  std::string header() const;
  /// Header and rows.
  std::string csv() const;
  /// The first line of every such page.
  static constexpr const char* page_mark = "<!-- Table of results by prosup -->";
  /// The same as a page in `folder`, with links to the reports as seen from there.
  std::string html(const std::filesystem::path& folder) const;

  /// Rows without a finished registration.
  std::size_t n_unfinished() const;

private:
  struct Row {
    std::string name;
    std::filesystem::path folder; ///< as given
    std::string state;            ///< finished, unfinished or unreadable
    std::string verdict, metric, version;
    std::vector<std::string> reasons; ///< of the verdict, or why there is none
    std::vector<std::optional<double>> figures;
  };

  void read(Row& row) const;
  std::size_t count(const std::string& verdict) const;
  std::string overview() const;
  std::string rows_of_page(const std::filesystem::path& folder) const;
  std::string reasons() const;

  std::vector<TableColumn> columns_;
  std::vector<Row> rows_;
};

} // namespace prosup::output

#endif
