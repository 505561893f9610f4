# cpack: a Debian package for the release on which it is made.
set(CPACK_GENERATOR DEB)
# There is no address that is right for all who build packages; the default is the administrator of the
# machine on which one is installed.
set(PROSUP_MAINTAINER "The administrator <root@localhost>" CACHE STRING
  "Who looks after the Debian package: Name <address>")
if(NOT PROSUP_MAINTAINER MATCHES "^[^<>@]+ <[^<>@ ]+@[^<>@ ]+>$")
  message(FATAL_ERROR "PROSUP_MAINTAINER is '${PROSUP_MAINTAINER}', which is no maintainer of a Debian "
    "package; write a name and an address, such as 'Maria Berg <maria@localhost>'.")
endif()
set(CPACK_PACKAGE_CONTACT "${PROSUP_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION
"Finds a point of the prone breast image in the supine one: both breasts are
meshed, unloaded from gravity and brought together by explicit finite elements.
With the library gmsh, this program may be passed on under the terms of the
GNU General Public License only.")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# What the program and the libraries are linked with, by dpkg-shlibdeps (package dpkg-dev).
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS openmpi-bin)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS libdeal.ii-dev)
include(CPack)
