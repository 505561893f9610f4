#ifndef PROSUP_SRC_OUTPUT_HDF5_ERRORS_H
#define PROSUP_SRC_OUTPUT_HDF5_ERRORS_H

#include <hdf5.h>

#include <string>

namespace prosup::output {

/// Takes the errors of HDF5, which it would print otherwise, as long as it lives: deal.II's
/// interface looks at them in Debug only. Not for use by two threads at once.
class Hdf5Errors {
public:
  Hdf5Errors();
  ~Hdf5Errors();
  Hdf5Errors(const Hdf5Errors&) = delete;
  Hdf5Errors& operator=(const Hdf5Errors&) = delete;

  /// What failed first; empty if nothing did.
  const std::string& first() const { return first_; }

private:
  static herr_t take(hid_t stack, void* self);

  H5E_auto2_t function_before_ = nullptr;
  void* data_before_ = nullptr;
  std::string first_;
};

} // namespace prosup::output

#endif
