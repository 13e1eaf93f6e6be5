#include "isolaw/campaign/device_info.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::campaign {
namespace {

void set_date(DeviceInfo& info, Json const& value) {
  auto const text = text_in(value);
  if (!text.empty() && !data::may_be_date(text))
    throw Error({.where = {},
                 .found = fmt::format("{} is no date", in_quotes(text)),
                 .allowed = "a date of the calendar, or words with a year",
                 .advice = "year-month-day, as in 2024-03-17"});
  info.test_date = text;
}

}  // namespace

std::vector<InfoOption> const& info_table() {
  using I = DeviceInfo;
  auto const text = [](std::string_view key, std::string I::*member) -> InfoOption {
    return {{{.key = key},
             [=](I const& info) { return (info.*member).empty() ? Json() : Json(info.*member); },
             [=](I& info, Json const& value) { info.*member = text_in(value); }}};
  };
  auto const above = [](std::string_view key, double limit, std::string words, std::optional<double> I::*member,
                        Measure measure) -> InfoOption {
    constexpr double largest = std::numeric_limits<double>::max();
    return {number<I>(key, {}, at(member), {std::nextafter(limit, largest), largest, std::move(words)}), measure};
  };
  static std::vector<InfoOption> const table{
      text("serial", &I::serial),
      text("lot", &I::lot),
      {{{.key = "test-date"},
        [](I const& info) { return info.test_date.empty() ? Json() : Json(info.test_date); },
        set_date}},
      {number<I>("temperature-C", {}, at(&I::temperature_C),
                 {.least = -100.0, .most = 200.0, .words = "degrees Celsius, -100 to 200"}),
       Measure::temperature_C},
      above("rubber-thickness-mm", 0.0, "total thickness of the rubber in mm, above 0", &I::rubber_thickness_mm,
            Measure::length_mm),
      above("rubber-area-mm2", 0.0, "area of the rubber in mm2, above 0", &I::rubber_area_mm2, Measure::area_mm2)};
  return table;
}

}  // namespace isolaw::campaign
