#include "isolaw/data/xml_reader.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::data {
namespace {

std::string_view without_prefix(std::string_view name) {
  auto const colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

}  // namespace

struct XmlReader::State {
  std::string place;
  XmlHandlers handlers;
  XML_Parser parser = nullptr;
  int depth = 0;
  std::int64_t fed = 0;
  std::string refusal;        // why the parser was stopped
  std::exception_ptr thrown;  // by a handler: must not pass through expat

  // Runs a handler.
  template <class Action>
  void guarded(Action&& action) {
    if (thrown || !refusal.empty()) return;
    try {
      action();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
  void stop(std::string why) {
    if (refusal.empty()) refusal = std::move(why);
    XML_StopParser(parser, XML_FALSE);
  }

  static State& of(void* user) { return *static_cast<State*>(user); }
  static void on_start(void* user, char const* name, char const** attributes) {
    constexpr int deepest = 64;
    auto& state = of(user);
    if (++state.depth > deepest) return state.stop(fmt::format("elements nested more than {} deep", deepest));
    state.guarded([&] { state.handlers.start(without_prefix(name), Attributes(attributes)); });
  }
  static void on_end(void* user, char const* name) {
    auto& state = of(user);
    --state.depth;
    state.guarded([&] { state.handlers.end(without_prefix(name)); });
  }
  static void on_text(void* user, char const* text, int size) {
    auto& state = of(user);
    state.guarded([&] { state.handlers.text({text, static_cast<std::size_t>(size)}); });
  }
  static void on_doctype(void* user, char const*, char const*, char const*, int) {
    of(user).stop("declares a document type, through which entities grow without bound");
  }
};

std::string_view Attributes::operator[](std::string_view name) const {
  for (auto const* pair = list_; *pair != nullptr; pair += 2)
    if (without_prefix(pair[0]) == name) return pair[1];
  return {};
}

XmlReader::XmlReader(std::string place, XmlHandlers handlers) {
  auto state = std::make_unique<State>();
  state->place = std::move(place);
  state->handlers = std::move(handlers);
  state->parser = XML_ParserCreate(nullptr);
  if (state->parser == nullptr) throw std::bad_alloc();
  XML_SetUserData(state->parser, state.get());
  XML_SetElementHandler(state->parser, &State::on_start, &State::on_end);
  XML_SetCharacterDataHandler(state->parser, &State::on_text);
  XML_SetStartDoctypeDeclHandler(state->parser, &State::on_doctype);
  state_ = state.release();
}

XmlReader::~XmlReader() {
  XML_ParserFree(state_->parser);
  delete state_;
}

void XmlReader::take(std::string_view piece) {
  parse(piece, false);
}

void XmlReader::finish() {
  parse({}, true);
}

void XmlReader::parse(std::string_view piece, bool last) {
  constexpr std::int64_t longest_tag = 1 << 20;
  auto& s = *state_;
  s.fed += static_cast<std::int64_t>(piece.size());
  auto const status = XML_Parse(s.parser, piece.data(), static_cast<int>(piece.size()), last ? XML_TRUE : XML_FALSE);
  if (s.thrown) std::rethrow_exception(s.thrown);
  auto const refuse = [&](std::string found) {
    throw Error(Complaint{.where = s.place,
                          .found = std::move(found),
                          .allowed = "a workbook as Excel writes it",
                          .advice = "save it again as .xlsx"});
  };
  if (!s.refusal.empty()) refuse(s.refusal);
  if (status == XML_STATUS_ERROR)
    refuse(fmt::format("is no XML: {} in line {}", XML_ErrorString(XML_GetErrorCode(s.parser)),
                       XML_GetCurrentLineNumber(s.parser)));
  // expat keeps a tag until it is closed, and looks at it again with every piece.
  if (!last && s.fed - XML_GetCurrentByteIndex(s.parser) > longest_tag) refuse("a tag longer than 1 MiB");
}

}  // namespace isolaw::data
