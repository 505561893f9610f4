# prosup_add_module(NAME USES <lower modules and public libraries>
#                   PRIVATE_USES <libraries hidden behind the module's headers>
#                   WINGS "<subfolder>: <subfolders that it includes>"...)
# builds libprosup_NAME from the *.cc files in src/NAME and its subfolders. A module links
# only what it names, and --no-undefined turns an include of a higher module into a link
# error. A header beside the sources is included as "NAME/file.h".

# prosup_precompile(TARGET...): these use deal.II's headers as core, the first module, has
# compiled them; that halves the time of a build.
function(prosup_precompile)
  foreach(target ${ARGV})
    if(target STREQUAL prosup_core)
      target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    else()
      target_precompile_headers(${target} REUSE_FROM prosup_core)
    endif()
  endforeach()
endfunction()

function(prosup_add_module name)
  cmake_parse_arguments(arg "" "" "USES;PRIVATE_USES;WINGS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cc)
  set(target prosup_${name})
  add_library(${target} SHARED ${sources})
  add_library(prosup::${name} ALIAS ${target})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PUBLIC ${arg_USES} PRIVATE ${arg_PRIVATE_USES} $<BUILD_INTERFACE:prosup_options>)
  prosup_precompile(${target})
  target_link_options(${target} PRIVATE LINKER:--no-undefined LINKER:--as-needed)
  set_target_properties(${target} PROPERTIES
    DEFINE_SYMBOL "" EXPORT_NAME ${name} VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  # The arrow of this module, "name: used...", and those of its wings, "name/wing: name/used...",
  # for the test of the layers.
  set(used ${arg_USES})
  list(FILTER used INCLUDE REGEX "^prosup_")
  string(REGEX REPLACE "prosup_|;" " " used "${used}")
  set_property(GLOBAL APPEND PROPERTY PROSUP_ARROWS "${name}: ${used}")
  list(TRANSFORM arg_WINGS REPLACE "([a-z]+)" "${name}/\\1")
  set_property(GLOBAL APPEND PROPERTY PROSUP_ARROWS ${arg_WINGS})
  if(PROSUP_INSTALL)
    install(TARGETS ${target} EXPORT prosupTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  endif()
endfunction()
