#ifndef PROSUP_CORE_VERSION_H
#define PROSUP_CORE_VERSION_H

namespace prosup {

/// Version of the library, "major.minor.patch".
const char* version();

/// Version of the deal.II it was built with.
const char* dealii_version();

} // namespace prosup

#endif
