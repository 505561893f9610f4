#ifndef PROSUP_SRC_OUTPUT_HTML_H
#define PROSUP_SRC_OUTPUT_HTML_H

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/output/report.h"

// Parts of the report in HTML.
namespace prosup::output::html {

/// Words as HTML takes them, also in attributes.
std::string escaped(const std::string& words);

/// Bytes as the address of a picture of the type, such as image/png.
std::string data_uri(const std::string& bytes, const std::string& type);

std::string section(const std::string& title, const std::string& contents);

/// A table of names and values, with a third column if a row has a remark.
std::string table(const std::vector<ReportRow>& rows);

/// A table with a line of headings; all but the first column are numbers.
std::string table(const std::vector<std::string>& headings,
                  const std::vector<std::vector<std::string>>& rows);

/// The same, with cells that are HTML already.
std::string table_of_html(const std::vector<std::string>& headings,
                          const std::vector<std::vector<std::string>>& rows);

/// One of several pictures beside each other, such as the "axial" one, which share their scale: its
/// part of the width is that of its `width_mm`.
std::string figure(const std::string& name, double width_mm, const std::string& contents);

/// Words that lead to a file, which is given as seen from the folder of the page.
std::string link(const std::filesystem::path& file, const std::string& words);

/// All before and after the sections of the page, with its style and its script.
std::string page_start(const std::string& title);
std::string page_end();

} // namespace prosup::output::html

#endif
