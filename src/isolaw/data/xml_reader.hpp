// Reads XML element by element with expat and keeps nothing itself. A document type, which could declare entities, is
// refused, as are tags and nesting beyond those of any workbook.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// Attributes of an element, by name without a prefix.
class Attributes {
 public:
  explicit Attributes(char const** list) : list_(list) {}
  // Empty when it is not there.
  std::string_view operator[](std::string_view name) const;

 private:
  char const** list_;
};

// Element names come without their prefix. Empty handlers are not called.
struct XmlHandlers {
  std::function<void(std::string_view name, Attributes const& attributes)> start;
  std::function<void(std::string_view name)> end = {};
  std::function<void(std::string_view text)> text = {};
};

// Reads the document that `source` passes on piece by piece; `place` is its name in messages. Throws Error when it is
// no XML, or what a handler throws.
void read_xml(std::string const& place, XmlHandlers const& handlers,
              std::function<void(std::function<void(std::string_view piece)> const& take)> const& source);

}  // namespace isolaw::data
