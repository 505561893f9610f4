#include "prosup/core/exception_text.h"

#include <deal.II/base/exceptions.h>

#include <new>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/temporary_name.h"

namespace prosup {

namespace {

bool is_want_of_memory(const std::exception& exception) {
  // ITK has an exception of its own for it, of which nothing but the text is known here.
  return dynamic_cast<const std::bad_alloc*>(&exception) != nullptr ||
         std::string(exception.what()).find("Failed to allocate memory") != std::string::npos;
}

} // namespace

std::string text_of(const std::exception& exception) {
  if (is_want_of_memory(exception))
    return "There is not enough memory for this run; free some, allow the process more (ulimit "
           "-v), or take longer 'Images/Voxel edge', 'Results/Voxel edge' and 'Meshing/Edge "
           "length'.";
  if (dynamic_cast<const Error*>(&exception) != nullptr)
    return with_known_names(
        exception.what()); // one sentence, which may hold file names with blanks
  if (const auto* of_dealii = dynamic_cast<const dealii::ExceptionBase*>(&exception)) {
    std::ostringstream text;
    of_dealii->print_info(text);
    return with_known_names(on_one_line(text.str()));
  }
  return with_known_names(on_one_line(exception.what()));
}

std::string on_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

} // namespace prosup
