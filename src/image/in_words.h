#ifndef PROSUP_SRC_IMAGE_IN_WORDS_H
#define PROSUP_SRC_IMAGE_IN_WORDS_H

#include <filesystem>
#include <new>
#include <stdexcept>

#include "prosup/core/error.h"

namespace prosup::image {

/// Calls `work`, which reads `file`, and makes one sentence of what goes wrong.
template <typename Work>
auto in_words(const std::filesystem::path& file, const Work& work) {
  const std::string name = file.string();
  try {
    return work();
  } catch (const std::domain_error& error) {
    throw Error("'" + name + "' cannot be used: its " + error.what() +
                "; resample it to a regular grid.");
  } catch (const std::bad_alloc&) {
    throw Error("'" + name + "' needs more memory than there is; crop the image or resample it.");
  } catch (const std::filesystem::filesystem_error& error) {
    throw Error("'" + name + "' cannot be read (" + error.code().message() + "); copy it again.");
  }
}

} // namespace prosup::image

#endif
