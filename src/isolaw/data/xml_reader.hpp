// Reads XML with expat and keeps nothing. Refuses document types, which could declare entities, and excessive nesting.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// The value of an attribute, by its name without a prefix.
class Attributes {
 public:
  explicit Attributes(char const** list) : list_(list) {}
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

// `source` passes the document on piece by piece; `place` is its name in messages. Throws Error, or what a handler
// throws.
void read_xml(std::string const& place, XmlHandlers const& handlers,
              std::function<void(std::function<void(std::string_view piece)> const& take)> const& source);

}  // namespace isolaw::data
