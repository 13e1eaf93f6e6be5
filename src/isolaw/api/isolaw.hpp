// What a program needs of isolaw, in one header (examples/cpp/two_laws.cpp shows it at work):
//   data::read_record, data::read_motion     files as laboratories write them, or refused with the reason
//   data::cyclic_properties                  stiffness, damping, energy, cycle by cycle
//   laws::catalogue, laws::find_law          the laws and their parameters
//   parameters_in_order, fitted_law          values by name, or as a campaign found them
//   fit::LawOnMotion, fit::LawOnRecord       forces under a displacement history; the objective of a record
//   calibrate, study::build_summary         laws fitted to records; all numbers of the reports
//   study_building                          a building on bearings drawn of the lot, shaken
//   CalibrateOptions::part, merge            a share of a campaign, and one campaign of all of them
// Wrong input throws one isolaw::Error. Nothing prints.
// Stable within a minor version: what is named here, and the keys of summary.json. The other headers are installed
// because this one needs them; what they hold besides may change with any version. Headers that it does not need are
// internal and are not installed.
#pragma once

#include "isolaw/api/building.hpp"
#include "isolaw/api/calibrate.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/catalogue_json.hpp"
#include "isolaw/api/fitted.hpp"
#include "isolaw/api/merge.hpp"
#include "isolaw/api/parameters.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
