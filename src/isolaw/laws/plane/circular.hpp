// Solves p' = 1 - c p^2, s' = -c p s by tanh or tan and 1 / cosh or 1 / cos, using only arithmetic, exp and log2.
#pragma once

#include "isolaw/laws/law.hpp"

namespace isolaw::laws::plane {

// With k = sqrt |c|: tan = tanh(k x) / k and sec = 1 / cosh(k x) for c > 0; tan(k x) / k and 1 / cos(k x) for c < 0;
// x and 1 for c = 0. Valid for x >= 0 and, where c < 0, up to k x = pi/2.
template <class T>
struct Circular {
  T tan, sec;

  Circular(T const& c, T const& x) : tan(x), sec(T(1.0)) {
    T const one(1.0), two(2.0), k = sqrt(abs(c)), y = k * x, per_k = one / max(k, T(num::smallest_power_base));
    T const e = exp(-y), e2 = e * e, per = one / (one + e2);
    SineCosine const trig(min(y, T(half_pi)));
    T const per_cos = one / max(trig.cosine, T(num::smallest_power_base));
    auto const small = y<T(smallest), hyperbolic = c> T(0.0);
    T const series = c * x * x;
    tan = select(small, x - x * series * T(1.0 / 3), per_k * select(hyperbolic, (one - e2) * per, trig.sine * per_cos));
    sec = select(small, one - T(0.5) * series, select(hyperbolic, two * e * per, per_cos));
  }

  // The x at which Circular::tan reaches the value `tan`; a large x if Circular::tan never reaches it.
  static T length_to(T const& tan, T const& c) {
    T const one(1.0), k = sqrt(abs(c)), v = k * tan, per_k = one / max(k, T(num::smallest_power_base));
    T const ratio = (one + v) / max(one - v, T(num::smallest_power_base));
    T const area = T(0.5 / num::log2_e) * log2(max(ratio, one));
    auto const small = v<T(smallest), hyperbolic = c> T(0.0);
    return select(small, tan + tan * (c * tan * tan) * T(1.0 / 3), per_k * select(hyperbolic, area, arc(v)));
  }

 private:
  static constexpr double half_pi = 1.57079632679489661923;
  // For an argument sqrt(|c|) x below this, two terms of the series of tan and sec give all digits but the last.
  static constexpr double smallest = 1e-4;

  // Sine and cosine of an angle up to pi/2: from the series of an eighth of the angle, which is then doubled three
  // times.
  struct SineCosine {
    T sine, cosine;
    explicit SineCosine(T const& angle) : sine(angle), cosine(angle) {
      T const one(1.0), y = T(0.125) * angle, y2 = y * y;
      sine =
          y * (one - y2 * T(1.0 / 6) *
                         (one - y2 * T(1.0 / 20) *
                                    (one - y2 * T(1.0 / 42) * (one - y2 * T(1.0 / 72) * (one - y2 * T(1.0 / 110))))));
      // `fall` is 1 - cos, because that keeps its digits near 0.
      T fall = y2 * T(0.5) *
               (one - y2 * T(1.0 / 12) *
                          (one - y2 * T(1.0 / 30) *
                                     (one - y2 * T(1.0 / 56) * (one - y2 * T(1.0 / 90) * (one - y2 * T(1.0 / 132))))));
      for (int i = 0; i < 3; ++i) {
        T const before = one - fall;
        fall = T(2.0) * sine * sine;
        sine = T(2.0) * sine * before;
      }
      cosine = one - fall;
    }
  };
  // arctan(v) for v >= 0: a guess within 0.005, improved twice by a rule of fifth order.
  static T arc(T const& v) {
    T const one(1.0), per_v = one / max(v, T(num::smallest_power_base));
    T angle = select(v <= one, v / (one + T(0.28) * v * v), T(half_pi) - per_v / (one + T(0.28) * per_v * per_v));
    for (int i = 0; i < 2; ++i) {
      SineCosine const trig(angle);
      T const off = (trig.sine - v * trig.cosine) / (trig.cosine + v * trig.sine);
      angle = angle - off * (one - off * off * T(1.0 / 3));
    }
    return angle;
  }
};

}  // namespace isolaw::laws::plane
