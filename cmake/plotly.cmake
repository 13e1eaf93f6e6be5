# The plotting script inlined into the report (npm package plotly.js-basic-dist-min).
set(ISOLAW_PLOTLY "${PROJECT_SOURCE_DIR}/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js" CACHE FILEPATH
    "plotly-basic.min.js, inlined into the report")
if(NOT EXISTS "${ISOLAW_PLOTLY}")
  message(FATAL_ERROR "plotly-basic.min.js not found at ${ISOLAW_PLOTLY}: run ./isolaw.sh setup, "
                      "or npm ci in the project's root, or give -DISOLAW_PLOTLY=FILE")
endif()
