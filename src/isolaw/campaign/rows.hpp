// The rows of a store, of the present schema, to Contents and back.
#pragma once

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

// All but runs and analyses: what a campaign begins with. `makers` must not be empty.
void write_campaign(sqlite::Connection const& db, Contents const& contents, std::vector<Maker> const& makers);
void write_row(sqlite::Connection const& db, std::size_t id, Maker const& maker);
// What may change afterwards, see Store::describe.
void write_descriptions(sqlite::Connection const& db, Contents const& contents);
void write_row(sqlite::Connection const& db, Run const& run);
void write_row(sqlite::Connection const& db, DeviceAnalysis const& analysis);
void write_row(sqlite::Connection const& db, LotAnalysis const& analysis);
void write_row(sqlite::Connection const& db, LeftOutAnalysis const& analysis);

// Without series, runs and analyses. Throws Error or nlohmann::json::exception for rows that no Contents can hold.
Contents read_campaign(sqlite::Connection const& db);
Contents read_contents(sqlite::Connection const& db);

}  // namespace isolaw::campaign
