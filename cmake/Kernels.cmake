# The hot loops, once for each instruction set; the program chooses when it runs.
# Only these files may reorder floating point: elsewhere NaN checks must hold. The
# vectors of GCC do not leave these files, so their ABI is no concern.
set(kernel_options -O3 -ffast-math -Wno-psabi)
foreach(kernel mechanics/element/element_kernel fdm/stencil_kernel)
  set_source_files_properties(src/${kernel}_baseline.cc PROPERTIES
    COMPILE_OPTIONS "${kernel_options}" SKIP_PRECOMPILE_HEADERS ON)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_source_files_properties(src/${kernel}_avx2.cc PROPERTIES
      COMPILE_OPTIONS "${kernel_options};-mavx2;-mfma" SKIP_PRECOMPILE_HEADERS ON)
    set_source_files_properties(src/${kernel}_avx512.cc PROPERTIES
      COMPILE_OPTIONS
      "${kernel_options};-mfma;-mavx512f;-mavx512dq;-mavx512bw;-mavx512vl;-mavx512cd"
      SKIP_PRECOMPILE_HEADERS ON)
    set_source_files_properties(src/${kernel}.cc PROPERTIES
      COMPILE_DEFINITIONS PROSUP_X86_KERNELS)
  endif()
endforeach()
