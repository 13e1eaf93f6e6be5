# Everything comes from the distribution's packages; nothing is downloaded while building (docs/decisions/).
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(SQLite3 REQUIRED)
find_package(TBB REQUIRED)
find_package(Threads REQUIRED)
find_package(tomlplusplus REQUIRED)
# Random123 is a folder of headers without a package file.
find_path(ISOLAW_RANDOM123 Random123/philox.h REQUIRED DOC "directory that holds Random123/philox.h")

# The plotting script inlined into the report (npm package plotly.js-basic-dist-min).
set(ISOLAW_PLOTLY "${PROJECT_SOURCE_DIR}/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js" CACHE FILEPATH
    "plotly-basic.min.js, inlined into the report")
if(NOT EXISTS "${ISOLAW_PLOTLY}")
  message(FATAL_ERROR "plotly-basic.min.js not found at ${ISOLAW_PLOTLY}: run ./isolaw.sh setup, "
                      "or npm ci in the project's root, or give -DISOLAW_PLOTLY=FILE")
endif()
