#include "isolaw/render/json/inspection_json.hpp"

#include "isolaw/data/read.hpp"
#include "isolaw/render/json/properties_json.hpp"

namespace isolaw::render {
namespace {

constexpr int schema = 1;

// Which part of a file of several was read; null where it has but one.
void write_choice(JsonWriter& out, std::string_view key, std::optional<std::string> const& choice) {
  out.key(key);
  choice ? out.value(*choice) : out.null();
}

void write_effects(JsonWriter& out, std::vector<data::Effect> const& effects) {
  constexpr int digits = 9;
  out.key("effects").begin_array();
  for (auto const& effect : effects) {
    out.begin_object().member("effect", effect.effect);
    out.key("value").rounded(effect.value, digits);
    out.member("unit", effect.unit);
    out.key("limit").rounded(effect.limit, digits);
    out.member("exceeds", effect.exceeds).end_object();
  }
  out.end_array();
}

void write_device(JsonWriter& out, DeviceResult const& device) {
  out.member("name", device.name).member("file", device.file).member("sha256", device.sha256);
  out.member("status", device.status).member("message", device.message);
  out.member("samples", std::uint64_t{device.raw.size()});
  out.key("columns").begin_object();
  for (auto const& [channel, column] : device.raw.layout.columns) out.member(data::name(channel), column);
  out.end_object().key("units").begin_object();
  for (auto const& [channel, unit] : device.raw.layout.units) out.member(data::name(channel), unit);
  out.end_object();
  write_choice(out, "sheet", device.raw.layout.sheet);
  write_choice(out, "test", device.raw.layout.test);
  out.member("recognised", device.raw.recognised).member("warnings", device.raw.warnings);
  write_properties(out, device);
  write_effects(out, device.effects);
}

}  // namespace

std::string inspection_json(Summary const& summary) {
  JsonWriter out(JsonWriter::Layout::indented);
  out.begin_object();
  out.member("schema", schema).member("isolaw", summary.version);
  if (summary.devices.size() == 1) {
    write_device(out, summary.devices.front());
  } else {
    out.member("title", summary.title).key("devices").begin_array();
    for (auto const& device : summary.devices) {
      out.begin_object();
      write_device(out, device);
      out.end_object();
    }
    out.end_array();
  }
  out.key("assessment");
  write_acceptance(out, summary.acceptance);
  out.end_object();
  return out.take();
}

}  // namespace isolaw::render
