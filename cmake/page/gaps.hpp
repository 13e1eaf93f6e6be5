// Defines parts of C++20 that the program uses and that libc++ 13 of emscripten lacks. The compiler option -include
// puts this file before every source of the page. The range algorithms in this file call the standard algorithms for
// iterators. Most of its views compute all elements at once instead of one by one; no code of the program depends on
// the difference. With libc++ 16 everything but std::from_chars can go, and with libc++ 20 (emscripten 4) the whole
// file.
#pragma once

#ifdef __cplusplus

#include <algorithm>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

_LIBCPP_BEGIN_NAMESPACE_STD

// Defines std::bit_cast, which belongs to <bit>.
template <class To, class From>
constexpr To bit_cast(From const& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// Defines std::from_chars for floating-point numbers. A short decimal number is one exact product or quotient
// (Clinger's fast path). For other numbers it calls strtod, which rounds correctly in musl, emscripten's C library.
inline from_chars_result from_chars(char const* first, char const* last, double& value,
                                    chars_format format = chars_format::general) {
  auto at = first;
  bool const negative = at != last && *at == '-';
  if (negative) ++at;
  auto const word = [&](string_view name) {
    auto const* next = at;
    for (char const c : name)
      if (next == last || (*next++ | 0x20) != c) return false;
    at = next;
    return true;
  };
  if (word("inf")) {
    word("inity");
    value = negative ? -__builtin_inf() : __builtin_inf();
    return {at, errc()};
  }
  if (word("nan")) {
    value = negative ? -__builtin_nan("") : __builtin_nan("");
    return {at, errc()};
  }
  uint64_t digits = 0;
  int count = 0, exponent = 0;
  bool any = false, point = false, exact = true;
  auto const* const number = at;
  for (; at != last; ++at) {
    if (*at == '.' && !point) {
      point = true;
      continue;
    }
    if (*at < '0' || *at > '9') break;
    any = true;
    if (count < 18) {
      digits = 10 * digits + static_cast<uint64_t>(*at - '0');
      if (digits != 0) ++count;
    } else {
      exact = false;
      if (!point) ++exponent;
      continue;
    }
    if (point) --exponent;
  }
  if (!any) return {first, errc::invalid_argument};
  if (format != chars_format::fixed && at != last && (*at == 'e' || *at == 'E')) {
    auto const* next = at + 1;
    bool const down = next != last && *next == '-';
    if (next != last && (*next == '-' || *next == '+')) ++next;
    int power = 0;
    bool given = false;
    for (; next != last && *next >= '0' && *next <= '9'; ++next) {
      given = true;
      if (power < 100'000) power = 10 * power + (*next - '0');
    }
    if (given) {
      at = next;
      exponent += down ? -power : power;
    }
  }
  double found = 0.0;
  if (exact && digits < (uint64_t{1} << 53) && exponent >= -22 && exponent <= 22) {
    static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    found = static_cast<double>(digits);
    found = exponent < 0 ? found / powers[-exponent] : found * powers[exponent];
  } else {
    string const text(number, at);
    found = strtod(text.c_str(), nullptr);
    if (found == __builtin_inf() || (found == 0.0 && digits != 0)) return {at, errc::result_out_of_range};
  }
  value = negative ? -found : found;
  return {at, errc()};
}

// Writes the shortest text that reads back as the same number, in fixed or scientific notation. fmt finds the digits.
inline to_chars_result to_chars(char* first, char* last, double value) {
  auto text = fmt::format("{}", value);
  if (value == 0.0) text = signbit(value) ? "-0" : "0";
  if (value != 0.0 && value - value == 0.0) {
    string const sign = value < 0.0 ? "-" : "";
    string digits;
    int point = -1, power = 0;
    for (size_t i = sign.size(); i < text.size(); ++i) {
      if (text[i] == 'e') {
        power = atoi(text.c_str() + i + 1);
        break;
      }
      if (text[i] == '.')
        point = static_cast<int>(digits.size());
      else
        digits += text[i];
    }
    auto const lead = digits.find_first_not_of('0');
    power += (point < 0 ? static_cast<int>(digits.size()) : point) - 1 - static_cast<int>(lead);
    digits.erase(0, lead);
    while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
    auto const scientific = sign + digits.substr(0, 1) + (digits.size() > 1 ? "." + digits.substr(1) : "") +
                            fmt::format("e{}{:02}", power < 0 ? '-' : '+', power < 0 ? -power : power);
    auto const whole = static_cast<size_t>(power + 1);
    if (power + 1 >= static_cast<int>(digits.size()))
      text = fmt::format("{:.0f}", value);
    else if (power >= 0)
      text = sign + digits.substr(0, whole) + "." + digits.substr(whole);
    else
      text = sign + "0." + string(static_cast<size_t>(-power - 1), '0') + digits;
    if (scientific.size() < text.size()) text = scientific;
  }
  if (static_cast<size_t>(last - first) < text.size()) return {last, errc::value_too_large};
  return {std::copy(text.begin(), text.end(), first), errc()};
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
  char const* const as = format == chars_format::fixed ? "%.*f" : format == chars_format::scientific ? "%.*e" : "%.*g";
  auto const count = snprintf(nullptr, 0, as, precision, value);
  if (last - first < count) return {last, errc::value_too_large};
  string text(static_cast<size_t>(count) + 1, '\0');
  snprintf(text.data(), text.size(), as, precision, value);
  return {std::copy_n(text.data(), count, first), errc()};
}

namespace ranges {

template <class In, class Out>
struct in_out_result {
  In in;
  Out out;
};
template <class T>
struct min_max_result {
  T min, max;
};

inline namespace page_objects {

// The standard makes range algorithms function objects, so that argument-dependent lookup does not find them. The
// macros below therefore define function objects too.
#define ISOLAW_RANGES_TEST(name)                                           \
  inline constexpr struct name##_of {                                      \
    template <input_range R, class F, class P = identity>                  \
    constexpr auto operator()(R&& r, F f, P p = {}) const {                \
      return std::name(ranges::begin(r), ranges::end(r), [&](auto&& v) -> bool { return invoke(f, invoke(p, v)); }); \
    }                                                                      \
    template <input_iterator I, class F, class P = identity>               \
    constexpr auto operator()(I a, I b, F f, P p = {}) const {             \
      return std::name(a, b, [&](auto&& v) -> bool { return invoke(f, invoke(p, v)); }); \
    }                                                                      \
  } name{};
ISOLAW_RANGES_TEST(any_of)
ISOLAW_RANGES_TEST(all_of)
ISOLAW_RANGES_TEST(none_of)
ISOLAW_RANGES_TEST(count_if)
ISOLAW_RANGES_TEST(find_if)
ISOLAW_RANGES_TEST(find_if_not)
#undef ISOLAW_RANGES_TEST

// Defines a range algorithm that orders elements by comparing their projections, for example ranges::sort.
#define ISOLAW_RANGES_ORDER(name)                                          \
  inline constexpr struct name##_of {                                      \
    template <forward_range R, class C = less, class P = identity>         \
    constexpr auto operator()(R&& r, C c = {}, P p = {}) const {           \
      return std::name(ranges::begin(r), ranges::end(r),                   \
                       [&](auto&& a, auto&& b) -> bool { return invoke(c, invoke(p, a), invoke(p, b)); }); \
    }                                                                      \
    template <forward_iterator I, class C = less, class P = identity>      \
    constexpr auto operator()(I first, I last, C c = {}, P p = {}) const { \
      return std::name(first, last,                                        \
                       [&](auto&& a, auto&& b) -> bool { return invoke(c, invoke(p, a), invoke(p, b)); }); \
    }                                                                      \
  } name{};
ISOLAW_RANGES_ORDER(sort)
ISOLAW_RANGES_ORDER(stable_sort)
ISOLAW_RANGES_ORDER(min_element)
ISOLAW_RANGES_ORDER(max_element)
ISOLAW_RANGES_ORDER(minmax_element)
ISOLAW_RANGES_ORDER(is_sorted)
#undef ISOLAW_RANGES_ORDER

inline constexpr struct find_of {
  template <input_range R, class T, class P = identity>
  constexpr auto operator()(R&& r, T const& value, P p = {}) const {
    return std::find_if(ranges::begin(r), ranges::end(r), [&](auto&& v) -> bool { return invoke(p, v) == value; });
  }
  template <input_iterator I, class T, class P = identity>
  constexpr auto operator()(I first, I last, T const& value, P p = {}) const {
    return std::find_if(first, last, [&](auto&& v) -> bool { return invoke(p, v) == value; });
  }
} find{};
inline constexpr struct count_of {
  template <input_range R, class T, class P = identity>
  constexpr auto operator()(R&& r, T const& value, P p = {}) const {
    return std::count_if(ranges::begin(r), ranges::end(r), [&](auto&& v) -> bool { return invoke(p, v) == value; });
  }
} count{};
inline constexpr struct adjacent_find_of {
  template <forward_range R, class C = equal_to, class P = identity>
  constexpr auto operator()(R&& r, C c = {}, P p = {}) const {
    return std::adjacent_find(ranges::begin(r), ranges::end(r),
                              [&](auto&& a, auto&& b) -> bool { return invoke(c, invoke(p, a), invoke(p, b)); });
  }
} adjacent_find{};
inline constexpr struct equal_of {
  template <input_range R, input_range S, class C = equal_to, class P = identity, class Q = identity>
  constexpr bool operator()(R&& r, S&& s, C c = {}, P p = {}, Q q = {}) const {
    auto a = ranges::begin(r);
    auto b = ranges::begin(s);
    for (; a != ranges::end(r) && b != ranges::end(s); ++a, ++b)
      if (!invoke(c, invoke(p, *a), invoke(q, *b))) return false;
    return a == ranges::end(r) && b == ranges::end(s);
  }
} equal{};
inline constexpr struct for_each_of {
  template <input_range R, class F, class P = identity>
  constexpr void operator()(R&& r, F f, P p = {}) const {
    for (auto&& v : r) invoke(f, invoke(p, std::forward<decltype(v)>(v)));
  }
} for_each{};
inline constexpr struct copy_of {
  template <input_range R, class O>
  constexpr auto operator()(R&& r, O out) const {
    auto const made = std::copy(ranges::begin(r), ranges::end(r), out);
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r), made};
  }
} copy{};
inline constexpr struct copy_if_of {
  template <input_range R, class O, class F, class P = identity>
  constexpr void operator()(R&& r, O out, F f, P p = {}) const {
    std::copy_if(ranges::begin(r), ranges::end(r), out, [&](auto&& v) -> bool { return invoke(f, invoke(p, v)); });
  }
} copy_if{};
inline constexpr struct move_of {
  template <input_range R, class O>
  constexpr auto operator()(R&& r, O out) const {
    auto const made = std::move(ranges::begin(r), ranges::end(r), out);
    return in_out_result<decltype(ranges::end(r)), O>{ranges::end(r), made};
  }
} move{};
inline constexpr struct replace_of {
  template <forward_range R, class T>
  constexpr void operator()(R&& r, T const& from, T const& to) const {
    std::replace(ranges::begin(r), ranges::end(r), from, to);
  }
} replace{};
inline constexpr struct fill_of {
  template <forward_range R, class T>
  constexpr void operator()(R&& r, T const& value) const {
    std::fill(ranges::begin(r), ranges::end(r), value);
  }
} fill{};
inline constexpr struct reverse_of {
  template <bidirectional_range R>
  constexpr void operator()(R&& r) const {
    std::reverse(ranges::begin(r), ranges::end(r));
  }
} reverse{};
inline constexpr struct swap_ranges_of {
  template <forward_range R, forward_range S>
  constexpr void operator()(R&& r, S&& s) const {
    auto b = ranges::begin(s);
    for (auto a = ranges::begin(r); a != ranges::end(r) && b != ranges::end(s); ++a, ++b) std::iter_swap(a, b);
  }
} swap_ranges{};
inline constexpr struct unique_of {
  template <forward_range R>
  constexpr auto operator()(R&& r) const {
    return subrange(std::unique(ranges::begin(r), ranges::end(r)), ranges::end(r));
  }
} unique{};
inline constexpr struct stable_partition_of {
  template <bidirectional_range R, class F>
  constexpr auto operator()(R&& r, F f) const {
    auto const at = std::stable_partition(ranges::begin(r), ranges::end(r), [&](auto&& v) -> bool { return invoke(f, v); });
    return subrange(at, ranges::end(r));
  }
} stable_partition{};
inline constexpr struct nth_element_of {
  template <random_access_range R, class C = less, class P = identity>
  constexpr void operator()(R&& r, iterator_t<R> at, C c = {}, P p = {}) const {
    std::nth_element(ranges::begin(r), at, ranges::end(r),
                     [&](auto&& a, auto&& b) -> bool { return invoke(c, invoke(p, a), invoke(p, b)); });
  }
} nth_element{};
inline constexpr struct lower_bound_of {
  template <forward_range R, class T, class C = less, class P = identity>
  constexpr auto operator()(R&& r, T const& value, C c = {}, P p = {}) const {
    return std::partition_point(ranges::begin(r), ranges::end(r),
                                [&](auto&& v) -> bool { return invoke(c, invoke(p, v), value); });
  }
} lower_bound{};
inline constexpr struct upper_bound_of {
  template <forward_range R, class T, class C = less, class P = identity>
  constexpr auto operator()(R&& r, T const& value, C c = {}, P p = {}) const {
    return std::partition_point(ranges::begin(r), ranges::end(r),
                                [&](auto&& v) -> bool { return !invoke(c, value, invoke(p, v)); });
  }
} upper_bound{};
inline constexpr struct equal_range_of {
  template <forward_range R, class T, class C = less, class P = identity>
  constexpr auto operator()(R&& r, T const& value, C c = {}, P p = {}) const {
    return std::pair(ranges::lower_bound(r, value, c, p), ranges::upper_bound(r, value, c, p));
  }
} equal_range{};
inline constexpr struct set_symmetric_difference_of {
  template <input_range R, input_range S, class O>
  constexpr void operator()(R&& r, S&& s, O out) const {
    std::set_symmetric_difference(ranges::begin(r), ranges::end(r), ranges::begin(s), ranges::end(s), out);
  }
} set_symmetric_difference{};

#define ISOLAW_RANGES_EXTREME(name, element)                               \
  inline constexpr struct name##_of {                                      \
    template <input_range R, class C = less, class P = identity>           \
    constexpr range_value_t<R> operator()(R&& r, C c = {}, P p = {}) const { \
      return *ranges::element(r, c, p);                                     \
    }                                                                      \
    template <class T, class C = less, class P = identity>                 \
    constexpr T operator()(initializer_list<T> r, C c = {}, P p = {}) const { \
      return *ranges::element(r, c, p);                                     \
    }                                                                      \
  } name{};
ISOLAW_RANGES_EXTREME(min, min_element)
ISOLAW_RANGES_EXTREME(max, max_element)
#undef ISOLAW_RANGES_EXTREME
inline constexpr struct minmax_of {
  template <input_range R, class C = less, class P = identity>
  constexpr min_max_result<range_value_t<R>> operator()(R&& r, C c = {}, P p = {}) const {
    auto const [low, high] = ranges::minmax_element(r, c, p);
    return {*low, *high};
  }
  template <class T, class C = less, class P = identity>
  constexpr min_max_result<T> operator()(initializer_list<T> r, C c = {}, P p = {}) const {
    auto const [low, high] = ranges::minmax_element(r, c, p);
    return {*low, *high};
  }
} minmax{};

}  // namespace page_objects

namespace page {

template <class F>
struct Transform {
  F function;
  template <input_range R>
  friend constexpr auto operator|(R&& r, Transform const& t) {
    vector<decay_t<invoke_result_t<F const&, range_reference_t<R>>>> made;
    for (auto&& v : r) made.push_back(invoke(t.function, v));
    return made;
  }
};
// A view of the elements for which the function returns true. Unlike the other views of this file, it computes one
// element at a time, so that large elements are not copied.
template <class Iterator, class F>
struct Filtered {
  struct iterator {
    using iterator_category = forward_iterator_tag;
    using value_type = iter_value_t<Iterator>;
    using difference_type = ptrdiff_t;
    using reference = iter_reference_t<Iterator>;
    using pointer = void;
    Iterator at{}, last{};
    F function{};
    constexpr reference operator*() const { return *at; }
    constexpr iterator& operator++() {
      ++at;
      return skip();
    }
    constexpr iterator operator++(int) {
      auto const before = *this;
      ++*this;
      return before;
    }
    constexpr bool operator==(iterator const& other) const { return at == other.at; }
    constexpr iterator& skip() {
      while (at != last && !invoke(function, *at)) ++at;
      return *this;
    }
  };
  Iterator first, last;
  F function;
  constexpr iterator begin() const { return iterator{first, last, function}.skip(); }
  constexpr iterator end() const { return {last, last, function}; }
};
template <class F>
struct Filter {
  F function;
  template <forward_range R>
  friend constexpr auto operator|(R&& r, Filter const& f) {
    return Filtered<iterator_t<R>, F>{ranges::begin(r), ranges::end(r), f.function};
  }
};
struct Take {
  size_t count;
  template <forward_range R>
  friend constexpr auto operator|(R&& r, Take const& t) {
    auto at = ranges::begin(r);
    for (size_t i = 0; i < t.count && at != ranges::end(r); ++i) ++at;
    return subrange(ranges::begin(r), at);
  }
};
struct Drop {
  size_t count;
  template <forward_range R>
  friend constexpr auto operator|(R&& r, Drop const& d) {
    auto at = ranges::begin(r);
    for (size_t i = 0; i < d.count && at != ranges::end(r); ++i) ++at;
    return subrange(at, ranges::end(r));
  }
};
struct Split {
  char at;
  friend inline vector<string_view> operator|(string_view text, Split const& s) {
    vector<string_view> made;
    for (;;) {
      auto const end = text.find(s.at);
      made.push_back(text.substr(0, end));
      if (end == string_view::npos) return made;
      text.remove_prefix(end + 1);
    }
  }
};

}  // namespace page

}  // namespace ranges

namespace views {

namespace page = ranges::page;

template <class F>
constexpr page::Transform<F> transform(F function) {
  return {std::move(function)};
}
template <class F>
constexpr page::Filter<F> filter(F function) {
  return {function};
}
constexpr page::Take take(size_t count) {
  return {count};
}
constexpr page::Drop drop(size_t count) {
  return {count};
}
constexpr page::Split split(char at) {
  return {at};
}

}  // namespace views

_LIBCPP_END_NAMESPACE_STD

#endif
