// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <utility>
#include <variant>

namespace sensotwin::robot {

/// Failure half of a Result; spelt like std::unexpected, which GCC 12 does not have yet.
template <class E>
struct Unexpected {
  E error;
};
template <class E>
Unexpected(E) -> Unexpected<E>;

/// A value, or the named reason why there is none. For what the world does to us (checksum, timeout, reader
/// unplugged); a person's mistake is an exception at load time, a programmer's is an assertion.
template <class T, class E>
class [[nodiscard]] Result {
 public:
  Result(T value) : v_(std::in_place_index<0>, std::move(value)) {}
  Result(Unexpected<E> u) : v_(std::in_place_index<1>, std::move(u.error)) {}
  [[nodiscard]] bool has_value() const { return v_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  /// \pre has_value()
  [[nodiscard]] const T& operator*() const {
    assert(has_value());
    return *std::get_if<0>(&v_);
  }
  [[nodiscard]] T& operator*() {
    assert(has_value());
    return *std::get_if<0>(&v_);
  }
  [[nodiscard]] const T* operator->() const { return &**this; }
  [[nodiscard]] T* operator->() { return &**this; }
  /// \pre !has_value()
  [[nodiscard]] const E& error() const {
    assert(!has_value());
    return *std::get_if<1>(&v_);
  }

 private:
  std::variant<T, E> v_;
};

}  // namespace sensotwin::robot
