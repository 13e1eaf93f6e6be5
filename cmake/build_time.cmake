# What keeps the build short. Beside it the presets join a folder's sources (CMAKE_UNITY_BUILD): names of one folder's
# unnamed namespaces must differ. The developer preset compiles each source alone, so that an edit costs one of them and no
# include is forgotten.

# What nearly every source reads. Not the JSON and TOML libraries: what they instantiate costs every source more than it spares
# the few that read them.
set(ISOLAW_READ_EVERYWHERE <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <utility> <vector> <fmt/format.h>)

# Who calls what computes takes little time when it runs, and a third less to compile at -O1.
set(ISOLAW_CALLING_OPTIONS $<$<CONFIG:Release>:-O1> CACHE STRING "Compiler options of all that does not compute")
