# Finds the script that draws figures in HTML pages (npm package plotly.js-basic-dist-min). If it is missing, the build
# goes on. Each page then says, in place of its figures, how to get them.
set(ISOLAW_PLOTLY "${PROJECT_SOURCE_DIR}/node_modules/plotly.js-basic-dist-min/plotly-basic.min.js" CACHE FILEPATH
    "plotly-basic.min.js, inlined into the pages")
set(ISOLAW_PLOTTING_SCRIPT "${ISOLAW_PLOTLY}")
if(NOT EXISTS "${ISOLAW_PLOTLY}")
  set(advice "run ./isolaw.sh setup, or npm ci in the project's root, or give -DISOLAW_PLOTLY=FILE, and build again")
  message(WARNING "${ISOLAW_PLOTLY} is not there: pages will have no figures; to get them, ${advice}")
  set(ISOLAW_PLOTTING_SCRIPT ${PROJECT_BINARY_DIR}/plotly-basic.min.js)
  file(CONFIGURE OUTPUT ${ISOLAW_PLOTTING_SCRIPT} CONTENT
"document.body.prepend(Object.assign(document.createElement('p'), { role: 'alert',
  textContent: `This isolaw was built without plotly.js, which draws the figures. To get them, ${advice}.` }));
globalThis.Plotly = new Proxy({}, { get: () => async () => {} });
")
endif()
# Inside a page "</script" or "<!--" would end the script, so a plotting script that contains one of them is refused.
file(READ "${ISOLAW_PLOTTING_SCRIPT}" plotting)
if(plotting MATCHES "<!--|</[sS][cC]")
  message(FATAL_ERROR "${ISOLAW_PLOTTING_SCRIPT} cannot be inlined: it contains <!-- or </script")
endif()
