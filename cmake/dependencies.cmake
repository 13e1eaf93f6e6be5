# Everything comes from the distribution's packages; nothing is downloaded while building (docs/decisions/0001).
find_package(Boost REQUIRED)  # only its headers
find_package(CLI11 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(EXPAT REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(SQLite3 REQUIRED)
find_package(Threads REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)
# minizip has no CMake package. CMake's module for HDF5 would demand a C compiler of every project that uses isolaw.
find_path(ISOLAW_MINIZIP_INCLUDE minizip/unzip.h REQUIRED DOC "directory that holds minizip/unzip.h")
find_library(ISOLAW_MINIZIP minizip REQUIRED DOC "libminizip")
find_path(ISOLAW_HDF5_INCLUDE hdf5_hl.h PATH_SUFFIXES hdf5/serial REQUIRED DOC "directory that holds hdf5_hl.h")
find_library(ISOLAW_HDF5 NAMES hdf5_serial hdf5 REQUIRED DOC "libhdf5, not the parallel one")
find_library(ISOLAW_HDF5_HL NAMES hdf5_serial_hl hdf5_hl REQUIRED DOC "libhdf5_hl, not the parallel one")
# Random123 is a folder of headers without a CMake package.
find_path(ISOLAW_RANDOM123 Random123/philox.h REQUIRED DOC "directory that holds Random123/philox.h")
include(plotly)
