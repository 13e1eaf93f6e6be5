// The functions that the rows of the table point to. Each gets the findings of one group and returns what is said of
// them without the subject: it continues "device-01: " or "Bouc-Wen: " where the row begins with one.
#pragma once

#include <string>

#include "isolaw/wording/table.hpp"

namespace isolaw::wording {

// Campaigns: campaign.cpp.
std::string runs_missing(Group);
std::string analyses_missing(Group);
std::string device_refused(Group);
std::string rule_set_not_kept_by_device(Group);
std::string rule_set_not_kept_by_lot(Group);
std::string devices_not_in_lot_law(Group);
std::string same_record(Group);
std::string same_compression_test(Group);
std::string energy_falls(Group);
std::string law_refused(Group);
std::string runs_failed(Group);
std::string evaluations_failed(Group);
std::string law_inadequate(Group);
std::string held_by_box(Group);
std::string prediction_poor(Group);
std::string prediction_unusable(Group);
std::string searches_disagree(Group);
std::string not_determined(Group);
std::string prediction_not_asked(Group);
std::string outlier(Group);
std::string at_bound(Group);
std::string lot_law_at_bound(Group);
std::string integration_coarse(Group);
std::string integration_not_finite(Group);

// Records: records.cpp.
std::string no_cyclic_properties(Group);
std::string stated_by_older_store(Group);

}  // namespace isolaw::wording
