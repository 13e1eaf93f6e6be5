// The tables of a store. Only stores of the present schema are read.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

inline constexpr int schema_version = 10;

void create_tables(sqlite::Connection const& db);
// Throws Error for a file that is not our store or has another schema. Tables must be declared word by word like ours,
// since a view or a computed column could run without end or fill the memory and a trigger could change results.
void require_schema(sqlite::Connection const& db, std::filesystem::path const& file);
std::string meta(sqlite::Connection const& db, std::string_view key);  // a value of the table meta; empty if none

}  // namespace isolaw::campaign
