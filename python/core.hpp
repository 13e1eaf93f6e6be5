// Declares what the sources of the compiled part of the Python package `isolaw` share.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/study/build_summary.hpp"

namespace isolaw::python {

namespace nb = nanobind;
using Contents = campaign::Contents;

struct Record {
  std::string name;
  data::TestRecord raw;
  data::TestRecord uncorrected = {};  // the record before the user's corrections; empty if there are none or unknown
};

struct Campaign {
  Contents contents;
  study::Summary summary;

  explicit Campaign(Contents given) : contents(std::move(given)), summary(study::build_summary(contents)) {}

  study::DeviceFit const& fit(std::string const& law, std::string const& device) const {
    auto const of_law = std::ranges::find(summary.laws, law, &study::LawResult::id);
    if (of_law == summary.laws.end())
      throw Error({.where = "law '" + law + "'",
                   .found = "not in this campaign",
                   .allowed = names(summary.laws, &study::LawResult::id)});
    auto const of_device = std::ranges::find(of_law->devices, device, &study::DeviceFit::device);
    if (of_device == of_law->devices.end())
      throw Error({.where = "device '" + device + "'",
                   .found = "not in this campaign",
                   .allowed = names(summary.devices, &study::DeviceResult::name)});
    return *of_device;
  }

  template <class Items, class Name>
  static std::string names(Items const& items, Name name) {
    std::string text;
    for (auto const& item : items) text += (text.empty() ? "" : ", ") + item.*name;
    return text;
  }

  std::size_t device(std::string const& name) const {
    auto const found = std::ranges::find(contents.devices, name, &campaign::Device::name);
    if (found == contents.devices.end())
      throw Error({.where = "device '" + name + "'",
                   .found = "not in this campaign",
                   .allowed = names(contents.devices, &campaign::Device::name)});
    return static_cast<std::size_t>(found - contents.devices.begin());
  }
};
using CampaignPtr = std::shared_ptr<Campaign>;

// Returns an array of this shape that owns `values`.
template <class Number>
nb::object array_of(std::vector<Number> values, std::vector<std::size_t> const& shape) {
  auto kept = std::make_unique<std::vector<Number>>(std::move(values));
  auto* const data = kept->data();
  nb::capsule const owner(kept.get(), [](void* all) noexcept { delete static_cast<std::vector<Number>*>(all); });
  kept.release();
  return nb::ndarray<nb::numpy, Number>(data, shape.size(), shape.data(), owner).cast();
}

inline nb::object array_of(std::vector<double> values) {
  auto const size = values.size();
  return array_of(std::move(values), {size});
}

// Converts a Python value to JSON: None, a bool, a number, a text, a dict or a sequence.
Json json_of(nb::handle value);

// Returns the values that the caller gave for the settings in `rows`. A keyword with the value None counts as not
// given.
template <class Rows>
Values given_of(Rows const& rows, nb::dict const& given) {
  Values values;
  for (auto const& row : rows)
    if (nb::str const keyword(row.python().c_str()); given.contains(keyword))
      if (auto value = json_of(given[keyword]); !value.is_null()) values.emplace(row.key, std::move(value));
  return values;
}

// Returns the records with their names and compression tests. `vertical` maps the name of a device to its compression
// test, in the forms that calibrate() accepts in Python.
std::vector<campaign::NamedRecord> named_records(nb::list const& records, nb::dict const& vertical);

// Returns the texts of complaints and remarks. They name Python keywords where the complaints name command-line
// options.
std::vector<std::string> texts_in_keywords(std::vector<Complaint> complaints);

void add_states(nb::module_& m);    // adds the pickling of records and campaigns
void add_commands(nb::module_& m);  // functions for the program's other commands, such as inspect and export

}  // namespace isolaw::python
