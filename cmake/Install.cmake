# cmake --install: the program, the modules, their headers, and a package for
# find_package(prosup) in other projects.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/prosup)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/prosup DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
# Where prosup compare looks for the parameter files of other programs.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/prm/peers DESTINATION ${CMAKE_INSTALL_DATADIR}/prosup)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Programs that use the package, to begin with.
foreach(example law metric plugin register)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/${example} DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/examples/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
# Parameter files to begin with, and the sample that they name.
set(sample tests/data/anthro1)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/${sample} DESTINATION ${CMAKE_INSTALL_DATADIR}/prosup)
file(READ ${PROJECT_SOURCE_DIR}/prm/quickstart.prm quickstart)
string(REPLACE ../${sample} ../anthro1 quickstart "${quickstart}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/quickstart.prm CONTENT "${quickstart}" @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/quickstart.prm
  ${PROJECT_SOURCE_DIR}/prm/phantom.prm ${PROJECT_SOURCE_DIR}/prm/phantom_mrct.prm
  DESTINATION ${CMAKE_INSTALL_DATADIR}/prosup/prm)
# The workflow for many cases, and a table of three that are made of the sample.
set(cohort ${PROJECT_SOURCE_DIR}/examples/cohort)
file(RELATIVE_PATH installed_sample ${CMAKE_INSTALL_FULL_DOCDIR}/examples/cohort
  ${CMAKE_INSTALL_FULL_DATADIR}/prosup/anthro1)
file(READ ${cohort}/cases.csv cases)
string(REPLACE ../../${sample} ${installed_sample} cases "${cases}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/cases.csv CONTENT "${cases}" @ONLY)
install(DIRECTORY ${cohort} DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
  USE_SOURCE_PERMISSIONS PATTERN cases.csv EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/cases.csv DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/cohort)

install(EXPORT prosupTargets NAMESPACE prosup:: DESTINATION ${package_folder})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/prosupConfig.cmake.in ${PROJECT_BINARY_DIR}/prosupConfig.cmake
  INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may change interfaces.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/prosupConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/prosupConfig.cmake
  ${PROJECT_BINARY_DIR}/prosupConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/DealII.cmake
  DESTINATION ${package_folder})
