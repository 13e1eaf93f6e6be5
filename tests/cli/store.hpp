// Reads a campaign's store by plain SQL, as a user's own script would.
#pragma once

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace isolaw::cli_test {

// Returns the rows of a query as texts "value|value", with binary values in hexadecimal.
inline std::vector<std::string> query(std::filesystem::path const& file, std::string const& sql) {
  sqlite3* db = nullptr;
  sqlite3_stmt* statement = nullptr;
  std::vector<std::string> rows;
  std::string failure;
  if (sqlite3_open_v2(file.c_str(), &db, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK &&
      sqlite3_prepare_v2(db, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK) {
    int status = SQLITE_OK;
    while ((status = sqlite3_step(statement)) == SQLITE_ROW) {
      std::string row;
      for (int i = 0; i < sqlite3_column_count(statement); ++i) {
        if (i > 0) row += '|';
        auto const type = sqlite3_column_type(statement, i);
        if (type == SQLITE_NULL) {
          row += "NULL";
          // A double is shown by its bytes, so that comparisons are exact.
        } else if (type == SQLITE_BLOB || type == SQLITE_FLOAT) {
          double const value = sqlite3_column_double(statement, i);
          auto const* bytes = static_cast<unsigned char const*>(type == SQLITE_BLOB ? sqlite3_column_blob(statement, i)
                                                                                    : static_cast<void const*>(&value));
          auto const size = type == SQLITE_BLOB ? sqlite3_column_bytes(statement, i) : static_cast<int>(sizeof value);
          constexpr char const* digits = "0123456789abcdef";
          for (int b = 0; b < size; ++b) {
            row += digits[bytes[b] >> 4];
            row += digits[bytes[b] & 15];
          }
        } else {
          auto const* text = static_cast<char const*>(static_cast<void const*>(sqlite3_column_text(statement, i)));
          row.append(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, i)));
        }
      }
      rows.push_back(std::move(row));
    }
    if (status != SQLITE_DONE) failure = sqlite3_errmsg(db);
  } else {
    failure = sqlite3_errmsg(db);
  }
  sqlite3_finalize(statement);
  sqlite3_close(db);
  if (!failure.empty()) throw std::runtime_error(file.string() + ": " + failure + " in " + sql);
  return rows;
}

// Returns every row of every table, sorted. Nothing in the store depends on the clock, so two equal campaigns have
// equal rows.
inline std::vector<std::string> all_rows(std::filesystem::path const& file) {
  std::vector<std::string> rows;
  for (auto const& table : query(file, "SELECT name FROM sqlite_master WHERE type = 'table'"))
    for (auto const& row : query(file, "SELECT * FROM \"" + table + "\"")) rows.push_back(table + ": " + row);
  std::ranges::sort(rows);
  return rows;
}

// Returns the number of rows, or 0 if there is no store yet. `table_and_condition` may be "run WHERE law = 'abe'".
inline int stored_rows(std::filesystem::path const& file, std::string const& table_and_condition) {
  try {
    return std::filesystem::exists(file) ? std::stoi(query(file, "SELECT count(*) FROM " + table_and_condition).at(0))
                                         : 0;
  } catch (std::exception const&) {
    return 0;
  }
}
inline int stored_runs(std::filesystem::path const& file, std::string const& law) {
  return stored_rows(file, "run WHERE law = '" + law + "'");
}

}  // namespace isolaw::cli_test
