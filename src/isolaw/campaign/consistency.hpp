// Checks that the indices and lengths in Contents fit together, as its readers expect. A store is checked whenever it
// is read. Contents are checked before they are written, so that nothing is stored that a reader would refuse.
#pragma once

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

void require_consistent(Contents const& contents);  // throws an Error that says what does not fit
void require_consistent(Contents const& campaign, Run const& run);
void require_consistent(Contents const& campaign, DeviceAnalysis const& analysis);
void require_consistent(Contents const& campaign, LotAnalysis const& analysis);
void require_consistent(Contents const& campaign, LeftOutAnalysis const& analysis);

}  // namespace isolaw::campaign
