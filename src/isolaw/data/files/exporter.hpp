// Recognises the program that wrote a text file by its first lines, because programs name channels differently.
// Sources: National Instruments' description of .lvm; for the others, files and readers that laboratories have
// published (MTS Series 793, MultiPurpose TestWare and TestSuite, Instron Bluehill 3 and Universal, DASYLab).
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace isolaw::data {

struct Exporter {
  std::string_view name;
  // True if names such as "Axial Displacement" refer to the actuator, which may have any direction in the rig.
  bool own_axis = false;
};

std::optional<Exporter> exporter_of(std::span<std::string_view const> lines);

}  // namespace isolaw::data
