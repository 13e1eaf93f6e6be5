# Libraries that have no CMake package, as targets. The installed package includes this file too, so that each library is
# found on the machine that uses isolaw. CMake's own module for HDF5 would demand a C compiler of every such project.
foreach(names "hdf5;hdf5_serial" "hdf5_hl;hdf5_serial_hl" minizip)
  list(GET names 0 library)
  if(NOT TARGET isolaw::${library})
    list(REVERSE names)  # hdf5 alone may be the parallel one
    find_library(ISOLAW_${library} NAMES ${names} REQUIRED DOC "lib${library}")
    add_library(isolaw::${library} UNKNOWN IMPORTED)
    set_target_properties(isolaw::${library} PROPERTIES IMPORTED_LOCATION "${ISOLAW_${library}}")
  endif()
endforeach()
set(ISOLAW_WITHOUT_PACKAGE isolaw::hdf5_hl isolaw::hdf5 isolaw::minizip)
