# Makes targets for libraries that have no CMake package. The installed package includes this file too, so that the
# libraries are searched on the machine that uses isolaw. CMake's own module for HDF5 would require a C compiler in
# every project that uses isolaw.
foreach(names "hdf5;hdf5_serial" "hdf5_hl;hdf5_serial_hl" minizip bearssl)
  list(GET names 0 library)
  if(NOT TARGET isolaw::${library})
    list(REVERSE names)  # prefers hdf5_serial, since hdf5 may be built for MPI
    find_library(ISOLAW_${library} NAMES ${names} REQUIRED DOC "lib${library}")
    add_library(isolaw::${library} UNKNOWN IMPORTED)
    set_target_properties(isolaw::${library} PROPERTIES IMPORTED_LOCATION "${ISOLAW_${library}}")
  endif()
endforeach()
set(ISOLAW_WITHOUT_PACKAGE isolaw::hdf5_hl isolaw::hdf5 isolaw::minizip isolaw::bearssl)
