// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/base/time.hpp"
#include "robot/drivers/reader_clock.hpp"
#include "robot/drivers/uhf_memory.hpp"
#include "robot/drivers/uhf_read.hpp"
#include "robot/drivers/uhf_reader_config.hpp"
#include "robot/hal/byte_link.hpp"
#include "robot/wire/llrp/codec.hpp"

namespace sensotwin::robot {

enum class UhfReaderStatus : std::uint8_t {
  kDown,       ///< the link is down
  kGreeting,   ///< connected; the reader has not spoken yet
  kSettingUp,  ///< requests go back and forth
  kReading,    ///< the ROSpec runs: reads come when there are tags
  kWaiting,    ///< after a fault, until the set-up is tried again
  kShutDown,   ///< shut_down() was called
};

/// What went wrong, by name; counted in the health.
enum class UhfReaderFault : std::uint8_t {
  kNone,
  kLinkLost,        ///< ByteLink::is_up() became false
  kBusy,            ///< the reader greeted by saying that another client has it
  kClosedByReader,  ///< it announced that it closes the connection
  kNoAnswer,        ///< a request was not answered in time
  kRefused,         ///< a request was answered by another status than success: see refusal()
  kNoExtensions,    ///< Impinj's extensions are demanded, and refused
  kNoHopTable,      ///< the capabilities tell no frequencies
  kTooFewAntennas,  ///< a configured antenna is not among those of the reader
  kSilent,          ///< neither reports nor keepalives
  kCorruptStream,   ///< bytes that are no LLRP; the next message is hunted for, the session goes on
};
inline constexpr std::size_t kUhfReaderFaults = 11;

/// Counters since construction.
struct UhfReaderHealth {
  std::array<std::uint32_t, kUhfReaderFaults> faults{};  ///< by UhfReaderFault
  std::uint64_t reads{0};
  std::uint64_t reads_repeated{0};    ///< the very same read again (tag, antenna, time): given once
  std::uint64_t reads_incomplete{0};  ///< no 96-bit EPC, antenna, time, or a channel beyond the hop table
  std::uint64_t reads_unasked{0};     ///< of another ROSpec, or before ours was set up
  std::uint64_t keepalives{0};
  std::uint64_t messages_bad{0};         ///< sound frame, faulty content
  std::uint64_t messages_unexpected{0};  ///< answers that nobody waits for
  std::uint64_t bytes_skipped{0};        ///< belonged to no message
  std::uint32_t setups{0};               ///< completed
  std::uint32_t greetings_missed{0};     ///< set-ups begun without a greeting
  std::uint32_t clock_restarts{0};       ///< see ReaderClock
  [[nodiscard]] std::uint32_t count(UhfReaderFault fault) const {
    return faults[static_cast<std::size_t>(fault)];
  }
};

/// A UHF reader at the other end of an LLRP 1.0.1 connection; phase and fine RSSI by Impinj's extension.
/// Sets it up, keeps watch over it, and hands out its reads. Never waits.
///
/// Set-up, one request at a time: greeting, capabilities (hop table), DELETE of all AccessSpecs and ROSpecs,
/// Impinj extensions, keepalives, ADD and ENABLE of the ROSpec, which starts by itself. After a fault it is
/// tried again with a growing pause; a new connection starts it at once.
///
/// Fine print of the phase, as an R420 measures it (data study, 3.2 to 3.7): 4096 steps a turn, of which only
/// every fourth occurs; it falls as the distance grows; it holds a constant of cable and reader for each
/// port and of each tag; it may be off by half a turn, seldom at strong signals; it belongs to one frequency,
/// which changes five times a second. Nothing of that is corrected here.
///
/// Times: of the last answer within an entry, mapped by ReaderClock. A read's instant is never after the step
/// that brings it, and may be earlier than that of a read given before.
class UhfReader {
 public:
  /// Says nothing yet; the first step() does. `link` must outlive the driver. \pre config.antennas not empty
  UhfReader(ByteLink& link, UhfReaderConfig config);

  /// Takes what has arrived and says what is due; every 15 ms. \param now  never earlier than before
  void step(Instant now);
  /// The reads of the last step(), in the order of their arrival. Valid until the next step().
  [[nodiscard]] std::span<const UhfRead> reads() const { return reads_; }
  [[nodiscard]] UhfReaderStatus status() const { return status_; }
  [[nodiscard]] UhfReaderFault last_fault() const { return last_fault_; }
  /// The reader's own word on the last kRefused or kNoExtensions.
  [[nodiscard]] const llrp::LlrpStatus& refusal() const { return refusal_; }
  /// Frequencies by channel, index 1 the first; empty before the capabilities have come.
  [[nodiscard]] std::span<const double> channels_hz() const { return channels_hz_; }
  /// Whether phases come.
  [[nodiscard]] bool has_phase() const { return extended_; }
  [[nodiscard]] const UhfReaderHealth& health() const { return health_; }

  /// Reads `count` words (0: all from there on) of the user bank of the tag with that EPC, or writes some.
  /// The reader does it when it next reads the tag. \returns false, asking nothing, unless kReading and no
  /// other such request is under way
  [[nodiscard]] bool begin_memory_read(const Epc& epc, std::uint16_t word, std::uint16_t count);
  [[nodiscard]] bool begin_memory_write(const Epc& epc, std::uint16_t word, std::vector<std::uint16_t> data);
  /// What came of it, once; nothing before.
  [[nodiscard]] std::optional<UhfMemoryResult> poll_memory();

  /// Deletes the ROSpec and closes the connection; nothing is said after that.
  void shut_down();

 private:
  enum class Step : std::uint8_t {
    kCapabilities,
    kDeleteAccessSpecs,
    kDeleteRoSpecs,
    kExtensions,
    kSettings,
    kAddRoSpec,
    kEnableRoSpec,
    kMemoryAdd,
    kMemoryEnable,
    kMemoryDelete,
  };
  struct Awaited {
    Step step;
    std::uint32_t id;
    llrp::MessageType type;  ///< of the answer
    Instant deadline;
  };
  /// What one read cannot share with another.
  struct ReadKey {
    std::uint64_t utc_us{0};  ///< first: it tells most apart at once
    std::uint16_t antenna{0};
    Epc epc;
    bool operator==(const ReadKey&) const = default;
  };

  void begin_connection();
  void receive();
  void take(const llrp::Frame& frame);
  void take(const llrp::Message& message, std::uint32_t id);
  void take(const llrp::RoAccessReport& report);
  void take(const llrp::TagReport& tag);
  void take(const llrp::ReaderEvent& event);
  void take_answer(const llrp::Message& message, const llrp::LlrpStatus& status, std::uint32_t id);
  void take_capabilities(const llrp::GetReaderCapabilitiesResponse& capabilities);
  void refused(const llrp::LlrpStatus& status, Step step);
  [[nodiscard]] bool was_given(const ReadKey& key);
  void watch();
  void begin_setup();
  void ask(Step step);
  [[nodiscard]] llrp::Message request_of(Step step) const;
  void go_on_after(Step step);
  void fail(UhfReaderFault fault);
  bool send(const llrp::Message& message, std::uint32_t id);

  [[nodiscard]] std::uint16_t next_memory_op() const { return static_cast<std::uint16_t>(memory_op_ + 1); }
  [[nodiscard]] bool begin_memory(const Epc& epc, const llrp::C1G2OpSpec& operation);
  void memory_refused(Step step);
  void finish_memory(UhfMemoryResult result);

  ByteLink& link_;
  UhfReaderConfig config_;
  llrp::FrameDecoder decoder_;
  ReaderClock clock_;
  Instant now_{};
  UhfReaderStatus status_{UhfReaderStatus::kDown};
  UhfReaderFault last_fault_{UhfReaderFault::kNone};
  llrp::LlrpStatus refusal_;
  UhfReaderHealth health_;
  std::vector<UhfRead> reads_;
  std::vector<double> channels_hz_;
  bool extended_{false};
  std::optional<Awaited> awaited_;
  std::uint32_t next_id_{1};
  Instant last_heard_{};
  Instant greet_by_{};
  Instant retry_at_{};
  Duration retry_after_;

  /// More than come in one step; repeats come right behind their first. Chosen.
  static constexpr std::size_t kRemembered = 64;
  std::array<ReadKey, kRemembered> given_{};
  std::size_t given_next_{0};

  std::optional<llrp::AccessSpec> memory_spec_;  ///< under way
  std::uint16_t memory_op_{0};                   ///< its operation: tells a late answer from the one awaited
  std::optional<Instant> memory_by_;             ///< set while the tag is waited for
  std::optional<UhfMemoryResult> memory_result_;
};

}  // namespace sensotwin::robot
