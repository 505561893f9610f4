# ITK and gmsh as targets that carry SYSTEM include folders. ITK 5.2 exports
# plain library names and a global use-file; this keeps both in one place.
add_library(prosup_itk INTERFACE)
target_include_directories(prosup_itk SYSTEM INTERFACE ${ITK_INCLUDE_DIRS})
target_link_libraries(prosup_itk INTERFACE ${ITK_LIBRARIES})

add_library(prosup_gmsh INTERFACE)
target_include_directories(prosup_gmsh SYSTEM INTERFACE ${GMSH_INCLUDE_DIR})
target_link_libraries(prosup_gmsh INTERFACE ${GMSH_LIBRARY})

# VTK brings TBB, which asks for its own assertions in Debug. deal.II does without, and one
# precompiled header has to serve the modules with VTK and those without.
if(TARGET TBB::tbb)
  set_property(TARGET TBB::tbb PROPERTY INTERFACE_COMPILE_DEFINITIONS "")
endif()
