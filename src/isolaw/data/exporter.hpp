// The program that wrote a text file, where its first lines say so. What it wrote is read by the same rules as every
// other table; its name goes into what was recognised, and with it what its words for a channel mean.
//
// The layouts, as the programs' files have them: LabVIEW measurement files after National Instruments' description of
// .lvm; the others after files and readers that laboratories have published (MTS Series 793 ASCII files of Station
// Manager and MultiPurpose TestWare, MTS TestSuite, Instron Bluehill 3 and Bluehill Universal, DASYLab).
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
