// Reads XML with expat and passes its parts to handlers, without keeping the document in memory. Refuses document
// types, which could declare entities, and deep nesting.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// The attributes of an element. [] returns the value of the attribute with this name, without prefix, or an empty text.
class Attributes {
 public:
  explicit Attributes(char const** list) : list_(list) {}
  std::string_view operator[](std::string_view name) const;

 private:
  char const** list_;
};

// Functions that read_xml() calls for the parts of a document. The names of elements come without their prefix. A
// function that is empty is not called.
struct XmlHandlers {
  std::function<void(std::string_view name, Attributes const& attributes)> start;
  std::function<void(std::string_view name)> end = {};
  std::function<void(std::string_view text)> text = {};
};

// `source` passes the document to `take` piece by piece. Messages call the document `place`. Throws Error, or a
// handler's exception.
void read_xml(std::string const& place, XmlHandlers const& handlers,
              std::function<void(std::function<void(std::string_view piece)> const& take)> const& source);

}  // namespace isolaw::data
