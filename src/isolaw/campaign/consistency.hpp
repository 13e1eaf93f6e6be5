// What readers of Contents rely on: indices and lengths that fit together. Asked when a store is read, of whatever file
// it is, and before anything is written: what a reader refuses is never stored.
#pragma once

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// Each throws Error that says what does not fit.
void require_consistent(Contents const& contents);
// Of a campaign whose devices, searches and settings are those of `campaign`.
void require_consistent(Contents const& campaign, Run const& run);
void require_consistent(Contents const& campaign, DeviceAnalysis const& analysis);
void require_consistent(Contents const& campaign, LotAnalysis const& analysis);
void require_consistent(Contents const& campaign, LeftOutAnalysis const& analysis);

}  // namespace isolaw::campaign
