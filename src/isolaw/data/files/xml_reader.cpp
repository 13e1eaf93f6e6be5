#include "isolaw/data/files/xml_reader.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <new>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::data {
namespace {

std::string_view without_prefix(std::string_view name) {
  auto const colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

class ExpatReader {
 public:
  ExpatReader(std::string const& place, XmlHandlers const& handlers)
      : place_(place), handlers_(handlers), parser_(XML_ParserCreate(nullptr)) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_, this);
    XML_SetElementHandler(parser_, &ExpatReader::on_start, &ExpatReader::on_end);
    XML_SetCharacterDataHandler(parser_, &ExpatReader::on_text);
    XML_SetStartDoctypeDeclHandler(parser_, &ExpatReader::on_doctype);
  }
  ExpatReader(ExpatReader const&) = delete;
  ExpatReader& operator=(ExpatReader const&) = delete;
  ~ExpatReader() { XML_ParserFree(parser_); }

  void parse(std::string_view piece, bool last) {
    constexpr std::int64_t longest_tag = 1 << 20;
    fed_ += static_cast<std::int64_t>(piece.size());
    auto const status = XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), last ? XML_TRUE : XML_FALSE);
    if (thrown_) std::rethrow_exception(thrown_);
    auto const refuse = [&](std::string found) {
      throw Error(Complaint{.where = place_,
                            .found = std::move(found),
                            .allowed = "a workbook as Excel writes it",
                            .advice = "save it again as .xlsx"});
    };
    if (!refusal_.empty()) refuse(refusal_);
    if (status == XML_STATUS_ERROR)
      refuse(fmt::format("is no XML: {} in line {}", XML_ErrorString(XML_GetErrorCode(parser_)),
                         XML_GetCurrentLineNumber(parser_)));
    // Refuses a very long tag: expat keeps an unfinished tag and reads it again with every piece, which would take
    // memory and time.
    if (!last && fed_ - XML_GetCurrentByteIndex(parser_) > longest_tag) refuse("a tag longer than 1 MiB");
  }

 private:
  template <class Handler, class... Given>
  void run(Handler const& handler, Given const&... given) {
    if (!handler || thrown_ || !refusal_.empty()) return;
    try {
      handler(given...);
    } catch (...) {
      thrown_ = std::current_exception();
      XML_StopParser(parser_, XML_FALSE);
    }
  }
  void stop(std::string why) {
    if (refusal_.empty()) refusal_ = std::move(why);
    XML_StopParser(parser_, XML_FALSE);
  }

  static ExpatReader& of(void* user) { return *static_cast<ExpatReader*>(user); }
  static void on_start(void* user, char const* name, char const** attributes) {
    constexpr int deepest = 64;
    auto& reader = of(user);
    if (++reader.depth_ > deepest) return reader.stop(fmt::format("elements nested more than {} deep", deepest));
    reader.run(reader.handlers_.start, without_prefix(name), Attributes(attributes));
  }
  static void on_end(void* user, char const* name) {
    auto& reader = of(user);
    --reader.depth_;
    reader.run(reader.handlers_.end, without_prefix(name));
  }
  static void on_text(void* user, char const* text, int size) {
    of(user).run(of(user).handlers_.text, std::string_view(text, static_cast<std::size_t>(size)));
  }
  static void on_doctype(void* user, char const*, char const*, char const*, int) {
    of(user).stop("declares a document type, through which entities grow without bound");
  }

  std::string const& place_;
  XmlHandlers const& handlers_;
  XML_Parser parser_;
  int depth_ = 0;
  std::int64_t fed_ = 0;
  std::string refusal_;        // why the parser was stopped
  std::exception_ptr thrown_;  // exception of a handler, which must not pass through expat
};

}  // namespace

std::string_view Attributes::operator[](std::string_view name) const {
  for (auto const* pair = list_; *pair != nullptr; pair += 2)
    if (without_prefix(pair[0]) == name) return pair[1];
  return {};
}

void read_xml(std::string const& place, XmlHandlers const& handlers,
              std::function<void(std::function<void(std::string_view)> const&)> const& source) {
  ExpatReader reader(place, handlers);
  source([&](std::string_view piece) { reader.parse(piece, false); });
  reader.parse({}, true);
}

}  // namespace isolaw::data
