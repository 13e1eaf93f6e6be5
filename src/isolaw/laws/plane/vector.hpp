// Vectors for the laws of the plane. Their numbers are double, num::Dual with the derivatives by the trial's
// displacement, or num::Batch with one device per lane. In a batch parameters and motion differ between lanes, so
// every branch is a select.
#pragma once

#include "isolaw/laws/law.hpp"

namespace isolaw::laws::plane {

// The peak that softens a force, in a law that remembers one: the largest distance so far, or the largest displacement
// along each axis, which depends on the choice of axes. Tests in one direction cannot tell the two apart.
enum class Softening { by_distance, by_axis };

template <class T>
struct Vector {
  T x, y;

  friend Vector operator+(Vector const& a, Vector const& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vector operator-(Vector const& a, Vector const& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vector operator*(T const& k, Vector const& a) { return {k * a.x, k * a.y}; }
};

template <class T>
T dot(Vector<T> const& a, Vector<T> const& b) {
  return rounded(a.x * b.x) + a.y * b.y;
}
// The vector turned by 90 degrees, from the x axis towards the y axis.
template <class T>
Vector<T> turned(Vector<T> const& a) {
  return {-a.y, a.x};
}
template <class T>
T norm(Vector<T> const& a) {
  return sqrt(dot(a, a));
}
template <class Condition, class T>
Vector<T> chosen(Condition const& condition, Vector<T> const& a, Vector<T> const& b) {
  return {select(condition, a.x, b.x), select(condition, a.y, b.y)};
}

// A straight step. At rest the direction is the zero vector, and only `moved` has derivatives.
template <class T>
struct Straight {
  Vector<T> moved, direction;
  T length;

  Straight(Vector<T> const& from, Vector<T> const& to) : moved(to - from), length(norm(moved)) {
    T const shortest(1e-150);  // a shorter step counts as rest, because the square of its length would underflow to 0
    auto const moves = length > shortest;
    direction = (T(1.0) / max(length, shortest)) * moved;
    direction = chosen(moves, direction, Vector<T>{T(0.0), T(0.0)});
  }
};

// A vector in components: `along` a direction, and `across`, which is along turned(direction).
template <class T>
struct Split {
  T along, across;

  Split(T const& p, T const& s) : along(p), across(s) {}
  Split(Vector<T> const& a, Vector<T> const& direction) : along(dot(a, direction)), across(dot(a, turned(direction))) {}
  Vector<T> joined(Vector<T> const& direction) const { return along * direction + across * turned(direction); }
};

// A fading memory of the motion in direction n: q' = rate (n - q). A step without motion changes no value of q. It only
// gives q the derivatives that a step would have.
template <class T>
Vector<T> fading(Vector<T> const& q, Straight<T> const& way, T const& rate) {
  T const left = exp(-rate * way.length);
  return chosen(way.length > T(0.0), way.direction + left * (q - way.direction), q + rate * way.moved);
}

}  // namespace isolaw::laws::plane
