// Converts the rows of a store of the present schema to Contents and back.
#pragma once

#include <functional>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::campaign {

// Creates the tables and writes what a campaign begins with: everything but runs and analyses. `makers` must not be
// empty.
void write_campaign(sqlite::Connection const& db, Contents const& contents, std::vector<Maker> const& makers);
void write_descriptions(sqlite::Connection const& db, Contents const& contents);  // see Store::describe
void write_row(sqlite::Connection const& db, Run const& run);
class RunWriter {  // writes many runs one after the other
 public:
  explicit RunWriter(sqlite::Connection const& db);
  bool add_if_new(Run const& run);  // writes nothing and returns false if a run of this device, law and number is there
  bool is_there(Run const& run);    // whether the stored run is the same, bit by bit, whoever computed it

 private:
  sqlite::Statement row_, parameter_, stored_, stored_parameters_;
};
void write_row(sqlite::Connection const& db, DeviceAnalysis const& analysis);
void write_row(sqlite::Connection const& db, LotAnalysis const& analysis);
void write_row(sqlite::Connection const& db, LeftOutAnalysis const& analysis);
// Reads all but series, runs and analyses. Throws Error or nlohmann::json::exception for rows that do not fit Contents.
Contents read_campaign(sqlite::Connection const& db);
void read_runs(sqlite::Connection const& db, std::function<void(Run)> const& visit);  // in the order of Contents::runs
struct Analyses {
  std::vector<DeviceAnalysis> devices = {};
  std::vector<LotAnalysis> lots = {};
  std::vector<LeftOutAnalysis> left_out = {};
};
Analyses read_analyses(sqlite::Connection const& db);
Contents read_campaign_and_series(sqlite::Connection const& db);  // all but runs and analyses
Contents read_contents(sqlite::Connection const& db);

}  // namespace isolaw::campaign
