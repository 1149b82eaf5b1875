// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace sensotwin::twin {

/// Why a request of the page is refused, as an HTTP status and one sentence for a person. Thrown by this
/// folder's functions and answered by TraceSession, so that none of it leaves the server.
class TraceError : public std::runtime_error {
 public:
  TraceError(int status, const std::string& what) : std::runtime_error(what), status_(status) {}
  [[nodiscard]] int status() const { return status_; }

  static constexpr int kBadRequest = 400;
  static constexpr int kNotFound = 404;
  static constexpr int kConflict = 409;
  static constexpr int kTooLarge = 413;
  static constexpr int kUnusable = 422;  ///< understood, and wrong
  static constexpr int kCannotWrite = 507;

 private:
  int status_;
};

}  // namespace sensotwin::twin
