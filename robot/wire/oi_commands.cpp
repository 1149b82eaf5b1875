// SPDX-License-Identifier: MIT
#include "robot/wire/oi_commands.hpp"

#include <algorithm>
#include <type_traits>

namespace sensotwin::robot::oi {
namespace {

[[nodiscard]] bool is_straight(int radius_mm) {
  return radius_mm == kStraight || radius_mm == kStraightToo;
}

/// Counts the bytes that did not fit instead of writing them.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> into) : into_(into) {}
  void put(std::uint8_t byte) {
    if (size_ < into_.size()) {
      into_[size_] = byte;
    }
    ++size_;
  }
  template <class T>
  void operator()(T value, Range) {
    if constexpr (sizeof(T) == 2) {
      put(high_byte(static_cast<std::uint16_t>(value)));
      put(low_byte(static_cast<std::uint16_t>(value)));
    } else {
      put(static_cast<std::uint8_t>(value));
    }
  }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::span<std::uint8_t> into_;
  std::size_t size_{0};
};

/// \pre the bytes are as many as the command announces
class Reader {
 public:
  explicit Reader(ByteView from) : from_(from) {}
  template <class T>
  void operator()(T& value, Range) {
    if constexpr (sizeof(T) == 2) {
      value = static_cast<T>(u16_from_be(from_[at_], from_[at_ + 1]));
    } else {
      value = static_cast<T>(from_[at_]);
    }
    at_ += sizeof(T);
  }

 private:
  ByteView from_;
  std::size_t at_{0};
};

template <class... C>
[[nodiscard]] Command read_command(Opcode opcode, ByteView data, const std::variant<C...>*) {
  Command out;
  const auto read = [&]<class T>(std::type_identity<T>) {
    Reader reader{data};
    T::fields(out.template emplace<T>(), reader);
    return true;
  };
  [[maybe_unused]] const bool found = ((C::kOpcode == opcode && read(std::type_identity<C>{})) || ...);
  assert(found);
  return out;
}

}  // namespace

Opcode opcode_of(const Command& command) {
  return std::visit([]<class C>(const C&) { return C::kOpcode; }, command);
}

bool in_range(const Command& command) {
  bool ok = true;
  const auto look = [&](int value, Range range) {
    ok = ok && ((value >= range.min && value <= range.max) || (range.or_straight && is_straight(value)));
  };
  std::visit([&]<class C>(const C& c) { C::fields(c, look); }, command);
  return ok;
}

Command clamped(Command command) {
  const auto clamp = []<class T>(T& value, Range range) {
    if (!(range.or_straight && is_straight(value))) {
      value = static_cast<T>(std::clamp<int>(value, range.min, range.max));
    }
  };
  std::visit([&]<class C>(C& c) { C::fields(c, clamp); }, command);
  return command;
}

Result<std::size_t, CommandError> encode(const Command& command, std::span<std::uint8_t> into) {
  Writer writer{into};
  std::visit(
      [&]<class C>(const C& c) {
        writer.put(static_cast<std::uint8_t>(C::kOpcode));
        C::fields(c, writer);
      },
      command);
  if (writer.size() > into.size()) {
    return Unexpected{CommandError::kNoRoom};
  }
  return writer.size();
}

Bytes encode(const Command& command) {
  Bytes bytes(kMaxCommandBytes);
  bytes.resize(*encode(command, std::span{bytes}));
  return bytes;
}

std::size_t CommandDecoder::bytes_needed() const {
  if (pending_->tail == Tail::kNone || held_ < pending_->data_bytes) {
    return pending_->data_bytes;
  }
  const std::size_t announced = data_[pending_->data_bytes - 1u];
  return pending_->data_bytes + (pending_->tail == Tail::kNotes ? 2 * announced : announced);
}

Result<Command, CommandError> CommandDecoder::complete() {
  const OpcodeInfo& info = *pending_;
  pending_ = nullptr;
  if (info.tail == Tail::kNotes && data_[1] > Song::kMaxNotes) {
    return Unexpected{CommandError::kSongTooLong};
  }
  return read_command(info.opcode, ByteView{data_.data(), held_}, static_cast<const Command*>(nullptr));
}

std::optional<Result<Command, CommandError>> CommandDecoder::push(std::uint8_t byte) {
  if (pending_ == nullptr) {
    pending_ = table_->find(byte);
    held_ = 0;
    if (pending_ == nullptr) {
      return Unexpected{CommandError::kUnknownOpcode};
    }
  } else {
    data_[held_++] = byte;
  }
  if (held_ < bytes_needed()) {
    return std::nullopt;
  }
  return complete();
}

}  // namespace sensotwin::robot::oi
