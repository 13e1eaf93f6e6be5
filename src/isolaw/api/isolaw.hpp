// The one header that a program includes to use isolaw (examples/cpp/two_laws.cpp is an example). It provides:
//   data::read_record, data::read_motion     read files as laboratories write them, or refuse them with the reason
//   data::cyclic_properties                  stiffness, damping, energy, cycle by cycle
//   laws::catalogue, laws::find_law          the laws and their parameters
//   parameters_in_order, fitted_law          a law's parameter values: from names, or from a campaign
//   fit::LawOnMotion, fit::LawOnRecord       forces under a displacement history; the objective on a record
//   calibrate, study::build_summary          fit laws to records; all numbers of the reports
//   study_building                           the response of a building on bearings drawn from the lot
//   CalibrateOptions::part, merge            compute a part of a campaign; merge all parts
// Units are kN, mm and s unless a name says otherwise; a law's parameters have the law's own units. Wrong input throws
// one isolaw::Error. No function prints. The names in this list and the keys of summary.json are stable within a minor
// version. Other headers are installed only because this one needs them, and the rest of their contents may change with
// any version. All further headers are internal and not installed.
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
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/render/json/summary_json.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
