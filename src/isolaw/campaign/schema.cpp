#include "isolaw/campaign/schema.hpp"

namespace isolaw::campaign {
namespace {

constexpr char const* tables = R"sql(
CREATE TABLE setting (position INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, json TEXT NOT NULL);
CREATE TABLE device (
  id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, file TEXT NOT NULL, sha256 TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('ok', 'refused')), message TEXT NOT NULL,
  serial TEXT NOT NULL, lot TEXT NOT NULL, test_date TEXT NOT NULL,
  temperature_C REAL, rubber_thickness_mm REAL, rubber_area_mm2 REAL,
  recognised TEXT NOT NULL, corrections TEXT NOT NULL, warnings TEXT NOT NULL, cleaning TEXT NOT NULL, dead_band_mm REAL NOT NULL,
  vertical TEXT NOT NULL,  -- compression test as JSON but for its series; empty: none
  tests TEXT NOT NULL);    -- several tests as JSON, with their first samples in the series; empty: one test
CREATE TABLE series (  -- values: little-endian 8-byte floats; kind: as read, or as the laws saw it
  device INTEGER NOT NULL REFERENCES device(id), kind TEXT NOT NULL CHECK (kind IN ('raw', 'fit')),
  channel TEXT NOT NULL, count INTEGER NOT NULL, "values" BLOB NOT NULL,
  PRIMARY KEY (device, kind, channel)) WITHOUT ROWID;
CREATE TABLE search (
  device INTEGER NOT NULL REFERENCES device(id), law TEXT NOT NULL, refusal TEXT NOT NULL,
  PRIMARY KEY (device, law)) WITHOUT ROWID;
CREATE TABLE search_parameter (
  device INTEGER NOT NULL, law TEXT NOT NULL, position INTEGER NOT NULL, name TEXT NOT NULL, unit TEXT NOT NULL,
  free INTEGER NOT NULL, value REAL, lower REAL, upper REAL, scale TEXT NOT NULL, tied_to INTEGER,
  PRIMARY KEY (device, law, position)) WITHOUT ROWID;
CREATE TABLE run (
  device INTEGER NOT NULL, law TEXT NOT NULL, number INTEGER NOT NULL, outcome TEXT NOT NULL,
  objective REAL, integration_shift REAL, refinement INTEGER NOT NULL, evaluations INTEGER NOT NULL, failed_evaluations INTEGER NOT NULL,
  message TEXT NOT NULL, history BLOB NOT NULL, box BLOB NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id),
  PRIMARY KEY (device, law, number)) WITHOUT ROWID;
CREATE TABLE run_parameter (
  device INTEGER NOT NULL, law TEXT NOT NULL, number INTEGER NOT NULL, position INTEGER NOT NULL, value REAL NOT NULL,
  PRIMARY KEY (device, law, number, position)) WITHOUT ROWID;
CREATE TABLE device_analysis (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id), PRIMARY KEY (device, law)) WITHOUT ROWID;
CREATE TABLE lot_analysis (law TEXT PRIMARY KEY, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id)) WITHOUT ROWID;
CREATE TABLE left_out (
  device INTEGER NOT NULL, law TEXT NOT NULL, json TEXT NOT NULL, maker INTEGER NOT NULL REFERENCES maker(id), PRIMARY KEY (device, law)) WITHOUT ROWID;
)sql";

}  // namespace

StoreKind const& campaign_store() {
  static StoreKind const kind({.store = "campaign store",
                               .file = "campaign.sqlite of a campaign",
                               .whole = "campaign",
                               .same = "the same lot, settings and records",
                               .command = "isolaw calibrate",
                               .input = "LOT",
                               .once_more = "calibrate again",
                               .advice = ""},
                              schema_version, tables);
  return kind;
}

}  // namespace isolaw::campaign
