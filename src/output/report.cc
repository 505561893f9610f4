#include "prosup/output/report.h"

#include <cmath>
#include <fstream>
#include <iterator>

#include "html.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"
#include "prosup/output/pictures.h"
#include "prosup/output/registration_file.h"
#include "report_charts.h"
#include "report_deformation.h"
#include "report_landmarks.h"
#include "report_parameters.h"
#include "report_slices.h"
#include "report_verdict.h"
#include "summary_json.h"

namespace prosup::output {

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// On which side of the middle of its image the breast lies; LPS grows to the left.
ReportRow side(const ReportImages& images) {
  const image::LabelImage& mask = *images.masks.prone;
  const SliceBox box = slice_box({&mask});
  const auto& size = mask.grid.size;
  const double middle = mask.grid.physical(
      0.5 * (double(size[0]) - 1.), 0.5 * (double(size[1]) - 1.), 0.5 * (double(size[2]) - 1.))[0];
  const double offset = box.centre[0] - middle;
  return {"Breast", std::abs(offset) < 20.
                        ? "in the middle of the prone image"
                        : format("%.0f mm to the %s of the middle of the prone "
                                 "image",
                                 std::abs(offset), offset > 0. ? "left" : "right")};
}

std::string unit_of(const std::string& entry) {
  return ends_with(entry, "gravity")  ? " (direction, LPS)"
         : ends_with(entry, "offset") ? " mm"
                                      : "";
}

std::string what_was_done(const Json& summary, const std::vector<UsedParameter>& used,
                          const std::optional<ReportImages>& images) {
  std::vector<ReportRow> rows{{"Program", "prosup " + summary.value("version", ""), ""}};
  for (const UsedParameter& parameter : used)
    if (parameter.section == "Case" && !parameter.value.empty() && parameter.entry != "State")
      rows.push_back({parameter.entry, parameter.value + unit_of(parameter.entry), ""});
  if (images)
    rows.push_back(side(*images));
  if (const auto found = summary.find("alignment"); found != summary.end())
    rows.push_back({"Chests aligned", found->value("method", ""), ""});
  else
    rows.push_back({"Chests aligned", "no, they are taken as they lie in the images", ""});
  rows.push_back({"Similarity", summary.value("metric", ""), ""});
  return html::table(rows);
}

std::string warnings(const Json& summary) {
  std::string text = "<ul>\n";
  for (const Json& warning : summary.value("warnings", Json::array()))
    text += "<li>" + html::escaped(warning.get<std::string>()) + "</li>\n";
  return text + "</ul>\n";
}

std::string slices(const fs::path& result, const std::optional<ReportImages>& images) {
  std::string text;
  if (images && fs::exists(result / prone_in_supine))
    text = report_slices(*images, result);
  else
    text = "<p>There are no slices to compare: no pictures were wanted, or the images that the run "
           "started from or <code>prone_in_supine.nii.gz</code> are not there.</p>\n";
  for (const char* plane : {"axial", "sagittal", "coronal"}) {
    const fs::path file = result / (std::string("slices_") + plane + ".png");
    if (fs::exists(file))
      text += std::string("<figure class=\"wide\"><img alt=\"") + plane +
              " slices of both images and their difference, before and after\" src=\"" +
              html::data_uri(contents(file), "image/png") +
              "\"><figcaption>Above as scanned, below "
              "unloaded and registered: prone, supine and their difference, " +
              plane + ".</figcaption></figure>\n";
  }
  return text;
}

std::string deformation(const fs::path& result, const std::optional<ReportImages>& images) {
  const fs::path file = result / registration_h5;
  return images && fs::exists(file)
             ? html::section("Deformation", report_deformation(file, *images->masks.supine))
             : "";
}

std::string landmarks(const Json& summary, const fs::path& result) {
  std::vector<std::vector<std::string>> rows;
  const std::pair<const char*, const char*> steps[] = {{"initial", "No registration"},
                                                       {"unloaded", "Unloaded, generic material"},
                                                       {"material", "Properties found"},
                                                       {"image_forces", "Image forces"}};
  const Json tre = summary.value("tre", Json::object());
  for (const auto& [key, name] : steps)
    if (tre.contains(key)) {
      rows.push_back({name});
      for (const char* figure : {"mean", "std", "p95", "max"})
        rows.back().push_back(format("%.2f", tre[key].value(figure, 0.)));
      rows.back().push_back(std::to_string(tre[key].value("n", 0)));
    }
  if (rows.empty())
    return "<p>No landmarks were given.</p>\n";
  return "<p>Target registration error, mm. The registration does not know the landmarks.</p>\n" +
         html::table({"", "mean", "std", "95th percentile", "max", "landmarks"}, rows) +
         landmark_vectors(result / "landmarks.csv", result / registration_h5) +
         error_histogram(result / "landmarks.csv");
}

std::string times(const Json& summary) {
  std::vector<std::vector<std::string>> rows;
  const Json time = summary.value("time", Json::object());
  const std::pair<const char*, const char*> stages[] = {{"mesh", "Meshing"},
                                                        {"unloading", "Unloading"},
                                                        {"material", "Material update"},
                                                        {"image_forces", "Image forces"},
                                                        {"total", "All, with reading and writing"}};
  for (const auto& [key, name] : stages)
    if (time.contains(key))
      rows.push_back({name, format("%.1f", time[key].get<double>())});
  return html::table({"Stage", "s"}, rows) + format("<p>%u rank(s), at most %.0f MiB.</p>\n",
                                                    summary.value("ranks", 1u),
                                                    summary.value("peak_memory", 0.));
}

std::string how_to_use() {
  return html::table(std::vector<ReportRow>{
      {"prosup map --result DIR --from prone --to supine POINTS -o OUT",
       "points (.csv, .fcsv, .mrk.json) to the other position, with their error bars", ""},
      {"prosup warp --result DIR --from prone --to supine INPUT -o OUT",
       "an image, a label map or a surface model (.vtp, .stl, .obj)", ""},
      {"prosup field --result DIR --from prone --to supine -o OUT",
       "the field as a transform of ITK (.h5), which ITK, SimpleITK, ANTs and 3D Slicer read", ""},
      {"prone_to_supine.nrrd, supine_to_prone.nrrd, unloaded_to_prone.nrrd, "
       "unloaded_to_supine.nrrd",
       "displacement fields; 3D Slicer loads them as transforms. An image in supine is seen in "
       "prone by prone_to_supine",
       ""},
      {"valid_*.nii.gz",
       "1 where the field is that of the breast; outside it turns into the "
       "rigid motion of the chest",
       ""},
      {"prone_in_supine.nii.gz, supine_in_prone.nii.gz",
       "each image as it looks in the other "
       "position",
       ""},
      {"prone.pvd, supine.pvd, registration.xdmf", "meshes for ParaView", ""},
      {"summary.json, used.prm", "all figures, and the parameters to run it again", ""},
      {"prosup report DIR", "this page anew", ""}});
}

} // namespace

void write_report(const fs::path& result, const std::vector<ReportRow>& properties,
                  const std::optional<ReportImages>& images) {
  const Json summary = read_summary(result);
  const std::vector<UsedParameter> used = read_used_parameters(result);
  std::string page = html::page_start("Prone-to-supine breast registration");
  page += report_verdict(summary);
  if (!summary.value("warnings", Json::array()).empty())
    page += html::section("Warnings", warnings(summary));
  page += html::section("What was done", what_was_done(summary, used, images));
  page += html::section("Before and after", slices(result, images));
  page += deformation(result, images);
  page += html::section("Landmarks", landmarks(summary, result));
  page += html::section("Mechanical properties found", html::table(properties));
  page += html::section("Similarity", similarity_chart(summary.value("similarity", Json::array())));
  page += html::section("Times", times(summary));
  page += html::section("Parameters that differ from their defaults", changed_parameters(used));
  page += html::section("How to use the files", how_to_use());
  write_text_file(page + html::page_end(), result / report_html);
}

} // namespace prosup::output
