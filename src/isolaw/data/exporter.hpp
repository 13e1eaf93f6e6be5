// Recognises the program that wrote a text file by its first lines. The names of channels depend on it. Sources of the
// layouts: National Instruments' description of .lvm; for the others files and readers that laboratories have published
// (MTS Series 793, MultiPurpose TestWare and TestSuite, Instron Bluehill 3 and Universal, DASYLab).
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace isolaw::data {

struct Exporter {
  std::string_view name;
  // "Axial Displacement", "Extension" and "Load" are measured at the actuator, however it lies in the rig.
  bool own_axis = false;
};

std::optional<Exporter> exporter_of(std::span<std::string_view const> lines);

}  // namespace isolaw::data
