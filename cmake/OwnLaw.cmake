# PROSUP_OWN_LAW: a header with a material law of the user's own, prosup::mechanics::OwnLaw (see
# examples/law). Kernels are compiled for each law, so that it becomes part of the modules, and of
# their headers where they are installed.
set(PROSUP_OWN_LAW "" CACHE FILEPATH "Header that defines prosup::mechanics::OwnLaw; empty: none")

# To the lowest module, since all share its precompiled header.
function(prosup_add_own_law target)
  if(NOT PROSUP_OWN_LAW)
    return()
  endif()
  if(NOT EXISTS ${PROSUP_OWN_LAW})
    message(FATAL_ERROR "PROSUP_OWN_LAW is '${PROSUP_OWN_LAW}', and there is no such file; name the header of "
      "a law by its whole path.")
  endif()
  set(folder ${PROJECT_BINARY_DIR}/own_law)
  configure_file(${PROSUP_OWN_LAW} ${folder}/prosup/mechanics/laws/own_law.h COPYONLY)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${folder}>)
  target_compile_definitions(${target} PUBLIC PROSUP_OWN_LAW)
  if(PROSUP_INSTALL)
    install(FILES ${folder}/prosup/mechanics/laws/own_law.h
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/prosup/mechanics/laws)
  endif()
endfunction()
