// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "robot/base/time.hpp"
#include "robot/base/wheel_speeds.hpp"
#include "robot/drivers/roomba_state.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/wire/oi_commands.hpp"
#include "robot/wire/oi_stream.hpp"
#include "robot/wire/oi_stream_layout.hpp"
#include "robot/wire/sci.hpp"

namespace sensotwin::robot {

struct RoombaConfig {
  enum class Interface : std::uint8_t { kOpenInterface, kSci };
  Interface interface { Interface::kOpenInterface };
  /// The mode to work in: safe or full.
  oi::Mode mode{oi::Mode::kSafe};
  /// Without a good frame for so long, the wheels are told to stop. Chosen: six frames lost in a row; the
  /// robot goes 5 cm at full speed meanwhile.
  Duration stream_timeout{std::chrono::milliseconds{100}};
  /// The start-up is said again when the wanted mode was not seen for so long. No robot answers later
  /// (libcreate waits as long).
  Duration start_timeout{std::chrono::milliseconds{500}};
  /// SCI: a request is said again when its answer is not complete by then (libcreate waits as long).
  Duration poll_timeout{std::chrono::milliseconds{50}};
  /// The same speeds are sent again after so many frames. A lost byte leaves the robot waiting for data, so
  /// that the next command is eaten too; it has no time-out of its own and would drive on. Chosen: a wrong
  /// speed lives 0.3 s at most, for 5 bytes every 150 ms.
  int repeat_frames{10};
  /// What the robot adds to the mode it reports. Some 600s with Wi-Fi: 1 (libcreate's mode-report
  /// workaround).
  int mode_report_offset{0};
  /// SCI: to make arcs of wheel speeds.
  double sci_wheel_base_m{sci::kWheelBase_m};
};

enum class RoombaStatus : std::uint8_t {
  kStarting,    ///< start-up is said, the wanted mode not yet seen
  kReady,       ///< frames come, the mode is the wanted one: drive() drives
  kModeLost,    ///< the robot left the mode (cliff, wheel drop, charger, reset): it stands until rearm()
  kStreamLost,  ///< no good frame for stream_timeout: the wheels are told to stop until frames come again
  kShutDown,    ///< shut_down() was called; rearm() starts again
};

/// What the wire did since construction.
struct LinkHealth {
  std::uint64_t frames_good{0};
  std::uint64_t frames_corrupt{0};     ///< bad checksum, length or content
  std::uint64_t frames_superseded{0};  ///< good, but a newer one came in the same step
  std::uint64_t frames_missed{0};   ///< 15 ms slots between two good frames without one (estimated from time)
  std::uint64_t bytes_skipped{0};   ///< belonged to no good frame
  std::uint64_t writes_refused{0};  ///< the link was down
  std::uint64_t starts{0};          ///< how often the start-up was said
};

/// A Roomba at the other end of a serial line: Create 2, Roomba 500 to 900 by Open Interface stream, Roomba
/// 400 by SCI polling. Starts it, keeps watch over its frames and mode, and moves its wheels. Never waits.
///
/// A Roomba 400 cannot be asked for its mode: that it left safe mode is concluded from what makes it do so
/// (wheel drop, cliff while driving, charging). Its answers carry no checksum: one that no robot can mean is
/// corrupt.
class Roomba {
 public:
  /// Says nothing yet; the first step() does. `link` must outlive the driver.
  Roomba(ByteLink& link, const RoombaConfig& config);

  /// Takes what has arrived, once every 15 ms. \pre now is not before the last step's
  void step(Instant now);
  /// The newest good frame of the last step(), or nullptr. Valid until the next step().
  [[nodiscard]] const RoombaState* fresh() const { return fresh_ ? &state_ : nullptr; }
  [[nodiscard]] RoombaStatus status() const { return status_; }

  /// Speeds for both wheels, held until the next call; rounded to mm/s, clamped to 0.5 m/s. Sent when what
  /// the robot would be told differs from the last time, and again by step() every `repeat_frames`. \returns
  /// false, moving nothing, unless kReady and the link is up
  bool drive(const WheelSpeeds& wheels);
  /// Stops the wheels now, whatever the status.
  void stop();
  /// Starts the robot again after kModeLost, kStreamLost or kShutDown: the next step() says the start-up.
  void rearm() { rearm(config_.mode); }
  /// The same in another mode, kept from now on: full drives off a home base, which safe mode refuses.
  void rearm(oi::Mode mode);
  /// Stops the wheels, leaves the mode and ends the Open Interface.
  void shut_down();

  [[nodiscard]] const LinkHealth& health() const { return health_; }

 private:
  [[nodiscard]] bool is_sci() const { return config_.interface == RoombaConfig::Interface::kSci; }
  [[nodiscard]] bool send(const oi::Command& command);
  [[nodiscard]] bool send_wheels(const WheelSpeeds& wheels);
  [[nodiscard]] bool was_sent(const WheelSpeeds& wheels) const;
  void say_start(Instant now);
  void read_stream(Instant now);
  [[nodiscard]] bool take_payload(ByteView payload, Instant now);
  /// The sum of a frame lets one in sixteen pass in which two bytes have the same bit turned. Encoder counts
  /// that no wheel can have reached since the last good frame are such a case, unless the next frame says the
  /// same: then the robot has begun to count anew.
  [[nodiscard]] bool can_have_turned(const oi::SensorValues& values, Instant now);
  void read_polled(Instant now);
  void poll(Instant now);
  void take_frame(Instant now);
  void count_missed(Instant now, std::uint64_t frames);
  [[nodiscard]] bool in_wanted_mode() const;
  void watch(Instant now);
  void halt(RoombaStatus because);

  /// 0.5 m/s is 17 counts in 15 ms. Chosen: three times as many, for wheels in the air.
  static constexpr std::int64_t kMostCountsInATick = 51;

  ByteLink& link_;
  RoombaConfig config_;
  oi::StreamLayout layout_;
  oi::StreamDecoder decoder_;
  oi::SensorValues values_;
  RoombaState state_;
  std::optional<EncoderCounts> doubted_;  ///< of the last frame, when it was not believed
  bool fresh_{false};
  RoombaStatus status_{RoombaStatus::kStarting};
  LinkHealth health_;
  WheelSpeeds sent_;
  oi::DriveDirect told_;  ///< sent_ as the Open Interface spells it
  int frames_since_sent_{0};
  std::optional<Instant> said_start_;
  std::optional<Instant> last_good_;
  Instant last_stop_;
  std::optional<Instant> polled_;
  std::array<std::uint8_t, sci::kAllSensorsBytes> answer_{};
  std::size_t answer_held_{0};
};

}  // namespace sensotwin::robot
