# What nearly every source reads. Not the JSON and TOML libraries: what they instantiate costs every source more than it spares
# the few that read them. The developer preset builds without, so that no include is forgotten.
set(ISOLAW_READ_EVERYWHERE <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <span>
  <string> <string_view> <utility> <vector> <fmt/format.h>)
