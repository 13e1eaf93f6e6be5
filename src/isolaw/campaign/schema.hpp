// The tables of a store, and what older schemas lack of them: stores are read forward.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

inline constexpr int schema_version = 10;

void create_tables(sqlite::Connection const& db);
// One of an older schema reads as one of the present from here on; its file is not changed. Throws Error for what is no
// store of ours, and for one of a newer schema.
void require_readable_schema(sqlite::Connection const& db, std::filesystem::path const& file);
// Throws Error as well for an older schema, which is not written to.
void require_present_schema(sqlite::Connection const& db, std::filesystem::path const& file);
// A value of the table meta; empty where there is none.
std::string meta(sqlite::Connection const& db, std::string_view key);

}  // namespace isolaw::campaign
