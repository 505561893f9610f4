#ifndef PROSUP_SRC_OUTPUT_REPORT_LANDMARKS_H
#define PROSUP_SRC_OUTPUT_REPORT_LANDMARKS_H

#include <filesystem>
#include <string>

namespace prosup::output {

/// All landmarks of landmarks.csv in the unloaded breast, seen along each axis, with their errors
/// as vectors from the position that the supine image gives to that of the prone image, as in Fig.
/// 8 of Eiben et al. (2016); behind them the breast of registration.h5. HTML; empty if a file or
/// the unloaded positions are missing.
/// @throws Error if one of the files is damaged.
std::string landmark_vectors(const std::filesystem::path& landmarks,
                             const std::filesystem::path& registration);

} // namespace prosup::output

#endif
