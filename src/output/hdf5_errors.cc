#include "hdf5_errors.h"

namespace prosup::output {

namespace {

/// The first entry of the stack is what went wrong, the others are who called whom.
herr_t keep_first(unsigned n, const H5E_error2_t* error, void* text) {
  if (n == 0 && error->desc != nullptr)
    *static_cast<std::string*>(text) = error->desc;
  return 0;
}

} // namespace

Hdf5Errors::Hdf5Errors() {
  H5open();
  H5Eget_auto2(H5E_DEFAULT, &function_before_, &data_before_);
  H5Eset_auto2(H5E_DEFAULT, &Hdf5Errors::take, this);
}

Hdf5Errors::~Hdf5Errors() {
  H5Eset_auto2(H5E_DEFAULT, function_before_, data_before_);
}

herr_t Hdf5Errors::take(hid_t stack, void* self) {
  std::string& first = static_cast<Hdf5Errors*>(self)->first_;
  if (!first.empty())
    return 0;
  H5Ewalk2(stack, H5E_WALK_UPWARD, &keep_first, &first);
  if (first.empty())
    first = "an unknown error of HDF5";
  return 0;
}

} // namespace prosup::output
