// The compiled part of the Python package `isolaw`. It gives NumPy views of the library's values and releases Python's
// global lock (GIL) during long calls. Users read the docstrings in this file and in isolaw/__init__.py. tests/python
// compares the package with its type stub __init__.pyi.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/isolaw.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/render/terminal/conditions_text.hpp"
#include "isolaw/rules/rule_set.hpp"
#include "isolaw/study/conditions.hpp"
#include "isolaw/wording/table.hpp"

namespace py = pybind11;

namespace isolaw::python {
namespace {

using Array = py::array_t<double>;
// An array of doubles in C order. If the caller's array already has this form, it is not copied.
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Contents = campaign::Contents;

// Returns a read-only array that shows `values` without copying them. `owner` is the Python object that keeps them
// alive.
Array view(std::vector<double> const& values, py::object owner) {
  Array array(static_cast<py::ssize_t>(values.size()), values.data(), std::move(owner));
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::object view_or_none(std::vector<double> const& values, py::object owner) {
  return values.empty() ? py::object(py::none()) : py::object(view(values, std::move(owner)));
}

std::vector<double> values_of(std::optional<Rows> const& array, char const* what) {
  if (!array) return {};
  if (array->ndim() != 1)
    throw Error({.where = what, .found = fmt::format("an array of {} dimensions", array->ndim()), .allowed = "one"});
  return {array->data(), array->data() + array->size()};
}

struct Record {
  std::string name;
  data::TestRecord raw;
  data::TestRecord uncorrected = {};  // the record without the user's corrections; empty without any, or if unknown
};
using RecordPtr = std::shared_ptr<Record>;

Json json_of(py::handle value) {
  if (value.is_none()) return {};
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::float_>(value)) return value.cast<double>();
  if (PyIndex_Check(value.ptr()) != 0) {
    auto const whole = py::reinterpret_steal<py::int_>(PyNumber_Index(value.ptr()));
    auto const text = std::string(py::str(py::handle(whole)));
    auto const number = Json::parse(text);  // rounds an integer above 64 bits; the text is then passed on instead
    return number.is_number_integer() ? number : Json(text);
  }
  if (py::isinstance<py::dict>(value)) {
    Json object = Json::object();
    for (auto const& [key, item] : value.cast<py::dict>()) object[std::string(py::str(key))] = json_of(item);
    return object;
  }
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) return std::string(py::str(value));
  Json array = Json::array();
  for (auto const& item : value) array.push_back(json_of(item));
  return array;
}

// Returns the values that the caller gave for the settings in `rows`. A keyword with the value None counts as not
// given.
template <class Rows>
Values given_of(Rows const& rows, py::dict const& given) {
  Values values;
  for (auto const& row : rows)
    if (py::str const keyword(row.python()); given.contains(keyword))
      if (auto value = json_of(given[keyword]); !value.is_null()) values.emplace(row.key, std::move(value));
  return values;
}

campaign::Settings settings_of(py::dict const& given) {
  campaign::Settings settings;
  campaign::apply(given_of(campaign::setting_table(), given), settings);
  settings.complete();
  settings.validate();
  return settings;
}

// Describes the settings in `rows` for Python: a dict with one entry for each keyword.
template <class Rows>
Json described(Rows const& rows) {
  using Row = std::remove_cvref_t<decltype(rows.front())>;
  Json table = Json::object();
  for (auto const& row : rows) {
    auto& one = table[row.python()];
    one["option"] = row.option();
    one["help"] = row.help;
    one["default"] = row.get({});
    one["words"] = row.words;
    one["limits"] = row.limits ? Json{row.limits->least, row.limits->most} : Json();
    if constexpr (std::is_same_v<Row, data::Reading>) one["of_test"] = row.of_test;
    if constexpr (std::is_same_v<Row, campaign::Setting>) {
      campaign::Settings settings;
      settings.method = row.of.value_or(settings.method);
      one["method"] = row.of ? campaign::find_setting("method")->get(settings) : Json();
      one["stored_only"] = row.stored_only;
    }
  }
  return table;
}

RecordPtr record_of_file(std::filesystem::path const& file, bool motion, std::optional<std::string> const& name,
                         py::dict const& how) {
  data::ReadOptions options;
  lay_over(data::reading_table(), given_of(data::reading_table(), how), options);
  options.corrections.validate();
  py::gil_scoped_release const released;
  auto record = std::make_shared<Record>(
      Record{.name = name.value_or(printable(file.stem().string())),
             .raw = motion ? data::read_motion(file, options) : data::read_record(file, options)});
  if (data::is_corrected(record->raw)) try {
      record->uncorrected = data::read_record(file, *data::without_corrections(options));
    } catch (Error const&) {  // reports then say that the record without corrections is not known
    }
  return record;
}

// Reads how the caller gives a compression test: as a file, as K_v in kN/mm, or as a dict with file, loads and keywords
// for reading. None means that there is no test.
campaign::VerticalInput vertical_input(py::handle const& given, std::string const& where) {
  campaign::VerticalInput test;
  if (given.is_none()) return test;
  auto const take_file = [&](py::handle const& file) {
    test.file = file.cast<std::filesystem::path>();
    test.shown_file = printable(test.file.filename().string());
  };
  if (py::isinstance<py::dict>(given)) {
    auto const told = given.cast<py::dict>();
    std::vector<data::Reading> rows;
    for (auto const& row : data::reading_table())
      if (!row.of_test) rows.push_back(row);
    py::dict reading;
    for (auto const& [key, value] : told) {
      auto const name = key.cast<std::string>();
      if (name == "file")
        take_file(value);
      else if (name == "loads")
        test.loads = data::parse_loads(value.cast<std::string>());
      else if (std::ranges::any_of(rows, [&](auto const& row) { return row.python() == name; }))
        reading[key] = value;
      else
        throw Error({.where = where,
                     .found = "unknown keyword " + in_quotes(name),
                     .allowed = "file, loads and the keywords of read_motion"});
    }
    lay_over(rows, given_of(rows, reading), test.read);
    if (test.file.empty())
      throw Error({.where = where, .found = "a compression test without a file", .allowed = "file=...", .advice = {}});
    return test;
  }
  if (py::isinstance<py::float_>(given) || (py::isinstance<py::int_>(given) && !py::isinstance<py::bool_>(given))) {
    test.stated_kN_per_mm = given.cast<double>();
    if (!(*test.stated_kN_per_mm > 0.0) || !std::isfinite(*test.stated_kN_per_mm))
      throw Error({.where = where,
                   .found = fmt::format("{}", *test.stated_kN_per_mm),
                   .allowed = "vertical stiffness in kN/mm, above 0"});
    return test;
  }
  take_file(given);
  return test;
}

std::string inspected(Record const& record, py::object const& vertical) {
  if (record.raw.force_kN.empty())
    throw Error({.where = record.name, .found = "a motion without force", .allowed = "a record of a test"});
  Contents contents;
  contents.devices.push_back({.name = record.name,
                              .file = record.raw.file,
                              .info = {},
                              .refusal = {},
                              .raw = record.raw,
                              .record = data::clean(record.raw, {})});
  auto const compression = vertical_input(vertical, "vertical");
  py::gil_scoped_release const released;
  contents.devices.front().vertical = campaign::prepare_vertical(compression, {});
  return render::inspection_json(study::build_summary(contents));
}

int steps(int refinement) {
  if (refinement < 1 || refinement > 1000)
    throw Error(
        {.where = "refinement", .found = fmt::format("{}", refinement), .allowed = "1 to 1000 steps per sample"});
  return refinement;
}

std::string shown(py::handle value) {
  return printable(std::string(py::repr(value)).substr(0, 100));
}

std::vector<NamedValue> named_values(py::dict const& given) {
  std::vector<NamedValue> named;
  std::vector<Complaint> complaints;
  for (auto const& [key, value] : given) {
    try {
      named.push_back({.name = py::str(key), .value = value.cast<double>()});
    } catch (py::cast_error const&) {
      complaints.push_back({"parameters",
                            fmt::format("{} = {} is no number", printable(std::string(py::str(key))), shown(value)),
                            "a number",
                            {}});
    }
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return named;
}

Rows rows_of(py::object const& given) {
  try {
    return given.cast<Rows>();
  } catch (py::cast_error const&) {
  } catch (py::error_already_set& error) {  // the exception comes from NumPy
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
  }
  throw Error({.where = "parameters",
               .found = shown(given) + " is no array of numbers",
               .allowed = "a dict by name, or numbers in the law's order"});
}

// Returns a law's parameters in the law's order. The caller gives them as a dict by name or as values in that order.
std::vector<double> parameters_of(laws::LawEntry const& law, py::object const& given,
                                  Together together = Together::checked) {
  if (py::isinstance<py::dict>(given))
    return parameters_in_order(law, named_values(given.cast<py::dict>()), "parameters", together);
  auto const values = values_of(rows_of(given), "parameters");
  if (values.size() != law.parameters.size())
    throw Error(
        {.where = "parameters",
         .found = fmt::format("{} values", values.size()),
         .allowed = fmt::format("the {} of {} in its order, or a dict by name", law.parameters.size(), law.info.id),
         .advice = fmt::format("isolaw.laws()['{}']", law.info.id)});
  std::vector<NamedValue> named;
  for (std::size_t i = 0; i < values.size(); ++i)
    named.push_back({.name = std::string(law.parameters[i].name), .value = values[i]});
  return parameters_in_order(law, named, "parameters", together);
}

// Returns the array for a result: the array that the caller passed as `out`, or a new one.
Array result_array(std::optional<Array> const& out, std::size_t size) {
  if (!out) return Array(static_cast<py::ssize_t>(size));
  bool const fits = out->ndim() == 1 && static_cast<std::size_t>(out->size()) == size && out->writeable() &&
                    (out->flags() & py::array::c_style) != 0;
  if (!fits)
    throw Error({.where = "out",
                 .found = "another array",
                 .allowed = fmt::format("a writeable contiguous float64 array of {} values", size)});
  return *out;
}

Array force_of(std::string const& law_id, py::object const& parameters, Record const& motion, py::dict const& how,
               int refinement, std::optional<Array> const& out) {
  auto const& law = laws::find_law(law_id);
  auto const values = parameters_of(law, parameters);
  auto result = result_array(out, motion.raw.size());
  auto* target = result.mutable_data();
  auto const settings = settings_of(how);
  steps(refinement);
  py::gil_scoped_release const released;
  fit::LawOnMotion const model(law, data::motion_of(motion.raw), settings.integration, settings.turning_points,
                               refinement);
  model.force_kN(values, std::span(target, motion.raw.size()));
  return result;
}

// A law together with a cleaned record. calibrate() cleans its records in the same way.
class Model {
 public:
  Model(std::string const& law, RecordPtr record, campaign::Settings const& how, int refinement)
      : record_(std::make_shared<data::FitRecord>(data::clean(record->raw, how.clean))),
        model_(laws::find_law(law), *record_, how.integration, how.turning_points, steps(refinement)) {}

  laws::LawEntry const& law() const { return model_.law(); }
  data::FitRecord const& record() const { return *record_; }

  double objective(py::object const& parameters) const {
    auto const values = parameters_of(law(), parameters, Together::left);
    std::vector<double> work;
    return model_.objective(values, work);
  }

  Array objectives(Rows const& population, std::optional<Array> const& out) const {
    auto const dimension = law().parameters.size();
    if (population.ndim() != 2 || static_cast<std::size_t>(population.shape(1)) != dimension)
      throw Error({.where = "population",
                   .found = population.ndim() == 2 ? fmt::format("rows of {} values", population.shape(1))
                                                   : fmt::format("an array of {} dimensions", population.ndim()),
                   .allowed = fmt::format("a row for each candidate, with the {} parameters of {} in its order",
                                          dimension, law().info.id)});
    auto const count = static_cast<std::size_t>(population.shape(0));
    auto result = result_array(out, count);
    auto* target = result.mutable_data();
    auto const* rows = population.data();
    py::gil_scoped_release const released;
    model_.objectives(
        count,
        [&](std::size_t i, std::span<double> values) { std::copy_n(rows + i * dimension, dimension, values.begin()); },
        std::span(target, count));
    return result;
  }

  Array force(py::object const& parameters, std::optional<Array> const& out) const {
    auto const values = parameters_of(law(), parameters);
    auto result = result_array(out, record_->size());
    auto const force = model_.force_kN(values);
    std::ranges::copy(force, result.mutable_data());
    return result;
  }

 private:
  std::shared_ptr<data::FitRecord const> record_;
  fit::LawOnRecord model_;
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

py::dict runs_of(Campaign const& campaign, std::string const& law, std::string const& device) {
  campaign.fit(law, device);
  auto const index = campaign.device(device);
  std::vector<campaign::Run const*> runs;
  for (auto const& run : campaign.contents.runs)
    if (run.device == index && run.law == law) runs.push_back(&run);
  auto const dimension = laws::find_law(law).parameters.size();
  auto const count = static_cast<py::ssize_t>(runs.size());
  py::array_t<int> number(count);
  Array objective(count), parameters({count, static_cast<py::ssize_t>(dimension)});
  py::list outcome, history;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    number.mutable_data()[i] = runs[i]->number;
    objective.mutable_data()[i] = runs[i]->objective;
    for (std::size_t p = 0; p < dimension; ++p)
      parameters.mutable_data()[i * dimension + p] = runs[i]->usable() ? runs[i]->parameters[p] : std::nan("");
    outcome.append(std::string(campaign::name(runs[i]->outcome)));
    history.append(Array(static_cast<py::ssize_t>(runs[i]->history.size()), runs[i]->history.data()));
  }
  py::dict result;
  result["number"] = number;
  result["objective"] = objective;
  result["parameters"] = parameters;
  result["outcome"] = outcome;
  result["history"] = history;
  return result;
}

// Runs `work` in another thread without Python's global lock. Python delivers signals only to the main thread, so the
// calling thread waits, checks for signals and passes progress to the Python function `tell`. An exception from a
// signal or from `tell` stops the work and is thrown again when the work has ended. If there was none, an exception
// from the work itself is thrown again.
template <class Told, class Work>
auto in_a_thread(std::function<void(Told const&)> const& tell, Work const& work) {
  std::mutex mutex;
  std::condition_variable changed;
  std::optional<Told> latest;
  bool ended = false;
  std::atomic<bool> stop = false;
  std::exception_ptr failure;
  std::function<void(Told const&)> const progress = [&](Told const& now) {
    std::scoped_lock const lock(mutex);
    latest = now;
    changed.notify_one();
  };
  std::function<bool()> const interrupted = [&] { return stop.load(); };
  std::optional<decltype(work(progress, interrupted))> result;
  std::exception_ptr asked;  // the exception from a signal or from `tell`
  {
    std::jthread const worker([&] {
      try {
        result = work(progress, interrupted);
      } catch (...) {
        failure = std::current_exception();
      }
      std::scoped_lock const lock(mutex);
      ended = true;
      changed.notify_one();
    });
    constexpr auto patience = std::chrono::milliseconds(50);
    for (bool over = false; !over;) {
      std::optional<Told> told;
      {
        py::gil_scoped_release const released;
        std::unique_lock lock(mutex);
        changed.wait_for(lock, patience, [&] { return ended || (latest && !stop); });
        told = std::exchange(latest, std::nullopt);
        over = ended;
      }
      if (stop) continue;
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (told) tell(*told);
      } catch (...) {
        asked = std::current_exception();
        stop = true;
      }
    }
    py::gil_scoped_release const released;  // lets other Python threads run
  }
  if (asked) std::rethrow_exception(asked);
  if (failure) std::rethrow_exception(failure);
  return std::move(*result);
}

CampaignPtr worked(campaign::RunOptions run, py::object const& progress,
                   std::function<Contents(campaign::RunOptions const&)> const& work) {
  auto contents = in_a_thread<campaign::Progress>(
      [&](campaign::Progress const& now) {
        if (!progress.is_none()) progress(now.done, now.total, now.analysis, now.best, now.share, now.left_s);
      },
      [&](auto const& told, auto const& interrupted) {
        run.progress = told;
        run.interrupted = interrupted;
        return work(run);
      });
  py::gil_scoped_release const released;
  return std::make_shared<Campaign>(std::move(contents));
}

CampaignPtr calibrated(std::vector<RecordPtr> const& records, py::dict const& given, py::dict const& vertical,
                       CalibrateOptions options, py::object const& progress) {
  auto const settings = settings_of(given);
  lay_over(campaign::acceptance_table(), given_of(campaign::acceptance_table(), given), options.acceptance);
  std::vector<campaign::NamedRecord> named;
  for (auto const& record : records) {
    if (record == nullptr) throw Error({.where = "records", .found = "None", .allowed = "records"});
    named.push_back({.name = record->name, .record = record->raw, .uncorrected = record->uncorrected});
    auto& raw = named.back().record;
    auto const last_part = [](std::string const& file) {
      return printable(std::filesystem::path(file).filename().string());
    };
    raw.file = last_part(raw.file);
    std::vector<std::string> files;
    for (auto& test : raw.tests) files.push_back(test.file = last_part(test.file));
    if (!files.empty()) raw.file = joined(files);
    if (record->raw.force_kN.empty())
      throw Error({.where = record->name, .found = "a motion without force", .allowed = "records of tests"});
  }
  for (auto const& [key, test] : vertical) {
    auto const name = key.cast<std::string>();
    auto const found = std::ranges::find(named, name, &campaign::NamedRecord::name);
    if (found == named.end())
      throw Error({.where = "vertical",
                   .found = in_quotes(name) + ": no such device",
                   .allowed = "names of the records",
                   .advice = fmt::format("vertical={{'{}': FILE}}", named.empty() ? "D1" : named.front().name)});
    found->vertical = vertical_input(test, "vertical of " + in_quotes(name));
  }
  return worked(options.run, progress, [&](campaign::RunOptions const& run) {
    options.run = run;
    return calibrate(std::move(named), settings, options);
  });
}

CampaignPtr merged(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                   MergeCallOptions options, py::object const& progress) {
  return worked(options.run, progress, [&](campaign::RunOptions const& run) {
    options.run = run;
    return merge(directory, parts, options);
  });
}

void require_jobs(int jobs) {
  if (jobs < 0 || jobs > campaign::most_jobs)
    throw Error(
        {.where = "jobs", .found = fmt::format("{}", jobs), .allowed = fmt::format("0 to {}", campaign::most_jobs)});
}

CampaignPtr loaded(std::filesystem::path const& directory) {
  py::gil_scoped_release const released;
  return std::make_shared<Campaign>(campaign::Store::read(directory / store_name));
}

using BuildingPtr = std::shared_ptr<StudiedBuilding>;

// Reads how the caller gives a ground motion: as a tuple (step in s, accelerations along x in m/s2[, along y]) or as a
// text for building::read_motion.
building::Motion motion_of(py::handle const& given, std::size_t place, Values const& stated) {
  if (py::isinstance<py::str>(given)) return building::read_motions({given.cast<std::string>()}, stated).front();
  auto const values = given.cast<py::tuple>();
  constexpr double mm_in_m = 1e3;
  auto const component = [&](std::size_t i) {
    auto accelerations = values_of(rows_of(values[i]), "motion");
    for (double& a : accelerations) a *= mm_in_m;
    return accelerations;
  };
  building::Motion motion{
      .name = fmt::format("motion {}", place + 1), .step_s = values[0].cast<double>(), .x_mm_s2 = component(1)};
  if (values.size() > 2) motion.y_mm_s2 = component(2);
  return motion;
}

BuildingPtr studied(py::object const& file, py::object const& from, py::list const& motions, py::dict const& given,
                    BuildingWork options, py::object const& progress) {
  building::ReplacedKeys in_place{.motions = {}, .settings = given_of(building::settings_table(), given)};
  auto const stated = given_of(building::stated_table(), given);
  // Throws if step or unit are stated although there are no motions.
  if (motions.empty()) building::read_motions({}, stated);
  for (auto const& motion : motions) in_place.motions.push_back(motion_of(motion, in_place.motions.size(), stated));
  auto read = py::isinstance<py::dict>(file) ? building::building_of(json_of(file), in_place)
                                             : building::read_building(file.cast<std::filesystem::path>(), in_place);
  auto const is_campaign = py::isinstance<Campaign>(from);
  auto const directory = is_campaign ? std::filesystem::path() : from.cast<std::filesystem::path>();
  auto const campaign = is_campaign ? from.cast<CampaignPtr>() : nullptr;
  return in_a_thread<building::RunProgress>(
      [&](building::RunProgress const& now) {
        if (!progress.is_none()) progress(now.done, now.total);
      },
      [&](auto const& told, auto const& interrupted) {
        options.progress = told;
        options.interrupted = interrupted;
        auto study = campaign ? building_study(std::move(read), campaign->contents)
                              : building_study(std::move(read), campaign::Store::read(directory / store_name),
                                               directory.string());
        return std::make_shared<StudiedBuilding>(study_building(std::move(study), options));
      });
}

// For each law, draw and motion there is a row of measured numbers. Returns a view of `count` numbers of each row, from
// index `first` on. Its shape is (laws, draws, motions, count).
Array measures(py::object const& self, std::size_t first, std::size_t count) {
  auto const& studied = *self.cast<BuildingPtr>();
  auto const width = static_cast<py::ssize_t>(studied.layout.count()),
             motions = static_cast<py::ssize_t>(studied.study.file.motions.size()),
             draws = static_cast<py::ssize_t>(studied.study.file.settings.draws);
  constexpr py::ssize_t one = sizeof(double);
  Array array({static_cast<py::ssize_t>(studied.study.laws.size()), draws, motions, static_cast<py::ssize_t>(count)},
              {one * width * motions * draws, one * width * motions, one * width, one}, studied.measured.data() + first,
              self);
  array.attr("flags").attr("writeable") = false;
  return array;
}

Array quantity_of(StudiedBuilding const& studied, std::string const& key) {
  auto const values = peaks_of(studied, key);
  Array array({studied.study.laws.size(), static_cast<std::size_t>(studied.study.file.settings.draws),
               studied.study.file.motions.size()});
  std::ranges::copy(values, array.mutable_data());
  return array;
}

template <std::size_t size>
Array rows_of_history(std::vector<std::array<double, size>> const& rows) {
  return Array({rows.size(), size}, rows.empty() ? nullptr : rows.front().data());
}

py::dict history_of(StudiedBuilding const& studied, std::size_t law, std::size_t motion) {
  auto const run = [&] {
    py::gil_scoped_release const released;
    return building::nominal_run(studied.study, studied.study.laws.at(law), studied.study.file.motions.at(motion));
  }();
  auto const& h = run.history;
  py::dict result;
  result["outcome"] = std::string(building::name(run.outcome));
  result["time_s"] = Array(static_cast<py::ssize_t>(h.time_s.size()), h.time_s.data());
  result["base"] = rows_of_history(h.base);
  result["velocity"] = rows_of_history(h.velocity);
  result["shear_kN"] = rows_of_history(h.shear_kN);
  Array acceleration({h.acceleration.size(), studied.layout.floors + 1, std::size_t{2}});
  auto* to = acceleration.mutable_data();
  for (auto const& row : h.acceleration) to = std::ranges::copy(row, to).out;
  result["acceleration_mm_s2"] = acceleration;
  return result;
}

// The Python class isolaw.Error. This reference is never released, because exceptions may live longer than the module.
py::handle error_type;

// Replaces the names of command-line options in complaints by the names of the Python keywords.
std::vector<Complaint> in_keywords(std::vector<Complaint> complaints) {
  auto const rename = [](auto const& rows, std::string& where) {
    auto const end = std::min(where.find(' '), where.size());
    for (auto const& row : rows)
      if (where.substr(0, end) == "--" + row.option()) return void(where.replace(0, end, row.python()));
  };
  for (auto& complaint : complaints) {
    rename(campaign::setting_table(), complaint.where);
    rename(campaign::acceptance_table(), complaint.where);
    rename(data::reading_table(), complaint.where);
    rename(building::settings_table(), complaint.where);
    rename(building::stated_table(), complaint.where);
    for (auto const& row : building::stated_table())
      if (auto const at = complaint.advice.find("--" + row.option()); at != std::string::npos)
        complaint.advice.replace(at, complaint.advice.find(' ', complaint.advice.find(' ', at) + 1) - at, row.python());
    if (complaint.where == "--part") {
      complaint.where = "part";
      complaint.advice = "part=(1, 4) to part=(4, 4), for four machines";
    }
  }
  return complaints;
}

Unit unit_named(std::string const& text, Dimension dimension) {
  auto const unit = parse_unit(text);
  if (unit && unit->dimension == dimension) return *unit;
  throw Error({.where = "units",
               .found = in_quotes(text),
               .allowed = fmt::format("a unit of {}: {}", name(dimension), known_units(dimension))});
}

// Returns what isolaw.opensees needs to know about a law: its parameters in the law's order, how it is integrated, the
// factors of its bounds, the factors that convert the model's units, and the warnings about it. `source` is a campaign
// or the law's parameters. dead_band_mm and refinement are used only with parameters: a campaign has its own.
py::dict law_for_opensees(std::string const& law_id, py::object const& source, std::string const& device,
                          std::pair<std::string, std::string> const& units, bool in_plane, bool anyway,
                          double dead_band_mm, int refinement) {
  auto const& law = laws::find_law(law_id);
  auto const force = unit_named(units.first, Dimension::force), length = unit_named(units.second, Dimension::length);
  std::vector<double> parameters;
  std::vector<std::string> warnings;
  std::optional<double> lower, upper;
  std::string bounds = "no bounds, because the law was given by its parameters";
  bool is_fitted_as_springs = false;
  if (py::isinstance<Campaign>(source)) {
    auto const& campaign = source.cast<Campaign const&>();
    auto const subject = programs::make_subject(campaign.contents, campaign.summary, law_id, device);
    study::require_taken(subject.doubts,
                         study::whose(law_id, subject.lot ? std::nullopt : std::optional<std::string_view>(device)),
                         anyway);
    warnings = wording::sentences(subject.doubts.findings, wording::with_law);
    if (subject.doubts.objection) warnings.push_back(wording::remark(*subject.doubts.objection));
    warnings.insert(warnings.end(), subject.beyond.begin(), subject.beyond.end());
    parameters = subject.parameters;
    dead_band_mm = subject.dead_band_mm;
    refinement = subject.refinement;
    if (subject.bounds.lower) lower = subject.bounds.lower->overall;
    if (subject.bounds.upper) upper = subject.bounds.upper->overall;
    bounds = subject.bounds.source;
    if (auto const springs = fitted_law(campaign.contents, law_id, device).springs; in_plane && springs) {
      parameters = springs->parameters;
      is_fitted_as_springs = true;
    }
  } else {
    parameters = parameters_of(law, source);
    steps(refinement);
    if (constexpr double most_mm = 1e4; !(dead_band_mm >= 0.0 && dead_band_mm <= most_mm))
      throw Error({.where = "dead_band_mm",
                   .found = fmt::format("{}", dead_band_mm),
                   .allowed = fmt::format("0 to {} mm", most_mm)});
  }
  bool const is_coupled = !is_fitted_as_springs && !laws::no_coupled_form(law_id, parameters);
  if (in_plane && !is_coupled && !laws::springs_follow(law_id))
    throw Error({.where = "law " + law_id,
                 .found = "its force depends on the side, so springs around a circle cannot follow it",
                 .allowed = "a law of equal force on both sides"});
  py::dict result;
  result["parameters"] = parameters;
  result["dead_band"] = dead_band_mm / law.info.length.in_record_units;
  result["parts"] = refinement;
  result["length_to_law"] = length.in_record_units / law.info.length.in_record_units;
  result["force_from_law"] = law.info.force.in_record_units / force.in_record_units;
  result["lower"] = lower;
  result["upper"] = upper;
  result["bounds"] = bounds;
  result["springs"] = is_coupled ? 0 : laws::usual_springs;
  result["fitted_as_springs"] = is_fitted_as_springs;
  result["rate_independent"] = law.info.traits.rate_independent;
  result["warnings"] = warnings;
  return result;
}

void raise_error(Error const& thrown) {
  Error const error(in_keywords(thrown.complaints()));
  py::list complaints;
  for (auto const& c : error.complaints()) {
    py::dict one;
    one["where"] = c.where;
    one["found"] = c.found;
    one["allowed"] = c.allowed;
    one["advice"] = c.advice;
    complaints.append(one);
  }
  py::object exception = py::reinterpret_borrow<py::object>(error_type)(py::str(error.what()));
  exception.attr("complaints") = complaints;
  PyErr_SetObject(error_type.ptr(), exception.ptr());
}

void translate_errors() {
  error_type = py::object(py::module_::import("isolaw._error").attr("Error")).release();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (Error const& error) {
      raise_error(error);
    }
  });
}

void add_records(py::module_& m) {
  py::class_<Record, RecordPtr>(
      m, "Record",
      "A test record or a displacement history, in kN, mm and s, as read_record, read_motion, record and motion\n"
      "return it.")
      .def_readonly("name", &Record::name, "Name of the device.")
      .def_property_readonly(
          "file", [](Record const& r) { return r.raw.file; }, "The file that it was read from, or its name.")
      .def_property_readonly(
          "disp_mm", [](py::object self) { return view(self.cast<Record&>().raw.disp_mm, self); },
          "Displacements in mm, shape (samples,): a read-only view.")
      .def_property_readonly(
          "force_kN", [](py::object self) { return view_or_none(self.cast<Record&>().raw.force_kN, self); },
          "Forces in kN, shape (samples,): a read-only view; None for a motion.")
      .def_property_readonly(
          "time_s", [](py::object self) { return view_or_none(self.cast<Record&>().raw.time_s, self); },
          "Times in s, shape (samples,): a read-only view; None without time.")
      .def_property_readonly(
          "load_kN", [](py::object self) { return view_or_none(self.cast<Record&>().raw.load_kN, self); },
          "Vertical loads in kN, shape (samples,): a read-only view; None without.")
      .def_property_readonly(
          "recognised", [](Record const& r) { return wording::remarks(r.raw.recognised); },
          "A sentence for each decision of the reader, with its reason.")
      .def_property_readonly(
          "warnings", [](Record const& r) { return wording::remarks(r.raw.warnings); },
          "Sentences about doubtful things in the file.")
      .def(
          "__len__", [](Record const& r) { return r.raw.size(); }, "Number of samples.")
      .def(
          "_inspection_json", [](Record const& r, py::object const& vertical) { return inspected(r, vertical); },
          py::arg("vertical"));

  m.def("read", &record_of_file, py::arg("file"), py::arg("motion"), py::arg("name"), py::arg("how"));

  m.def(
      "same_device",
      [](std::vector<RecordPtr> const& tests, std::optional<std::string> const& name) {
        std::vector<data::NamedTest> named, uncorrected;
        for (auto const& test : tests) {
          if (test->raw.force_kN.empty())
            throw Error({.where = test->name, .found = "a motion without force", .allowed = "a record of a test"});
          named.push_back({.name = test->name, .record = test->raw});
          bool const is_known = test->uncorrected.size() > 0;
          if (is_known || !data::is_corrected(test->raw))
            uncorrected.push_back({.name = test->name, .record = is_known ? test->uncorrected : test->raw});
        }
        if (named.empty())
          throw Error({.where = "records", .found = "there are none", .allowed = "one record or more"});
        auto record = std::make_shared<Record>(Record{.name = {}, .raw = data::record_of_tests(std::move(named))});
        if (data::is_corrected(record->raw) && uncorrected.size() == tests.size())
          record->uncorrected = data::record_of_tests(std::move(uncorrected));
        record->name =
            name.value_or(tests.size() == 1 ? tests.front()->name : campaign::name_of_tests(record->raw.tests));
        return record;
      },
      py::arg("records"), py::arg("name"));

  m.def(
      "record",
      [](std::string const& name, Rows const& disp_mm, std::optional<Rows> const& force_kN,
         std::optional<Rows> const& time_s, std::optional<Rows> const& load_kN) {
        return std::make_shared<Record>(
            Record{.name = name,
                   .raw = data::record_of_values(name, {.disp_mm = values_of(disp_mm, "disp_mm"),
                                                        .force_kN = values_of(force_kN, "force_kN"),
                                                        .time_s = values_of(time_s, "time_s"),
                                                        .load_kN = values_of(load_kN, "load_kN")})});
      },
      py::arg("name"), py::arg("disp_mm"), py::arg("force_kN"), py::arg("time_s"), py::arg("load_kN"));
}

void add_tables(py::module_& m) {
  m.def("catalogue_json", &catalogue_json);
  m.def("options_json", [] {
    auto of_building = described(building::settings_table());
    of_building.update(described(building::stated_table()));
    return Json{{"settings", described(campaign::setting_table())},
                {"reading", described(data::reading_table())},
                {"acceptance", described(campaign::acceptance_table())},
                {"building", std::move(of_building)}}
        .dump();
  });
}

void add_laws(py::module_& m) {
  m.def(
      "box",
      [](std::string const& law_id, Record const& record, py::dict const& how) {
        auto const box = campaign::search_box(laws::find_law(law_id), data::clean(record.raw, {}), settings_of(how));
        py::dict result;
        for (auto const& p : box.parameters) {
          py::dict one;
          one["unit"] = p.unit;
          one["free"] = p.free;
          one["value"] = p.free ? py::object(py::none()) : py::object(py::float_(p.value));
          one["lower"] = p.lower;
          one["upper"] = p.upper;
          one["scale"] = p.scale == laws::Scale::linear ? "linear" : "logarithmic";
          result[py::str(p.name)] = one;
        }
        return result;
      },
      py::arg("law"), py::arg("record"), py::arg("how"));

  m.def("force", &force_of, py::arg("law"), py::arg("parameters"), py::arg("motion"), py::arg("how"),
        py::arg("refinement"), py::arg("out").noconvert());

  py::class_<Model, std::shared_ptr<Model>>(m, "Model", "A law on a record; see isolaw.Model.")
      .def(py::init([](std::string const& law, RecordPtr record, py::dict const& how, int refinement) {
             return std::make_shared<Model>(law, std::move(record), settings_of(how), refinement);
           }),
           py::arg("law"), py::arg("record"), py::arg("how"), py::arg("refinement"))
      .def_property_readonly("disp_mm",
                             [](py::object self) { return view(self.cast<Model&>().record().disp_mm, self); })
      .def_property_readonly("force_kN",
                             [](py::object self) { return view(self.cast<Model&>().record().force_kN, self); })
      .def_property_readonly("time_s", [](py::object self) { return view(self.cast<Model&>().record().time_s, self); })
      .def("objective", &Model::objective, py::arg("parameters"))
      .def("objectives", &Model::objectives, py::arg("population"), py::arg("out").noconvert())
      .def("force", &Model::force, py::arg("parameters"), py::arg("out").noconvert());
}

void add_campaigns(py::module_& m) {
  py::class_<Campaign, CampaignPtr>(m, "Campaign", "A campaign; see isolaw.Campaign.")
      .def(
          "_summary_json", [](Campaign const& c) { return render::summary_json(c.summary); },
          py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("complete", [](Campaign const& c) { return c.contents.complete(); })
      .def("force",
           [](py::object self, std::string const& law, std::string const& device) {
             return view(self.cast<Campaign&>().fit(law, device).force_kN, self);
           })
      .def("runs", &runs_of)
      .def("parameters",
           [](Campaign const& c, std::string const& law, std::string const& device) {
             auto const fitted = fitted_law(c.contents, law, device);
             py::dict values;
             auto const& entry = laws::find_law(law);
             for (std::size_t i = 0; i < fitted.parameters.size(); ++i)
               values[py::str(std::string(entry.parameters[i].name))] = fitted.parameters[i];
             return values;
           })
      .def("refinement", [](Campaign const& c, std::string const& law,
                            std::string const& device) { return fitted_law(c.contents, law, device).refinement; })
      .def("record",
           [](Campaign const& c, std::string const& device) {
             auto const& one = c.contents.devices[c.device(device)];
             if (!one.usable()) throw Error({.where = "device '" + device + "'", .found = one.refusal});
             return std::make_shared<Record>(Record{.name = one.name, .raw = one.raw, .uncorrected = one.uncorrected});
           })
      .def("fit_channel",
           [](py::object self, std::string const& device, std::string const& channel) {
             auto const& c = self.cast<Campaign&>();
             auto const& record = c.contents.devices[c.device(device)].record;
             return view(channel == "disp_mm"    ? record.disp_mm
                         : channel == "force_kN" ? record.force_kN
                                                 : record.time_s,
                         self);
           })
      .def("write", [](Campaign const& c, std::filesystem::path const& directory) {
        py::gil_scoped_release const released;
        render::write_outputs(c.summary, directory);
      });
  m.def("law_for_opensees", &law_for_opensees, py::arg("law"), py::arg("source"), py::arg("device"), py::arg("units"),
        py::arg("in_plane"), py::arg("anyway"), py::arg("dead_band_mm"), py::arg("refinement"));
}

void add_calibration(py::module_& m) {
  m.def("load", &loaded, py::arg("directory"));
  m.def(
      "calibrate",
      [](std::vector<RecordPtr> const& records, py::dict const& given, py::dict const& vertical, int jobs,
         std::optional<std::filesystem::path> out, bool fresh, std::string title,
         std::optional<std::pair<int, int>> part, py::object const& progress) {
        require_jobs(jobs);
        CalibrateOptions options{.directory = std::move(out), .fresh = fresh, .title = std::move(title)};
        options.run.jobs = jobs;
        if (part) options.part = {.number = part->first, .of = part->second};
        return calibrated(records, given, vertical, std::move(options), progress);
      },
      py::arg("records"), py::arg("given"), py::arg("vertical"), py::arg("jobs"), py::arg("out"), py::arg("fresh"),
      py::arg("title"), py::arg("part"), py::arg("progress"));
  m.def(
      "merge",
      [](std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts, int jobs, bool fresh,
         py::object const& progress) {
        require_jobs(jobs);
        MergeCallOptions options{.fresh = fresh};
        options.run.jobs = jobs;
        return merged(out, parts, std::move(options), progress);
      },
      py::arg("out"), py::arg("parts"), py::arg("jobs"), py::arg("fresh"), py::arg("progress"));
}

void add_buildings(py::module_& m) {
  py::class_<StudiedBuilding, BuildingPtr>(m, "Building", "A building that was studied; see isolaw.Building.")
      .def(
          "json", [](StudiedBuilding const& b) { return render::building_json(b.study, *b.answers); },
          py::call_guard<py::gil_scoped_release>())
      .def("quantity", &quantity_of, py::arg("key"))
      .def("accelerations",
           [](py::object const& self) {
             auto const& l = self.cast<BuildingPtr>()->layout;
             return measures(self, l.acceleration(0), l.floors + 1);
           })
      .def("drifts",
           [](py::object const& self) {
             auto const& l = self.cast<BuildingPtr>()->layout;
             return measures(self, l.drift(0), l.floors);
           })
      .def("displacements",
           [](py::object const& self) {
             auto const& l = self.cast<BuildingPtr>()->layout;
             return measures(self, l.displacement(0), l.bearings);
           })
      .def("history", &history_of, py::arg("law"), py::arg("motion"))
      .def("write", [](StudiedBuilding const& b, std::filesystem::path const& directory) {
        py::gil_scoped_release const released;
        render::write_building_outputs(b.study, *b.answers, directory);
      });
  m.def(
      "building",
      [](py::object const& file, py::object const& from, py::list const& motions, py::dict const& given, int jobs,
         std::optional<std::filesystem::path> out, bool fresh, py::object const& progress) {
        require_jobs(jobs);
        return studied(file, from, motions, given, {.jobs = jobs, .directory = std::move(out), .fresh = fresh},
                       progress);
      },
      py::arg("file"), py::arg("campaign"), py::arg("motions"), py::arg("given"), py::arg("jobs"), py::arg("out"),
      py::arg("fresh"), py::arg("progress"));
}

study::ConditionsResult conditions_of(std::filesystem::path const& file, bool allow_outside) {
  auto lot = campaign::read_lot_file(file, {.allow_outside = allow_outside,
                                            .other_out = true,
                                            .is_built_in_rules = rules::is_built_in,
                                            .check_design = [](std::string_view text) { rules::parse_design(text); }});
  if (!lot.conditions)
    throw Error({.where = printable(file.string()),
                 .found = "the lot file has no table [conditions]",
                 .allowed = "[conditions] with a reference, and [[device.test]] tables with temperature-C and order",
                 .advice = "isolaw example DIR --conditions writes a lot that has them"});
  complete_acceptance(lot.acceptance);
  return study::build_conditions(campaign::observe_tests(lot), lot.title, lot.acceptance);
}

void add_conditions(py::module_& m) {
  using study::ConditionsResult;
  py::class_<ConditionsResult>(m, "Conditions", "A study of conditions; see isolaw.Conditions.")
      .def("json", &render::conditions_json, py::call_guard<py::gil_scoped_release>())
      .def("text", [](ConditionsResult const& result) { return render::conditions_text(result, false); })
      .def(
          "json_with_plan",
          [](ConditionsResult result, int devices) {
            if (devices < 1 || devices > study::most_planned_devices)
              throw Error({.where = "devices",
                           .found = fmt::format("{}", devices),
                           .allowed = fmt::format("1 to {}", study::most_planned_devices)});
            result.plan = study::plan_tests(result, devices);
            return render::conditions_json(result);
          },
          py::arg("devices"), py::call_guard<py::gil_scoped_release>());
  m.def("conditions", &conditions_of, py::arg("file"), py::arg("allow_outside"),
        py::call_guard<py::gil_scoped_release>());
}

}  // namespace
}  // namespace isolaw::python

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of isolaw; import isolaw instead.";
  m.attr("__version__") = ISOLAW_VERSION;
  using namespace isolaw::python;
#if PYBIND11_VERSION_HEX < 0x020C0000
  // This pybind11 reads the arrays of NumPy 2 wrongly, without any error.
  if (auto const version = py::module_::import("numpy").attr("__version__").cast<std::string>();
      !version.starts_with("1."))
    throw py::import_error("isolaw: this build knows NumPy 1 only, and NumPy " + version +
                           " is installed; try: pip install 'numpy<2'");
#endif
  translate_errors();
  // Adds a class before the functions that take or return it, because pybind11 writes its name into their docstrings.
  add_records(m);
  add_tables(m);
  add_laws(m);
  add_campaigns(m);
  add_calibration(m);
  add_buildings(m);
  add_conditions(m);
}
