// The compiled part of the Python package `isolaw`. It gives NumPy views of the library's values and releases Python's
// global lock (GIL) during long calls. Users read the docstrings in this file and in isolaw/__init__.py. tests/python
// compares the package with its type stub __init__.pyi.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core.hpp"
#include "isolaw/api/building_work.hpp"
#include "isolaw/api/conditions.hpp"
#include "isolaw/api/isolaw.hpp"
#include "isolaw/app/app.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/lot_conditions.hpp"
#include "isolaw/campaign/named_device.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/programs/model.hpp"
#include "isolaw/programs/subject.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/json/conditions_json.hpp"
#include "isolaw/render/json/inspection_json.hpp"
#include "isolaw/render/terminal/conditions_text.hpp"
#include "isolaw/study/conditions.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::python {
namespace {

// A read-only array of doubles in C order.
using Rows = nb::ndarray<double const, nb::c_contig, nb::device::cpu>;

std::string text_of(nb::handle value) {
  nb::str const text(value);
  Py_ssize_t size = 0;
  auto const* const first = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (first == nullptr) nb::raise_python_error();
  return {first, static_cast<std::size_t>(size)};
}

std::string shown(nb::handle value) {
  return printable(nb::cast<std::string>(nb::repr(value)).substr(0, 100));
}

// Returns a read-only array that shows `values` without copying them. `owner` is the Python object that keeps them
// alive.
nb::object view(std::vector<double> const& values, nb::handle owner) {
  return nb::ndarray<nb::numpy, double const>(values.data(), {values.size()}, owner).cast();
}

nb::object view_or_none(std::vector<double> const& values, nb::handle owner) {
  return values.empty() ? nb::object(nb::none()) : view(values, owner);
}

// Reads numbers that the caller gives. An array of doubles in C order is used without a copy. NumPy converts anything
// else.
Rows rows_of(nb::handle given, char const* what, std::string allowed = "an array of numbers") {
  Rows rows;
  auto const refuse = [&](std::string found, std::string advice) {
    throw Error({.where = what, .found = std::move(found), .allowed = allowed, .advice = std::move(advice)});
  };
  if (nb::hasattr(given, "mask") && nb::cast<bool>(nb::module_::import_("numpy").attr("ma").attr("is_masked")(given)))
    refuse("an array with masked values", "the values without them");
  if (nb::try_cast(given, rows, false)) return rows;
  try {
    auto const numpy = nb::module_::import_("numpy");
    nb::object const array = numpy.attr("asarray")(given);
    // Refuses types that NumPy would convert wrongly: times would become nanoseconds, complex numbers would lose their
    // imaginary parts.
    auto const kind = nb::cast<std::string>(array.attr("dtype").attr("kind"));
    if (kind == "m" || kind == "M") refuse("dates or times", "seconds as numbers, such as times.dt.total_seconds()");
    if (kind == "c") refuse("complex numbers", "");
    bool const is_text = kind == "U" || kind == "S";
    if (!is_text && nb::try_cast(numpy.attr("asarray")(array, "float64", "C"), rows, false)) return rows;
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
  }
  throw Error({.where = what, .found = shown(given) + " is no array of numbers", .allowed = std::move(allowed)});
}

std::vector<double> values_of(Rows const& array, char const* what) {
  if (array.ndim() != 1)
    throw Error({.where = what, .found = fmt::format("an array of {} dimensions", array.ndim()), .allowed = "one"});
  return {array.data(), array.data() + array.size()};
}

// Reads a channel of a record that the caller gives. For None it returns an empty channel.
std::vector<double> channel_of(nb::handle given, char const* what) {
  return given.is_none() ? std::vector<double>() : values_of(rows_of(given, what), what);
}

// Returns pointers to the records in a list that the caller gives. They are valid as long as the list lives.
std::vector<Record const*> records_of(nb::list const& given) {
  std::vector<Record const*> records;
  for (nb::handle const one : given) {
    Record const* record = nullptr;
    if (!nb::try_cast(one, record) || record == nullptr)
      throw Error({.where = "records", .found = shown(one), .allowed = "records"});
    records.push_back(record);
  }
  return records;
}

}  // namespace

Json json_of(nb::handle value) {
  if (value.is_none()) return {};
  if (nb::isinstance<nb::bool_>(value)) return nb::cast<bool>(value);
  if (nb::isinstance<nb::str>(value)) return nb::cast<std::string>(value);
  if (nb::isinstance<nb::float_>(value)) return nb::cast<double>(value);
  if (PyIndex_Check(value.ptr()) != 0) {
    auto const whole = nb::steal<nb::int_>(PyNumber_Index(value.ptr()));
    auto const text = text_of(whole);
    auto const number = Json::parse(text);  // an integer above 64 bits becomes a float; then the text is returned
    return number.is_number_integer() ? number : Json(text);
  }
  // A number of another type, such as numpy.float32. An array of one number has a length and is none.
  if (nb::hasattr(value, "__float__") && !nb::hasattr(value, "__len__")) return nb::cast<double>(nb::float_(value));
  if (nb::isinstance<nb::dict>(value)) {
    Json object = Json::object();
    for (auto const& [key, item] : nb::cast<nb::dict>(value)) object[text_of(key)] = json_of(item);
    return object;
  }
  if (!nb::isinstance<nb::list>(value) && !nb::isinstance<nb::tuple>(value)) return text_of(value);
  Json array = Json::array();
  for (auto const& item : value) array.push_back(json_of(item));
  return array;
}

namespace {

campaign::Settings settings_of(nb::dict const& given) {
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
      settings.method = row.only_method.value_or(settings.method);
      one["method"] = row.only_method ? campaign::find_setting("method")->get(settings) : Json();
      one["stored_only"] = row.stored_only;
    }
  }
  return table;
}

Record record_of_file(std::filesystem::path const& file, bool motion, std::optional<std::string> const& name,
                      nb::dict const& how) {
  data::ReadOptions options;
  lay_over(data::reading_table(), given_of(data::reading_table(), how), options);
  options.corrections.validate();
  nb::gil_scoped_release const released;
  Record record{.name = name.value_or(printable(file.stem().string())),
                .raw = motion ? data::read_motion(file, options) : data::read_record(file, options)};
  if (data::is_corrected(record.raw)) try {
      record.uncorrected = data::read_record(file, *data::without_corrections(options));
    } catch (Error const&) {  // `uncorrected` stays empty, and reports say so
    }
  return record;
}

// Reads a compression test. The caller gives it as a file, as K_v in kN/mm, or as a dict with a file, loads and
// keywords for reading. None means that there is no test.
campaign::VerticalInput vertical_input(nb::handle const& given, std::string const& where) {
  campaign::VerticalInput test;
  if (given.is_none()) return test;
  auto const take_file = [&](nb::handle const& file) {
    test.file = nb::cast<std::filesystem::path>(file);
    test.shown_file = printable(test.file.filename().string());
  };
  if (nb::isinstance<nb::dict>(given)) {
    auto const told = nb::cast<nb::dict>(given);
    std::vector<data::Reading> rows;
    for (auto const& row : data::reading_table())
      if (!row.of_test) rows.push_back(row);
    nb::dict reading;
    for (auto const& [key, value] : told) {
      auto const name = nb::cast<std::string>(key);
      if (name == "file")
        take_file(value);
      else if (name == "loads")
        test.loads = data::parse_loads(nb::cast<std::string>(value));
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
  if (nb::isinstance<nb::float_>(given) || (nb::isinstance<nb::int_>(given) && !nb::isinstance<nb::bool_>(given))) {
    test.stated_kN_per_mm = nb::cast<double>(given);
    if (!(*test.stated_kN_per_mm > 0.0) || !std::isfinite(*test.stated_kN_per_mm))
      throw Error({.where = where,
                   .found = fmt::format("{}", *test.stated_kN_per_mm),
                   .allowed = "vertical stiffness in kN/mm, above 0"});
    return test;
  }
  take_file(given);
  return test;
}

int steps(int refinement) {
  if (refinement < 1 || refinement > 1000)
    throw Error(
        {.where = "refinement", .found = fmt::format("{}", refinement), .allowed = "1 to 1000 steps per sample"});
  return refinement;
}

std::vector<NamedValue> named_values(nb::dict const& given) {
  std::vector<NamedValue> named;
  std::vector<Complaint> complaints;
  for (auto const& [key, value] : given) {
    auto const name = text_of(key);
    if (double number = 0.0; nb::try_cast(value, number))
      named.push_back({.name = name, .value = number});
    else
      complaints.push_back(
          {"parameters", fmt::format("{} = {} is no number", printable(name), shown(value)), "a number", {}});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return named;
}

// Returns a law's parameters in the law's order. The caller gives them as a dict by name or as values in that order.
std::vector<double> parameters_of(laws::LawEntry const& law, nb::object const& given,
                                  JointLimits joint_limits = JointLimits::checked) {
  if (nb::isinstance<nb::dict>(given))
    return parameters_in_order(law, named_values(nb::cast<nb::dict>(given)), "parameters", joint_limits);
  auto const values =
      values_of(rows_of(given, "parameters", "a dict by name, or numbers in the law's order"), "parameters");
  if (values.size() != law.parameters.size())
    throw Error(
        {.where = "parameters",
         .found = fmt::format("{} values", values.size()),
         .allowed = fmt::format("the {} of {} in its order, or a dict by name", law.parameters.size(), law.info.id),
         .advice = fmt::format("isolaw.laws()['{}']", law.info.id)});
  std::vector<NamedValue> named;
  for (std::size_t i = 0; i < values.size(); ++i)
    named.push_back({.name = std::string(law.parameters[i].name), .value = values[i]});
  return parameters_in_order(law, named, "parameters", joint_limits);
}

struct Result {
  nb::object array;
  std::span<double> values;  // the numbers in `array`
};

// Returns the array for a result: the array that the caller passed as `out`, or a new one.
Result result_array(nb::object const& out, std::size_t size) {
  if (out.is_none()) {
    std::vector<double> values(size);
    std::span const all(values);
    return {array_of(std::move(values)), all};
  }
  if (nb::ndarray<double, nb::ndim<1>, nb::c_contig, nb::device::cpu> array;
      nb::try_cast(out, array, false) && array.size() == size)
    return {out, {array.data(), size}};
  throw Error({.where = "out",
               .found = "another array",
               .allowed = fmt::format("a writeable contiguous float64 array of {} values", size)});
}

nb::object force_of(std::string const& law_id, nb::object const& parameters, Record const& motion, nb::dict const& how,
                    int refinement, double dead_band_mm, nb::object const& out) {
  auto const& law = laws::find_law(law_id);
  auto const values = parameters_of(law, parameters);
  auto result = result_array(out, motion.raw.size());
  auto const settings = settings_of(how);
  steps(refinement);
  if (!(dead_band_mm >= 0.0) || !std::isfinite(dead_band_mm))
    throw Error({.where = "dead_band_mm", .found = fmt::format("{}", dead_band_mm), .allowed = "mm, 0 or more"});
  nb::gil_scoped_release const released;
  auto path = data::motion_of(motion.raw);
  path.dead_band_mm = dead_band_mm;
  fit::LawOnMotion const model(law, path, settings.integration, settings.turning_points, refinement);
  model.force_kN(values, result.values);
  return result.array;
}

// A law together with a cleaned record. calibrate() cleans its records in the same way.
class Model {
 public:
  Model(std::string const& law, Record const& record, campaign::Settings const& how, int refinement)
      : record_(std::make_shared<data::FitRecord>(data::clean(record.raw, how.clean))),
        model_(laws::find_law(law), *record_, how.integration, how.turning_points, steps(refinement)) {}

  laws::LawEntry const& law() const { return model_.law(); }
  data::FitRecord const& record() const { return *record_; }

  double objective(nb::object const& parameters) const {
    auto const values = parameters_of(law(), parameters, JointLimits::unchecked);
    std::vector<double> work;
    return model_.objective(values, work);
  }

  nb::object objectives(nb::object const& population, nb::object const& out) const {
    auto const rows = rows_of(population, "population");
    auto const dimension = law().parameters.size();
    if (rows.ndim() != 2 || rows.shape(1) != dimension)
      throw Error({.where = "population",
                   .found = rows.ndim() == 2 ? fmt::format("rows of {} values", rows.shape(1))
                                             : fmt::format("an array of {} dimensions", rows.ndim()),
                   .allowed = fmt::format("a row for each candidate, with the {} parameters of {} in its order",
                                          dimension, law().info.id)});
    auto const count = rows.shape(0);
    auto const result = result_array(out, count);
    nb::gil_scoped_release const released;
    model_.objectives(
        count,
        [&](std::size_t i, std::span<double> values) {
          std::copy_n(rows.data() + i * dimension, dimension, values.begin());
        },
        result.values);
    return result.array;
  }

  nb::object force(nb::object const& parameters, nb::object const& out) const {
    auto const values = parameters_of(law(), parameters);
    auto const result = result_array(out, record_->size());
    std::ranges::copy(model_.force_kN(values), result.values.begin());
    return result.array;
  }

  nb::object residual(nb::object const& parameters) const {
    auto residuals = model_.force_kN(parameters_of(law(), parameters, JointLimits::unchecked));
    auto const spreads_kN = model_.spreads_kN();
    auto const weights = model_.residual_weights();
    for (std::size_t i = 0; i < residuals.size(); ++i)
      residuals[i] =
          weights[i] > 0.0 ? std::sqrt(weights[i]) * (residuals[i] - record_->force_kN[i]) / spreads_kN[i] : 0.0;
    return array_of(std::move(residuals));
  }

 private:
  std::shared_ptr<data::FitRecord const> record_;
  fit::LawOnRecord model_;
};

// Returns the doubts about a law as sentences. Throws Error if there is an objection to the law and `anyway` is false.
std::vector<std::string> accepted_doubts(study::Doubts const& doubts, std::string_view law,
                                         std::optional<std::string_view> device, bool anyway) {
  study::require_no_objection(doubts, study::law_and_device_text(law, device), anyway);
  auto sentences = wording::sentences(doubts.findings, wording::with_law);
  if (doubts.objection) sentences.push_back(wording::remark(*doubts.objection));
  return sentences;
}

// Returns the force of a fitted law under another motion, computed as in its fit, and the doubts about the law and this
// motion as sentences. Throws Error if there is an objection to the law and `anyway` is false.
nb::tuple force_under(Campaign const& campaign, std::string const& law_id, std::string const& device,
                      Record const& motion, bool anyway) {
  auto const fitted = fitted_law(campaign.contents, law_id, device);
  auto const one_device =
      campaign::named_device(campaign.contents, device) ? std::optional<std::string_view>(device) : std::nullopt;
  auto sentences = accepted_doubts(study::doubts(campaign.summary, law_id, one_device), law_id, one_device, anyway);
  auto const& law = laws::find_law(law_id);
  auto path = data::motion_of(motion.raw);
  path.dead_band_mm = fitted.dead_band_mm;
  fit::LawOnMotion const model(law, path, fitted.integration, fitted.turning_points, fitted.refinement);
  std::ranges::move(cautions(law, fitted, path), std::back_inserter(sentences));
  return nb::make_tuple(array_of(model.force_kN(fitted.parameters)), sentences);
}

nb::dict runs_of(Campaign const& campaign, std::string const& law, std::string const& device) {
  campaign.fit(law, device);
  auto const index = campaign.device(device);
  std::vector<campaign::Run const*> runs;
  for (auto const& run : campaign.contents.runs)
    if (run.device == index && run.law == law) runs.push_back(&run);
  auto const dimension = laws::find_law(law).parameters.size();
  std::vector<int> number;
  std::vector<double> objective, parameters;
  nb::list outcome, history;
  for (auto const* run : runs) {
    number.push_back(run->number);
    objective.push_back(run->objective);
    for (std::size_t p = 0; p < dimension; ++p) parameters.push_back(run->usable() ? run->parameters[p] : std::nan(""));
    outcome.append(std::string(campaign::name(run->outcome)));
    history.append(array_of(run->history));
  }
  nb::dict result;
  result["number"] = array_of(std::move(number), {runs.size()});
  result["objective"] = array_of(std::move(objective));
  result["parameters"] = array_of(std::move(parameters), {runs.size(), dimension});
  result["outcome"] = outcome;
  result["history"] = history;
  return result;
}

// Runs `work` in another thread without Python's global lock. Python delivers signals only to the main thread, so the
// calling thread waits, checks for signals and passes progress to the Python function `tell`. An exception from a
// signal or from `tell` stops the work and is thrown again when the work has ended. Otherwise an exception from the
// work itself, if there is one, is thrown again.
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
        nb::gil_scoped_release const released;
        std::unique_lock lock(mutex);
        changed.wait_for(lock, patience, [&] { return ended || (latest && !stop); });
        told = std::exchange(latest, std::nullopt);
        over = ended;
      }
      if (stop) continue;
      try {
        if (PyErr_CheckSignals() != 0) nb::raise_python_error();
        if (told) tell(*told);
      } catch (...) {
        asked = std::current_exception();
        stop = true;
      }
    }
    nb::gil_scoped_release const released;  // lets other Python threads run
  }
  if (asked) std::rethrow_exception(asked);
  if (failure) std::rethrow_exception(failure);
  return std::move(*result);
}

CampaignPtr worked(campaign::RunOptions run, nb::object const& progress,
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
  nb::gil_scoped_release const released;
  return std::make_shared<Campaign>(std::move(contents));
}

}  // namespace

std::vector<campaign::NamedRecord> named_records(nb::list const& records, nb::dict const& vertical) {
  std::vector<campaign::NamedRecord> named;
  for (auto const* record : records_of(records)) {
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
    auto const name = nb::cast<std::string>(key);
    auto const found = std::ranges::find(named, name, &campaign::NamedRecord::name);
    if (found == named.end())
      throw Error({.where = "vertical",
                   .found = in_quotes(name) + ": no such device",
                   .allowed = "names of the records",
                   .advice = fmt::format("vertical={{'{}': FILE}}", named.empty() ? "D1" : named.front().name)});
    found->vertical = vertical_input(test, "vertical of " + in_quotes(name));
  }
  return named;
}

namespace {

CampaignPtr calibrated(nb::list const& records, nb::dict const& given, nb::dict const& vertical,
                       CalibrateOptions options, nb::object const& progress) {
  auto const settings = settings_of(given);
  lay_over(campaign::acceptance_table(), given_of(campaign::acceptance_table(), given), options.acceptance);
  auto named = named_records(records, vertical);
  return worked(options.run, progress, [&](campaign::RunOptions const& run) {
    options.run = run;
    return calibrate(std::move(named), settings, options);
  });
}

CampaignPtr merged(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                   MergeCallOptions options, nb::object const& progress) {
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
  nb::gil_scoped_release const released;
  return std::make_shared<Campaign>(campaign::Store::read(directory / store_name));
}

using BuildingPtr = std::shared_ptr<StudiedBuilding>;

// Reads a ground motion. The caller gives it as a tuple (step in s, accelerations along x in m/s2[, along y]), or as a
// text that building::read_motion() understands.
building::Motion motion_of(nb::handle const& given, std::size_t place, Values const& stated) {
  if (nb::isinstance<nb::str>(given)) return building::read_motions({nb::cast<std::string>(given)}, stated).front();
  auto const values = nb::cast<nb::tuple>(given);
  constexpr double mm_in_m = 1e3;
  auto const component = [&](std::size_t i) {
    auto accelerations = values_of(rows_of(values[i], "motion"), "motion");
    for (double& a : accelerations) a *= mm_in_m;
    return accelerations;
  };
  building::Motion motion{
      .name = fmt::format("motion {}", place + 1), .step_s = nb::cast<double>(values[0]), .x_mm_s2 = component(1)};
  if (values.size() > 2) motion.y_mm_s2 = component(2);
  return motion;
}

BuildingPtr studied(nb::object const& file, nb::object const& from, nb::list const& motions, nb::dict const& given,
                    BuildingWork options, nb::object const& progress) {
  building::ReplacedKeys in_place{.motions = {}, .settings = given_of(building::settings_table(), given)};
  auto const stated = given_of(building::stated_table(), given);
  // This call throws if the caller stated a step or a unit but gave no motions.
  if (motions.empty()) building::read_motions({}, stated);
  for (auto const& motion : motions) in_place.motions.push_back(motion_of(motion, in_place.motions.size(), stated));
  auto read = nb::isinstance<nb::dict>(file) ? building::building_of(json_of(file), in_place)
                                             : building::read_building(nb::cast<std::filesystem::path>(file), in_place);
  auto const* const campaign = nb::isinstance<Campaign>(from) ? nb::cast<Campaign const*>(from) : nullptr;
  auto const directory = campaign ? std::filesystem::path() : nb::cast<std::filesystem::path>(from);
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
nb::object measures(nb::handle self, std::size_t first, std::size_t count) {
  auto const& studied = nb::cast<StudiedBuilding const&>(self);
  auto const width = studied.layout.count(), motions = studied.study.file.motions.size(),
             draws = static_cast<std::size_t>(studied.study.file.settings.draws);
  std::array const shape{studied.study.laws.size(), draws, motions, count};
  std::array const strides{static_cast<std::int64_t>(width * motions * draws),
                           static_cast<std::int64_t>(width * motions), static_cast<std::int64_t>(width),
                           std::int64_t{1}};
  return nb::ndarray<nb::numpy, double const>(studied.measured.data() + first, shape.size(), shape.data(), self,
                                              strides.data())
      .cast();
}

nb::object quantity_of(StudiedBuilding const& studied, std::string const& key) {
  return array_of(peaks_of(studied, key),
                  {studied.study.laws.size(), static_cast<std::size_t>(studied.study.file.settings.draws),
                   studied.study.file.motions.size()});
}

template <class Rows>
std::vector<double> joined_rows(Rows const& rows) {
  std::vector<double> all;
  for (auto const& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

nb::dict history_of(StudiedBuilding const& studied, std::size_t law, std::size_t motion) {
  auto const run = [&] {
    nb::gil_scoped_release const released;
    return building::nominal_run(studied.study, studied.study.laws.at(law), studied.study.file.motions.at(motion));
  }();
  auto const& h = run.history;
  nb::dict result;
  result["outcome"] = std::string(building::name(run.outcome));
  result["time_s"] = array_of(h.time_s);
  result["base"] = array_of(joined_rows(h.base), {h.base.size(), 3});
  result["velocity"] = array_of(joined_rows(h.velocity), {h.velocity.size(), 3});
  result["shear_kN"] = array_of(joined_rows(h.shear_kN), {h.shear_kN.size(), 2});
  result["acceleration_mm_s2"] =
      array_of(joined_rows(h.acceleration), {h.acceleration.size(), studied.layout.floors + 1, 2});
  return result;
}

// The Python class isolaw.Error. This reference is never released, because exceptions may live longer than the module.
nb::handle error_type;

// Replaces the names of command-line options in complaints by the names of the Python keywords. For an option that is
// in no table, such as --count, the keyword is the name of the option, `count`.
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
    if (complaint.where.starts_with("--")) {
      complaint.where.erase(0, 2);
      auto const end = std::min(complaint.where.find(' '), complaint.where.size());
      std::ranges::replace(complaint.where.begin(), complaint.where.begin() + static_cast<std::ptrdiff_t>(end), '-',
                           '_');
    }
  }
  return complaints;
}

}  // namespace

std::vector<std::string> texts_in_keywords(std::vector<Complaint> complaints) {
  std::vector<std::string> texts;
  for (auto& complaint : in_keywords(std::move(complaints))) {
    for (auto const& row : campaign::acceptance_table())
      for (std::size_t at = 0; (at = complaint.advice.find("--" + row.option(), at)) != std::string::npos;)
        complaint.advice.replace(at, 2 + row.option().size(), row.python());
    texts.push_back(to_string(complaint));
  }
  return texts;
}

namespace {

Unit unit_named(std::string const& text, Dimension dimension) {
  auto const unit = parse_unit(text);
  if (unit && unit->dimension == dimension) return *unit;
  throw Error({.where = "units",
               .found = in_quotes(text),
               .allowed = fmt::format("a unit of {}: {}", name(dimension), known_units(dimension))});
}

// Returns what isolaw.opensees needs to know about a law: its parameters in the law's order, how it is integrated, the
// factors of its bounds, the factors that convert the model's units, and the warnings about it. `source` is a campaign
// or the law's parameters. dead_band_mm and refinement are used only with parameters, because a campaign keeps its own
// values of them.
nb::dict law_for_opensees(std::string const& law_id, nb::object const& source, std::string const& device,
                          std::pair<std::string, std::string> const& units, bool in_plane, bool anyway,
                          double dead_band_mm, int refinement) {
  auto const& law = laws::find_law(law_id);
  auto const force = unit_named(units.first, Dimension::force), length = unit_named(units.second, Dimension::length);
  std::vector<double> parameters;
  std::vector<std::string> warnings;
  std::optional<double> lower, upper;
  std::string bounds = "no bounds, because the law was given by its parameters";
  bool is_fitted_as_springs = false;
  if (nb::isinstance<Campaign>(source)) {
    auto const& campaign = nb::cast<Campaign const&>(source);
    auto const subject = programs::make_subject(campaign.contents, campaign.summary, law_id, device);
    warnings = accepted_doubts(subject.doubts, law_id,
                               subject.lot ? std::nullopt : std::optional<std::string_view>(device), anyway);
    warnings.insert(warnings.end(), subject.beyond_tests.begin(), subject.beyond_tests.end());
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
  nb::dict result;
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
  nb::list complaints;
  for (auto const& c : error.complaints()) {
    nb::dict one;
    one["where"] = printable(c.where, true);
    one["found"] = printable(c.found, true);
    one["allowed"] = printable(c.allowed, true);
    one["advice"] = printable(c.advice, true);
    complaints.append(one);
  }
  nb::object exception = error_type(printable(error.what(), true));
  exception.attr("complaints") = complaints;
  PyErr_SetObject(error_type.ptr(), exception.ptr());
}

void translate_errors() {
  error_type = nb::object(nb::module_::import_("isolaw._error").attr("Error")).release();
  nb::register_exception_translator([](std::exception_ptr const& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (Error const& error) {
      raise_error(error);
    }
  });
}

void add_records(nb::module_& m) {
  nb::class_<Record>(
      m, "Record",
      "A test record or a displacement history, in kN, mm and s, as read_record, read_motion, record and motion\n"
      "return it.")
      .def_ro("name", &Record::name, "Name of the device.")
      .def_prop_ro(
          "file", [](Record const& r) { return r.raw.file; }, "The file that it was read from, or its name.")
      .def_prop_ro(
          "disp_mm", [](nb::handle_t<Record> self) { return view(nb::cast<Record&>(self).raw.disp_mm, self); },
          "Displacements in mm, shape (samples,): a read-only view.")
      .def_prop_ro(
          "force_kN",
          [](nb::handle_t<Record> self) { return view_or_none(nb::cast<Record&>(self).raw.force_kN, self); },
          "Forces in kN, shape (samples,): a read-only view; None for a motion.")
      .def_prop_ro(
          "time_s", [](nb::handle_t<Record> self) { return view_or_none(nb::cast<Record&>(self).raw.time_s, self); },
          "Times in s, shape (samples,): a read-only view; None without time.")
      .def_prop_ro(
          "load_kN", [](nb::handle_t<Record> self) { return view_or_none(nb::cast<Record&>(self).raw.load_kN, self); },
          "Vertical loads in kN, shape (samples,): a read-only view; None without.")
      .def_prop_ro(
          "recognised", [](Record const& r) { return wording::remarks(r.raw.recognised); },
          "A sentence for each decision of the reader, with its reason.")
      .def_prop_ro(
          "warnings", [](Record const& r) { return wording::remarks(r.raw.warnings); },
          "Sentences about doubtful things in the file.")
      .def(
          "__len__", [](Record const& r) { return r.raw.size(); }, "Number of samples.");

  m.def("read", &record_of_file, nb::arg("file"), nb::arg("motion"), nb::arg("name"), nb::arg("how"));

  m.def(
      "same_device",
      [](nb::list const& records, std::optional<std::string> const& name) {
        auto const tests = records_of(records);
        std::vector<data::NamedTest> named, uncorrected;
        for (auto const* test : tests) {
          if (test->raw.force_kN.empty())
            throw Error({.where = test->name, .found = "a motion without force", .allowed = "a record of a test"});
          named.push_back({.name = test->name, .record = test->raw});
          bool const is_known = test->uncorrected.size() > 0;
          if (is_known || !data::is_corrected(test->raw))
            uncorrected.push_back({.name = test->name, .record = is_known ? test->uncorrected : test->raw});
        }
        if (named.empty())
          throw Error({.where = "records", .found = "there are none", .allowed = "one record or more"});
        Record record{.name = {}, .raw = data::record_of_tests(std::move(named))};
        if (data::is_corrected(record.raw) && uncorrected.size() == tests.size())
          record.uncorrected = data::record_of_tests(std::move(uncorrected));
        record.name =
            name.value_or(tests.size() == 1 ? tests.front()->name : campaign::name_of_tests(record.raw.tests));
        return record;
      },
      nb::arg("records"), nb::arg("name"));

  m.def(
      "record",
      [](std::string const& name, nb::object const& disp_mm, nb::object const& force_kN, nb::object const& time_s,
         nb::object const& load_kN) {
        return Record{.name = name,
                      .raw = data::record_of_values(name, {.disp_mm = values_of(rows_of(disp_mm, "disp_mm"), "disp_mm"),
                                                           .force_kN = channel_of(force_kN, "force_kN"),
                                                           .time_s = channel_of(time_s, "time_s"),
                                                           .load_kN = channel_of(load_kN, "load_kN")})};
      },
      nb::arg("name"), nb::arg("disp_mm").none(), nb::arg("force_kN").none(), nb::arg("time_s").none(),
      nb::arg("load_kN").none());
}

void add_tables(nb::module_& m) {
  m.def("catalogue_json", &catalogue_json);
  m.def("options_json", [] {
    auto of_building = described(building::settings_table());
    of_building.update(described(building::stated_table()));
    return Json{{"settings", described(campaign::setting_table())},
                {"reading", described(data::reading_table())},
                {"acceptance", described(campaign::acceptance_table())},
                {"model", described(programs::model_table())},
                {"motion", described(building::stated_table())},
                {"test", described(campaign::test_table())},
                {"building", std::move(of_building)}}
        .dump();
  });
}

void add_laws(nb::module_& m) {
  m.def(
      "box",
      [](std::string const& law_id, Record const& record, nb::dict const& how) {
        auto const box = campaign::search_box(laws::find_law(law_id), data::clean(record.raw, {}), settings_of(how));
        nb::dict result;
        for (auto const& p : box.parameters) {
          nb::dict one;
          one["unit"] = p.unit;
          one["free"] = p.free;
          one["value"] = p.free ? nb::object(nb::none()) : nb::object(nb::float_(p.value));
          one["lower"] = p.lower;
          one["upper"] = p.upper;
          one["scale"] = p.scale == laws::Scale::linear ? "linear" : "logarithmic";
          result[std::string(p.name).c_str()] = one;
        }
        return result;
      },
      nb::arg("law"), nb::arg("record"), nb::arg("how"));

  m.def("force", &force_of, nb::arg("law"), nb::arg("parameters").none(), nb::arg("motion"), nb::arg("how"),
        nb::arg("refinement"), nb::arg("dead_band_mm"), nb::arg("out").none());

  nb::class_<Model>(m, "Model", "A law on a record; see isolaw.Model.")
      .def(
          "__init__",
          [](Model* model, std::string const& law, Record const& record, nb::dict const& how, int refinement) {
            new (model) Model(law, record, settings_of(how), refinement);
          },
          nb::arg("law"), nb::arg("record"), nb::arg("how"), nb::arg("refinement"))
      .def_prop_ro("disp_mm",
                   [](nb::handle_t<Model> self) { return view(nb::cast<Model&>(self).record().disp_mm, self); })
      .def_prop_ro("force_kN",
                   [](nb::handle_t<Model> self) { return view(nb::cast<Model&>(self).record().force_kN, self); })
      .def_prop_ro("time_s",
                   [](nb::handle_t<Model> self) { return view(nb::cast<Model&>(self).record().time_s, self); })
      .def("objective", &Model::objective, nb::arg("parameters").none())
      .def("objectives", &Model::objectives, nb::arg("population").none(), nb::arg("out").none())
      .def("residual", &Model::residual, nb::arg("parameters").none())
      .def("force", &Model::force, nb::arg("parameters").none(), nb::arg("out").none());
}

void add_campaigns(nb::module_& m) {
  nb::class_<Campaign>(m, "Campaign", "A campaign; see isolaw.Campaign.")
      .def(
          "_summary_json", [](Campaign const& c) { return render::summary_json(c.summary); },
          nb::call_guard<nb::gil_scoped_release>())
      .def(
          "_inspection_json", [](Campaign const& c) { return render::inspection_json(c.summary); },
          nb::call_guard<nb::gil_scoped_release>())
      .def_prop_ro("complete", [](Campaign const& c) { return c.contents.complete(); })
      .def("force",
           [](nb::handle_t<Campaign> self, std::string const& law, std::string const& device) {
             return view(nb::cast<Campaign&>(self).fit(law, device).force_kN, self);
           })
      .def("force_under", &force_under)
      .def("runs", &runs_of)
      .def("parameters",
           [](Campaign const& c, std::string const& law, std::string const& device) {
             auto const fitted = fitted_law(c.contents, law, device);
             nb::dict values;
             auto const& entry = laws::find_law(law);
             for (std::size_t i = 0; i < fitted.parameters.size(); ++i)
               values[std::string(entry.parameters[i].name).c_str()] = fitted.parameters[i];
             return values;
           })
      .def("refinement", [](Campaign const& c, std::string const& law,
                            std::string const& device) { return fitted_law(c.contents, law, device).refinement; })
      .def("record",
           [](Campaign const& c, std::string const& device) {
             auto const& one = c.contents.devices[c.device(device)];
             if (!one.usable()) throw Error({.where = "device '" + device + "'", .found = one.refusal});
             return Record{.name = one.name, .raw = one.raw, .uncorrected = one.uncorrected};
           })
      .def("fit_channel",
           [](nb::handle_t<Campaign> self, std::string const& device, std::string const& channel) {
             auto const& c = nb::cast<Campaign&>(self);
             auto const& record = c.contents.devices[c.device(device)].record;
             return view(channel == "disp_mm"    ? record.disp_mm
                         : channel == "force_kN" ? record.force_kN
                                                 : record.time_s,
                         self);
           })
      .def("write", [](Campaign const& c, std::filesystem::path const& directory) {
        nb::gil_scoped_release const released;
        render::write_outputs(c.summary, directory);
      });
  m.def("law_for_opensees", &law_for_opensees, nb::arg("law"), nb::arg("source"), nb::arg("device"), nb::arg("units"),
        nb::arg("in_plane"), nb::arg("anyway"), nb::arg("dead_band_mm"), nb::arg("refinement"));
}

void add_calibration(nb::module_& m) {
  m.def("load", &loaded, nb::arg("directory"));
  m.def(
      "calibrate",
      [](nb::list const& records, nb::dict const& given, nb::dict const& vertical, int jobs,
         std::optional<std::filesystem::path> out, bool fresh, std::string title,
         std::optional<std::pair<int, int>> part, nb::object const& progress) {
        require_jobs(jobs);
        CalibrateOptions options{.directory = std::move(out), .fresh = fresh, .title = std::move(title)};
        options.run.jobs = jobs;
        if (part) options.part = {.number = part->first, .total = part->second};
        return calibrated(records, given, vertical, std::move(options), progress);
      },
      nb::arg("records"), nb::arg("given"), nb::arg("vertical"), nb::arg("jobs"), nb::arg("out"), nb::arg("fresh"),
      nb::arg("title"), nb::arg("part"), nb::arg("progress").none());
  m.def(
      "merge",
      [](std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts, int jobs, bool fresh,
         nb::object const& progress) {
        require_jobs(jobs);
        MergeCallOptions options{.fresh = fresh};
        options.run.jobs = jobs;
        return merged(out, parts, std::move(options), progress);
      },
      nb::arg("out"), nb::arg("parts"), nb::arg("jobs"), nb::arg("fresh"), nb::arg("progress").none());
}

void add_buildings(nb::module_& m) {
  nb::class_<StudiedBuilding>(m, "Building", "A building that was studied; see isolaw.Building.")
      .def(
          "json", [](StudiedBuilding const& b) { return render::building_json(b.study, *b.answers); },
          nb::call_guard<nb::gil_scoped_release>())
      .def("quantity", &quantity_of, nb::arg("key"))
      .def("accelerations",
           [](nb::handle_t<StudiedBuilding> self) {
             auto const& l = nb::cast<StudiedBuilding const&>(self).layout;
             return measures(self, l.acceleration(0), l.floors + 1);
           })
      .def("drifts",
           [](nb::handle_t<StudiedBuilding> self) {
             auto const& l = nb::cast<StudiedBuilding const&>(self).layout;
             return measures(self, l.drift(0), l.floors);
           })
      .def("displacements",
           [](nb::handle_t<StudiedBuilding> self) {
             auto const& l = nb::cast<StudiedBuilding const&>(self).layout;
             return measures(self, l.displacement(0), l.bearings);
           })
      .def("history", &history_of, nb::arg("law"), nb::arg("motion"))
      .def("write", [](StudiedBuilding const& b, std::filesystem::path const& directory) {
        nb::gil_scoped_release const released;
        render::write_building_outputs(b.study, *b.answers, directory);
      });
  m.def(
      "building",
      [](nb::object const& file, nb::object const& from, nb::list const& motions, nb::dict const& given, int jobs,
         std::optional<std::filesystem::path> out, bool fresh, nb::object const& progress) {
        require_jobs(jobs);
        return studied(file, from, motions, given, {.jobs = jobs, .directory = std::move(out), .fresh = fresh},
                       progress);
      },
      nb::arg("file"), nb::arg("campaign"), nb::arg("motions"), nb::arg("given"), nb::arg("jobs"), nb::arg("out"),
      nb::arg("fresh"), nb::arg("progress").none());
}

study::ConditionsResult conditions_of(nb::object const& lot, std::filesystem::path const& folder, bool allow_outside) {
  auto const tables = nb::isinstance<nb::dict>(lot) ? json_of(lot) : Json();
  auto const file = tables.is_null() ? nb::cast<std::filesystem::path>(lot) : std::filesystem::path();
  nb::gil_scoped_release const released;
  auto const [observed, title, acceptance] =
      tables.is_null() ? conditions_source(file, allow_outside) : conditions_source(tables, folder, allow_outside);
  return study::build_conditions(observed, title, acceptance);
}

void add_conditions(nb::module_& m) {
  using study::ConditionsResult;
  nb::class_<ConditionsResult>(m, "Conditions", "A study of conditions; see isolaw.Conditions.")
      .def("json", &render::conditions_json, nb::call_guard<nb::gil_scoped_release>())
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
          nb::arg("devices"), nb::call_guard<nb::gil_scoped_release>());
  m.def("conditions", &conditions_of, nb::arg("lot"), nb::arg("folder"), nb::arg("allow_outside"));
}

// Runs a command of the program. `words` are as in argv: the first one is the name of the program. Returns the exit
// code.
int command(std::vector<nb::bytes> const& words) {
  std::vector<std::string> kept;
  for (auto const& word : words) kept.emplace_back(word.c_str(), word.size());
  std::vector<char*> pointers;
  for (auto& word : kept) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  nb::gil_scoped_release const released;
  return app::run(static_cast<int>(kept.size()), pointers.data());
}

}  // namespace
}  // namespace isolaw::python

NB_MODULE(_core, m) {
  m.doc() = "The compiled part of isolaw; import isolaw instead.";
  m.attr("__version__") = ISOLAW_VERSION;
  using namespace isolaw::python;
  // Without this call nanobind prints a warning at the end of the process about every object that still exists.
  nb::set_leak_warnings(false);
  translate_errors();
  // The order matters: a class is added before functions that take or return it, because nanobind writes the name of
  // the class into their docstrings.
  add_records(m);
  add_tables(m);
  add_laws(m);
  add_campaigns(m);
  add_calibration(m);
  add_buildings(m);
  add_conditions(m);
  add_states(m);
  add_commands(m);
  m.def("command", &command, nb::arg("words"));
}
