// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace sensotwin::robot {

/// A behaviour written as the paper writes it: in sequence, awaiting the next control step where time passes.
///
/// `Task<T>` is a lazy coroutine: it starts when awaited, and hands its result to whoever awaits it. The
/// innermost one waits on a `StepSignal`; the control loop calls `StepSignal::resume()` once per step. No
/// threads, no scheduler: a step runs exactly until the next `co_await step`. Destroying the outermost task
/// destroys the whole stack of behaviours.
template <class T = void>
class Task;

/// Where the innermost behaviour waits for the next control step.
class StepSignal {
 public:
  struct Awaiter {
    StepSignal& signal;
    [[nodiscard]] bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<> waiting) const noexcept { signal.waiting_ = waiting; }
    void await_resume() const noexcept {}
  };
  [[nodiscard]] Awaiter operator co_await() { return {*this}; }
  /// Continues the behaviour that waits, if one does.
  void resume() {
    if (waiting_) {
      std::exchange(waiting_, {}).resume();
    }
  }

 private:
  std::coroutine_handle<> waiting_;
};

namespace detail {

struct FinalAwaiter {
  [[nodiscard]] bool await_ready() const noexcept { return false; }
  template <class Promise>
  std::coroutine_handle<> await_suspend(std::coroutine_handle<Promise> done) const noexcept {
    const std::coroutine_handle<> parent = done.promise().parent;
    return parent ? parent : std::noop_coroutine();
  }
  void await_resume() const noexcept {}
};

struct PromiseBase {
  std::coroutine_handle<> parent;
  [[nodiscard]] std::suspend_always initial_suspend() const noexcept { return {}; }
  [[nodiscard]] FinalAwaiter final_suspend() const noexcept { return {}; }
  /// Behaviours report failures as values; an exception here is a programmer's mistake.
  [[noreturn]] void unhandled_exception() const noexcept { std::terminate(); }
};

template <class T>
struct Promise : PromiseBase {
  std::optional<T> value;
  Task<T> get_return_object();
  void return_value(T v) { value = std::move(v); }
};

template <>
struct Promise<void> : PromiseBase {
  Task<void> get_return_object();
  void return_void() const noexcept {}
};

}  // namespace detail

template <class T>
class [[nodiscard]] Task {
 public:
  using promise_type = detail::Promise<T>;  // NOLINT(readability-identifier-naming): the standard's name
  using Handle = std::coroutine_handle<promise_type>;

  explicit Task(Handle handle) : handle_(handle) {}
  Task(Task&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
  Task& operator=(Task&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  ~Task() {
    if (handle_) {
      handle_.destroy();
    }
  }

  /// Runs up to the first wait. For the outermost behaviour only; inner ones are awaited. \pre not started
  void start() { handle_.resume(); }
  [[nodiscard]] bool done() const { return handle_.done(); }

  struct Awaiter {
    Handle handle;
    [[nodiscard]] bool await_ready() const noexcept { return false; }
    [[nodiscard]] std::coroutine_handle<> await_suspend(std::coroutine_handle<> parent) const noexcept {
      handle.promise().parent = parent;
      return handle;
    }
    T await_resume() const {
      if constexpr (!std::is_void_v<T>) {
        assert(handle.promise().value.has_value());
        return std::move(*handle.promise().value);
      }
    }
  };
  [[nodiscard]] Awaiter operator co_await() && { return {handle_}; }

 private:
  Handle handle_;
};

namespace detail {
template <class T>
Task<T> Promise<T>::get_return_object() {
  return Task<T>{std::coroutine_handle<Promise<T>>::from_promise(*this)};
}
inline Task<void> Promise<void>::get_return_object() {
  return Task<void>{std::coroutine_handle<Promise<void>>::from_promise(*this)};
}
}  // namespace detail

}  // namespace sensotwin::robot
