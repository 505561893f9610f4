#include "html.h"

#include <deal.II/base/utilities.h>

#include <cstring>

#include "prosup/core/log.h"

namespace prosup::output::html {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light; --ink: #1c2430; --line: #d5dae1; --soft: #f4f6f8; }
:root { font-size: 15px; } body { font: 1rem/1.45 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; color: var(--ink);
  max-width: 1180px; margin: 0 auto; padding: 1.2rem; background: #fff; }
h1 { font-size: 1.5rem; margin: 0 0 .6rem; } h2 { font-size: 1.15rem; margin: 1.8rem 0 .5rem;
  border-bottom: 1px solid var(--line); } h3 { font-size: 1rem; margin: .8rem 0 .3rem; }
table { border-collapse: collapse; margin: .4rem 0; } td, th { text-align: left;
  padding: .18rem .8rem .18rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
table.numbers td:not(:first-child), table.numbers th:not(:first-child) { text-align: right;
  font-variant-numeric: tabular-nums; }
.verdict { padding: .7rem 1rem; border-left: 8px solid #888; background: var(--soft); }
.good { border-color: #1b7837; } .doubtful { border-color: #e08214; } .failed { border-color: #b2182b; }
.verdict p { margin: 0; } .verdict ul { margin: .4rem 0; }
figure { margin: .8rem 0; break-inside: avoid; } figcaption { color: #4a5563; font-size: .92rem; }
img, svg { max-width: 100%; height: auto; }
.viewers { display: flex; flex-wrap: wrap; gap: 0 1rem; align-items: flex-start; }
.viewers figure { flex-basis: 0; min-width: 190px; } .viewers img, .viewers svg { width: 100%; }
.stack { position: relative; background: #000; cursor: ew-resize; touch-action: none; line-height: 0; }
.stack .over { position: absolute; inset: 0; display: none;
  clip-path: inset(0 calc(100% - var(--cut, 50%)) 0 0); }
.stack .over.shown { display: block; }
.stack::after { content: ""; position: absolute; top: 0; bottom: 0; left: var(--cut, 50%);
  width: 1px; background: #ffd640; pointer-events: none; }
.slider { width: 100%; margin: .3rem 0 0; } code { background: var(--soft); padding: 0 .2rem; }
@media print { :root { font-size: 11px; } body { max-width: none; padding: 0; }
  .slider, .screen, .controls input, .controls label:has(:not(:checked)) { display: none; }
  .viewers { flex-wrap: nowrap; break-inside: avoid; } .viewers figure { min-width: 0; }
  .wide img { max-height: 105mm; } table, svg, tr { break-inside: avoid; }
  .controls { break-inside: avoid; } .scale { display: block; } h2, h3, h2 + p, h3 + p, .scale, .controls { break-after: avoid; } * { print-color-adjust: exact; } }
)";

// A slider is moved by keys, by its thumb, or by dragging the picture.
constexpr const char* script = R"(
document.querySelectorAll('.stack').forEach(function (stack) {
  var slider = stack.parentNode.querySelector('.slider');
  function cut() { stack.style.setProperty('--cut', slider.value + '%'); }
  function follow(event) {
    var box = stack.getBoundingClientRect();
    slider.value = 100 * (event.clientX - box.left) / box.width;
    cut();
  }
  slider.addEventListener('input', cut);
  stack.addEventListener('pointerdown', function (event) {
    event.preventDefault(); stack.setPointerCapture(event.pointerId); follow(event); slider.focus();
  });
  stack.addEventListener('pointermove', function (event) { if (event.buttons) follow(event); });
  cut();
});
document.querySelectorAll('input[name=over]').forEach(function (choice) {
  choice.addEventListener('change', function () {
    document.querySelectorAll('.over').forEach(function (image) {
      image.classList.toggle('shown', image.dataset.kind === choice.value);
    });
  });
});
)";

/// A row of cells whose contents are HTML already.
std::string cells_of_html(const char* tag, const std::vector<std::string>& values) {
  std::string row = "<tr>";
  for (const std::string& value : values)
    row += std::string("<") + tag + ">" + value + "</" + tag + ">";
  return row + "</tr>\n";
}

std::vector<std::string> escaped(std::vector<std::string> all) {
  for (std::string& words : all)
    words = html::escaped(words);
  return all;
}

std::string cells(const char* tag, const std::vector<std::string>& values) {
  return cells_of_html(tag, escaped(values));
}

} // namespace

std::string escaped(const std::string& words) {
  std::string result;
  for (const char c : words)
    switch (c) {
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '&':
      result += "&amp;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

std::string data_uri(const std::string& bytes, const std::string& type) {
  return "data:" + type + ";base64," +
         dealii::Utilities::encode_base64(std::vector<unsigned char>(bytes.begin(), bytes.end()));
}

std::string section(const std::string& title, const std::string& contents) {
  return "<section>\n<h2>" + escaped(title) + "</h2>\n" + contents + "</section>\n";
}

std::string table(const std::vector<ReportRow>& rows) {
  std::string text = "<table>\n";
  for (const ReportRow& row : rows)
    text +=
        cells("td", row.remark.empty() ? std::vector<std::string>{row.name, row.value}
                                       : std::vector<std::string>{row.name, row.value, row.remark});
  return text + "</table>\n";
}

std::string table(const std::vector<std::string>& headings,
                  const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> of_html;
  of_html.reserve(rows.size());
  for (const auto& row : rows)
    of_html.push_back(escaped(row));
  return table_of_html(headings, of_html);
}

std::string table_of_html(const std::vector<std::string>& headings,
                          const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<table class=\"numbers\">\n" + cells("th", headings);
  for (const auto& row : rows)
    text += cells_of_html("td", row);
  return text + "</table>\n";
}

std::string figure(const std::string& name, double width_mm, const std::string& contents) {
  std::string caption = escaped(name);
  caption[0] = static_cast<char>(caption[0] - 'a' + 'A');
  return format("<figure style=\"flex-grow: %.0f\">", width_mm) + contents + "<figcaption>" +
         caption + format(", %.0f mm wide</figcaption></figure>\n", width_mm);
}

std::string link(const std::filesystem::path& file, const std::string& words) {
  // All others mean something in an address, such as '?', '#' and the ':' behind "http".
  constexpr const char* plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string address;
  for (const char c : file.generic_string())
    address += std::strchr(plain, c) != nullptr
                   ? std::string(1, c)
                   : format("%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return "<a href=\"" + address + "\">" + escaped(words) + "</a>";
}

std::string page_start(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
         escaped(title) + "</h1>\n";
}

std::string page_end() {
  return std::string("<script>") + script + "</script>\n</body>\n</html>\n";
}

} // namespace prosup::output::html
