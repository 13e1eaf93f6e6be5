// Recognises the program that wrote a text file, if the first lines name it. Such a file is read by the same rules as
// any other; the program is reported as recognised, and decides what its words for a channel mean.
//
// Sources of the layouts: National Instruments' description of .lvm for LabVIEW measurement files; for the others files
// and readers that laboratories have published (MTS Series 793 ASCII files of Station Manager and MultiPurpose
// TestWare, MTS TestSuite, Instron Bluehill 3 and Bluehill Universal, DASYLab).
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace isolaw::data {

struct Exporter {
  std::string_view name;
  // A testing machine names a channel after its own axis: "Axial Displacement", "Extension", "Load" are those of the
  // actuator, however it lies in the rig.
  bool own_axis = false;
};

std::optional<Exporter> exporter_of(std::span<std::string_view const> lines);

}  // namespace isolaw::data
