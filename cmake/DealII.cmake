# Creates prosup::dealii, the one way in which prosup and programs that use it
# see deal.II: include folders as SYSTEM, the library of the build type and
# deal.II's choice of linker, without its optimisation and warning flags.
# Included by the build and by the installed prosupConfig.cmake, which sets
# PROSUP_DEALII_DEBUG to what prosup was built with.
if(NOT DEFINED PROSUP_DEALII_DEBUG)
  if(CMAKE_BUILD_TYPE STREQUAL "Debug")
    set(PROSUP_DEALII_DEBUG ON)
  else()
    set(PROSUP_DEALII_DEBUG OFF)
  endif()
endif()

if(NOT TARGET prosup::dealii)
  if(NOT TARGET deal.ii AND NOT TARGET deal.ii.g)
    include(${DEAL_II_TARGET_CONFIG})
    # Keeps deal_ii_setup_target() from including it again.
    set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
  endif()
  add_library(prosup::dealii INTERFACE IMPORTED)
  set_target_properties(prosup::dealii PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_17)
  # deal.II's choice of linker: against its some 250 libraries, gold links a
  # program in 1 s where GNU's default linker takes more than 30 s.
  if(DEAL_II_LINKER_FLAGS MATCHES "-fuse-ld=[a-z]+")
    set_property(TARGET prosup::dealii PROPERTY INTERFACE_LINK_OPTIONS ${CMAKE_MATCH_0})
  endif()
  if(PROSUP_DEALII_DEBUG AND TARGET deal.ii.g)
    set_target_properties(prosup::dealii PROPERTIES
      INTERFACE_LINK_LIBRARIES deal.ii.g INTERFACE_COMPILE_DEFINITIONS DEBUG)
  else()
    set_target_properties(prosup::dealii PROPERTIES INTERFACE_LINK_LIBRARIES deal.ii)
  endif()
endif()
