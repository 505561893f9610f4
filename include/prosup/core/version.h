#ifndef PROSUP_CORE_VERSION_H
#define PROSUP_CORE_VERSION_H

namespace prosup {

/// Version of the library, "major.minor.patch".
const char* version();

/// Version of deal.II with which the library was built.
const char* dealii_version();

} // namespace prosup

#endif
