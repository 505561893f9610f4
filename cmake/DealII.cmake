# Creates prosup::dealii, the one way in which prosup and programs that use it
# see deal.II: include folders as SYSTEM, the library of the build type, and
# deal.II's own definitions, without its optimisation and warning flags.
# Included by the build and by the installed prosupConfig.cmake.
if(NOT TARGET prosup::dealii)
  if(NOT TARGET deal.ii AND NOT TARGET deal.ii.g)
    include(${DEAL_II_TARGET_CONFIG})
    set(DEAL_II_TARGET_CONFIG_INCLUDED TRUE)
  endif()
  add_library(prosup::dealii INTERFACE IMPORTED GLOBAL)
  set_target_properties(prosup::dealii PROPERTIES
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_INCLUDE_DIRECTORIES "${DEAL_II_INCLUDE_DIRS}"
    INTERFACE_COMPILE_FEATURES cxx_std_17)
  if(TARGET deal.ii.g)
    set_target_properties(prosup::dealii PROPERTIES
      INTERFACE_LINK_LIBRARIES "$<IF:$<CONFIG:Debug>,deal.ii.g,deal.ii>"
      INTERFACE_COMPILE_DEFINITIONS "$<$<CONFIG:Debug>:DEBUG>")
  else()
    set_target_properties(prosup::dealii PROPERTIES INTERFACE_LINK_LIBRARIES deal.ii)
  endif()
endif()
