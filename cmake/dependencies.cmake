# All libraries come from the distribution's packages. The build downloads nothing (docs/decisions/0001).
find_package(Boost REQUIRED)  # isolaw uses only headers of Boost
find_package(CLI11 REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(EXPAT REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(SQLite3 REQUIRED)
find_package(Threads REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(ZLIB REQUIRED)
include(isolaw-libraries)
find_path(ISOLAW_MINIZIP_INCLUDE minizip/unzip.h REQUIRED DOC "directory that holds minizip/unzip.h")
find_path(ISOLAW_HDF5_INCLUDE hdf5_hl.h PATH_SUFFIXES hdf5/serial REQUIRED DOC "directory that holds hdf5_hl.h")
# Random123 consists of headers and has no CMake package.
find_path(ISOLAW_RANDOM123 Random123/philox.h REQUIRED DOC "directory that holds Random123/philox.h")
include(plotly)
