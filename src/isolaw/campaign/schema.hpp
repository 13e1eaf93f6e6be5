// The tables of a store.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

inline constexpr int schema_version = 4;

void create_tables(sqlite::Connection const& db);
// Throws Error for what is no store of ours, or of another schema.
void require_schema(sqlite::Connection const& db, std::filesystem::path const& file);
// A value of the table meta; empty where there is none.
std::string meta(sqlite::Connection const& db, std::string_view key);

}  // namespace isolaw::campaign
