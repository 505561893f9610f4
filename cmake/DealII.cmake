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
  if(NOT TARGET ${DEAL_II_TARGET_RELEASE} AND NOT TARGET ${DEAL_II_TARGET_DEBUG})
    include(${DEAL_II_TARGET_CONFIG})
    # Keeps deal_ii_setup_target() from including it again.
    set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
  endif()
  add_library(prosup::dealii INTERFACE IMPORTED)
  # From deal.II 9.5 on, the include folders, and those of MPI, come with its target.
  set_target_properties(prosup::dealii PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_17)
  # deal.II's choice of linker: against its some 250 libraries, gold or mold links a
  # program in 1 s where GNU's default linker takes more than 30 s.
  if(DEAL_II_LINKER_FLAGS MATCHES "-fuse-ld=([a-z]+)")
    set(linker_option ${CMAKE_MATCH_0})
    find_program(PROSUP_LINKER ld.${CMAKE_MATCH_1})
    if(PROSUP_LINKER)
      set_property(TARGET prosup::dealii PROPERTY INTERFACE_LINK_OPTIONS ${linker_option})
    endif()
  endif()
  if(PROSUP_DEALII_DEBUG AND TARGET ${DEAL_II_TARGET_DEBUG})
    set_target_properties(prosup::dealii PROPERTIES
      INTERFACE_LINK_LIBRARIES ${DEAL_II_TARGET_DEBUG} INTERFACE_COMPILE_DEFINITIONS DEBUG)
  else()
    set_target_properties(prosup::dealii PROPERTIES INTERFACE_LINK_LIBRARIES ${DEAL_II_TARGET_RELEASE})
  endif()
endif()
