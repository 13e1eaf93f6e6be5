#include "isolaw/programs/header_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include "isolaw/base/embedded.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::programs {

std::span<Embedded const> header_files();

namespace {

std::string_view file(std::string_view name) {
  return embedded_text(header_files(), name);
}
bool exists(std::string_view name) {
  return std::ranges::find(header_files(), name, &Embedded::name) != header_files().end();
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    auto const end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string_view without_indent(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

bool of_a_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string const* written_for(std::string_view name) {
  static std::map<std::string, std::string, std::less<>> const names{
      {"T", "double"},          {"X", "Dual"},      {"N", "Dual"}, {"NumberOf", "Dual"},
      {"Params", "Parameters"}, {"StepOf", "Step"}, {"num", ""},   {"rounded", ""}};
  auto const found = names.find(name);
  return found == names.end() ? nullptr : &found->second;
}
bool is_a_number(std::string_view name) {
  return name == "T" || name == "X" || name == "N" || name == "Dual";
}

// Returns the head of a template without the template parameters for which an export writes fixed types. Empty if no
// template parameter is left.
std::string template_head(std::string_view line) {
  auto const head = without_indent(line);
  auto arguments = head.substr(10, head.size() - 11);
  std::string kept;
  while (!arguments.empty()) {
    auto const argument = arguments.substr(0, arguments.find(", "));
    arguments.remove_prefix(std::min(argument.size() + 2, arguments.size()));
    auto const name = argument.substr(argument.find(' ') + 1);
    if (!is_a_number(name) && name != "Params") kept += (kept.empty() ? "" : ", ") + std::string(argument);
  }
  return kept.empty() ? "" : fmt::format("{:{}}template <{}>\n", "", line.size() - head.size(), kept);
}
bool is_template_head(std::string_view line) {
  line = without_indent(line);
  return line.starts_with("template <") && line.ends_with('>');
}

// True for a literal or a name such as p.alpha, with or without a minus sign. Where the code of a law casts such a
// value to a number type, the export leaves out the cast.
bool is_simple(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && std::ranges::all_of(text, [](char c) { return of_a_name(c) || c == '.' || c == ':'; });
}

std::size_t closing_angle(std::string_view code) {
  int open = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    open += code[i] == '<' ? 1 : code[i] == '>' ? -1 : 0;
    if (open == 0) return i;
  }
  return code.size();
}

// Rewrites one line of a law for an exported file. There the number types T, X and N of laws/law.hpp are no template
// parameters: T becomes double, X and N become Dual (see written_for). In template arguments these types are left out,
// so that State<N> becomes State.
std::string with_plain_numbers(std::string_view code) {
  std::string text;
  while (!code.empty()) {
    if (code.starts_with("//")) return text.append(code);
    if (!of_a_name(code.front())) {
      text += code.front();
      code.remove_prefix(1);
      continue;
    }
    auto const length =
        std::min(static_cast<std::size_t>(std::ranges::find_if_not(code, of_a_name) - code.begin()), code.size());
    auto const name = code.substr(0, length);
    code.remove_prefix(length);
    bool const in_std = text.ends_with("std::");
    auto const* const replaced = written_for(name);
    if (is_a_number(name) && code.starts_with('(')) {  // a cast to a number
      auto const inside = code.substr(1, std::min(code.find(')'), code.size()) - 1);
      if (is_simple(inside)) {
        text += with_plain_numbers(inside);
        code.remove_prefix(inside.size() + 2);
        continue;
      }
    }
    if (name == "num" && code.starts_with("::"))
      code.remove_prefix(2);
    else
      text += replaced ? *replaced : std::string(name);
    if (!in_std && code.starts_with('<')) {  // template arguments
      auto arguments = code.substr(1, closing_angle(code) - 1);
      auto const whole = arguments.size() + 2;
      std::string kept;
      bool dropped = false;
      while (!arguments.empty()) {
        auto const argument = arguments.substr(0, arguments.find(", "));
        if (is_a_number(argument))
          dropped = true;
        else
          kept += (kept.empty() ? "" : ", ") + with_plain_numbers(argument);
        arguments.remove_prefix(std::min(argument.size() + 2, arguments.size()));
      }
      if (dropped) {
        if (!kept.empty()) text += "<" + kept + ">";
        code.remove_prefix(whole);
      }
    }
  }
  return text;
}

// Returns the lines of a file between `// [export]` and `// [end]`, as C++ with fixed number types.
std::string exported(std::string_view text) {
  constexpr std::string_view begin = "// [export", end = "// [end]";
  std::string code;
  bool inside = false;
  std::string closing;
  std::size_t indent = 0;
  for (auto const line : lines_of(text)) {
    auto const mark = without_indent(line);
    if (mark.starts_with(begin)) {
      auto const opening = without_indent(mark.substr(begin.size(), mark.find(']') - begin.size()));
      inside = true;
      indent = opening.empty() ? line.size() - mark.size() : 0;
      closing = opening.empty() ? "" : opening.starts_with("namespace") ? "}\n" : "};\n";
      if (!opening.empty()) code += std::string(opening) + " {\n";
    } else if (mark == end) {
      inside = false;
      code += closing;
    } else if (inside && mark.starts_with("using N = ")) {
      continue;
    } else if (inside && is_template_head(line)) {
      code += template_head(line.substr(std::min(indent, line.size())));
    } else if (inside) {
      code += with_plain_numbers(line.substr(std::min(indent, line.size()))) + "\n";
    }
  }
  return code;
}

void add_file(std::vector<std::string>& parts, std::string_view name) {
  constexpr std::string_view include = "#include \"isolaw/laws/";
  auto const text = file(name);
  for (auto const line : lines_of(text))
    if (line.starts_with(include)) {
      auto const other = line.substr(include.size(), line.rfind('"') - include.size());
      if (exists(other)) add_file(parts, other);
    }
  auto const code = exported(text);
  if (!code.empty() && std::ranges::find(parts, code) == parts.end()) parts.push_back(code);
}

std::string with_blank_lines(std::vector<std::string> const& parts) {
  std::string text;
  for (auto const& part : parts) text += part + "\n";
  return text;
}

// A block of lines of the exported code, with the comment above it. `name` is the name of an inline function, or "abs"
// for a declaration such as `using std::abs`. Any other block has no name.
struct Block {
  std::string name, text;
};

std::string name_of(std::string_view line) {
  if (line.starts_with("using std::")) return std::string(line.substr(11, line.size() - 12));
  auto const end = std::min(line.find('('), line.size());
  auto begin = end;
  while (begin > 0 && of_a_name(line[begin - 1])) --begin;
  return std::string(line.substr(begin, end - begin));
}

std::vector<Block> blocks_of(std::string_view text) {
  std::vector<Block> blocks(1);
  bool open = false;
  for (auto const line : lines_of(text)) {
    auto& block = blocks.back();
    block.text += std::string(line) + "\n";
    bool const function =
        line.starts_with("inline ") && line.find('(') != line.npos && line.find("operator") == line.npos;
    if (function || line.starts_with("using std::")) block.name = name_of(line);
    bool const comment_or_head = line.starts_with("//") || is_template_head(line);
    open = (open || line.ends_with('{')) && line != "}" && line != "};";
    if (!open && !comment_or_head) blocks.emplace_back();
  }
  return blocks;
}

bool calls(std::string_view text, std::string_view name) {
  for (auto at = text.find(name); at != text.npos; at = text.find(name, at + 1))
    if ((at == 0 || !of_a_name(text[at - 1])) && at + name.size() < text.size() && text[at + name.size()] == '(')
      return true;
  return false;
}

// Removes functions and using declarations that no other block calls. Repeats this until other blocks call all that are
// left.
std::string without_unused(std::string_view text) {
  auto blocks = blocks_of(text);
  auto const unused = [&](Block const& block) {
    return !block.name.empty() && std::ranges::none_of(blocks, [&](Block const& other) {
      return other.name != block.name && calls(other.text, block.name);
    });
  };
  for (auto found = std::ranges::find_if(blocks, unused); found != blocks.end();
       found = std::ranges::find_if(blocks, unused))
    blocks.erase(found);
  std::string kept;
  for (auto const& block : blocks) kept += block.text;
  return kept;
}

}  // namespace

std::string law_in_cpp(std::string_view id) {
  auto name = std::string(id);
  std::ranges::replace(name, '-', '_');
  if (!exists(name + ".hpp")) return {};
  std::vector<std::string> parts{std::string(file("online/doubles.inc"))};
  parts.push_back(exported(file("online/numbers.hpp")));
  add_file(parts, name + ".hpp");
  auto const& code = parts.back();
  constexpr std::string_view mark = "// [export struct ";
  auto type = file(name + ".hpp");
  type.remove_prefix(type.rfind(mark) + mark.size());
  type = type.substr(0, type.find_first_of(" :]"));
  bool const constants = code.find(" constants(Parameters") != code.npos, starts = code.find(" start(") != code.npos;
  bool const remembers = laws::find_law(id).info.traits.remembers;
  std::string names = fmt::format(
      "using Law = {};\n"
      "using LawConstants = {};\n"
      "inline LawConstants law_constants(Parameters const&{}) {{ return {}; }}\n",
      type, constants ? "Law::Constants" : "NoConstants", constants ? " p" : "",
      constants ? "Law::constants(p)" : "{}");
  std::string const first =
      starts ? fmt::format(
                   "inline LawState first_state(Parameters const& p, LawConstants const& c) {{\n"
                   "  LawState state;\n"
                   "  Law::start(p, c, {}, Step());\n"
                   "  return state;\n"
                   "}}\n",
                   remembers ? "state.law" : "state")
             : "inline LawState first_state(Parameters const&, LawConstants const&) { return {}; }\n";
  if (!constants) parts.insert(parts.begin() + 2, "struct NoConstants {};\n");
  if (remembers) {
    parts.push_back(names + "using OwnState = Law::State;\nusing Memory = Law::Memory;\n");
    parts.push_back(exported(file("memory/followed.hpp")));
    parts.push_back(exported(file("online/remembering.hpp")));
    parts.push_back(first);
  } else {
    parts.push_back(
        names +
        "using LawState = Law::State;\n"
        "inline Dual law_force(Parameters const& p, LawConstants const& c, LawState& state, Step const& step) {\n"
        "  return Law::step(p, c, state, step);\n"
        "}\n" +
        first);
  }
  parts.push_back(exported(file("online/motion.hpp")));
  parts.emplace_back(file("online/material.inc"));
  return without_unused(with_blank_lines(parts));
}

bool remembers_turning_points(std::string_view law) {
  return law_in_cpp(law).find("struct OpenBranches") != std::string::npos;
}

}  // namespace isolaw::programs
