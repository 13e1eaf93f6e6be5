// Checks that the indices and lengths in Contents fit together, as all code that uses Contents takes for granted. Every
// store is checked when it is read. Contents are checked before they are written too, so that no store is written that
// could not be read again.
#pragma once

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

void require_consistent(Contents const& contents);  // throws an Error that says what does not fit
void require_consistent(Contents const& campaign, Run const& run);
void require_consistent(Contents const& campaign, DeviceAnalysis const& analysis);
void require_consistent(Contents const& campaign, LotAnalysis const& analysis);
void require_consistent(Contents const& campaign, LeftOutAnalysis const& analysis);

}  // namespace isolaw::campaign
