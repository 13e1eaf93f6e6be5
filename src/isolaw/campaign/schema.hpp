// The tables of a campaign's store.
#pragma once

#include "isolaw/campaign/store_kind.hpp"

namespace isolaw::campaign {

inline constexpr int schema_version = 12;

StoreKind const& campaign_store();

}  // namespace isolaw::campaign
