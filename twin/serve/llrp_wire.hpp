// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "robot/base/bytes.hpp"
#include "twin/devices/emulated_uhf_reader.hpp"
#include "twin/serve/handle.hpp"
#include "twin/serve/tcp.hpp"
#include "twin/serve/wire.hpp"

namespace sensotwin::twin {

/// An emulated UHF reader at a TCP port, one client at a time: whoever comes second hears that another is
/// connected, and is sent away.
class LlrpWire final : public Wire {
 public:
  /// \param reader  must outlive the wire; its in-memory link must be cut  \throws ServeError
  LlrpWire(std::string name, EmulatedUhfReader& reader, Endpoint at);
  /// The client, if any, is told before its connection ends.
  ~LlrpWire() override;

  /// Where it listens, with the port that was found.
  [[nodiscard]] const Endpoint& endpoint() const { return endpoint_; }

 private:
  /// A connection that is over but for its last bytes: kept until the peer has seen the end, so that what it
  /// still sends does not reset the connection before it has read them.
  struct Leaving {
    Handle socket;
    double until_s{0.0};
  };

  void do_watch(std::vector<pollfd>& handles) const override;
  void do_pump(double wall_s) override;
  [[nodiscard]] bool do_has_client() const override { return static_cast<bool>(client_); }

  void serve_client(double wall_s);
  void accept_all(double wall_s);
  /// \returns false when the client has gone
  [[nodiscard]] bool take_from_client();
  /// \returns false when the client has gone
  [[nodiscard]] bool give_to_client(double wall_s);
  void drop_client();
  void let_go(Handle socket, double wall_s);
  void bury(double wall_s);

  EmulatedUhfReader& reader_;
  Endpoint endpoint_;
  Handle listener_;
  Handle client_;
  robot::Bytes pending_;  ///< taken from the reader, not yet by the socket
  std::size_t sent_of_pending_{0};
  double last_moved_s_{0.0};
  std::deque<Leaving> leaving_;
};

}  // namespace sensotwin::twin
