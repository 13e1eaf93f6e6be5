// Converts records and campaigns to states and back, so that pickle can copy them to another process.
#include "core.hpp"

#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>

#include <array>
#include <cstring>
#include <new>
#include <string_view>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/campaign/record_json.hpp"
#include "isolaw/campaign/store.hpp"

namespace isolaw::python {
namespace {

constexpr std::array channels{&data::TestRecord::time_s,       &data::TestRecord::disp_mm,
                              &data::TestRecord::force_kN,     &data::TestRecord::load_kN,
                              &data::TestRecord::logged_cycle, &data::TestRecord::second_disp_mm};

nb::tuple state_of(data::TestRecord const& record) {
  nb::list values;
  for (auto const channel : channels)
    values.append(nb::bytes((record.*channel).data(), (record.*channel).size() * sizeof(double)));
  return nb::make_tuple(campaign::facts_json(record), nb::tuple(values));
}

data::TestRecord record_of(nb::handle state) {
  auto const parts = nb::cast<nb::tuple>(state);
  auto const values = nb::cast<nb::tuple>(parts[1]);
  data::TestRecord record;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto const bytes = nb::cast<nb::bytes>(values[i]);
    auto& channel = record.*channels[i];
    channel.resize(bytes.size() / sizeof(double));
    if (!channel.empty()) std::memcpy(channel.data(), bytes.data(), channel.size() * sizeof(double));
  }
  campaign::take_facts(nb::cast<std::string>(parts[0]), record);
  return record;
}

// Returns the state of a campaign, which is the content of its store, an SQLite file.
nb::bytes state_of(Campaign const& campaign) {
  auto const text = [&] {
    nb::gil_scoped_release const released;
    TemporaryDirectory const directory;
    auto const file = directory.path() / store_name;
    campaign::Store::create(file, campaign.contents);
    return read_file(file, {.largest_bytes = std::uintmax_t{1} << 40, .allowed = "a store", .when_too_large = {}});
  }();
  return nb::bytes(text.data(), text.size());
}

CampaignPtr campaign_of(nb::bytes const& state) {
  std::string_view const text(state.c_str(), state.size());
  nb::gil_scoped_release const released;
  TemporaryDirectory const directory;
  auto const file = directory.path() / store_name;
  write_file(file, text);
  return std::make_shared<Campaign>(campaign::Store::read(file));
}

}  // namespace

void add_states(nb::module_& m) {
  auto record = nb::borrow<nb::class_<Record>>(m.attr("Record"));
  record.def("__getstate__",
             [](Record const& r) { return nb::make_tuple(r.name, state_of(r.raw), state_of(r.uncorrected)); });
  record.def("__setstate__", [](Record& r, nb::tuple const& state) {
    new (&r)
        Record{.name = nb::cast<std::string>(state[0]), .raw = record_of(state[1]), .uncorrected = record_of(state[2])};
  });
  m.def(
      "campaign_state", [](Campaign const& campaign) { return state_of(campaign); }, nb::arg("campaign"));
  m.def("campaign_of", &campaign_of, nb::arg("state"));
}

}  // namespace isolaw::python
