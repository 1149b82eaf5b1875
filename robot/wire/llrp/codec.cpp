// SPDX-License-Identifier: MIT
#include "robot/wire/llrp/codec.hpp"

#include <type_traits>

#include "robot/wire/llrp/layout_messages.hpp"
#include "robot/wire/llrp/reader.hpp"
#include "robot/wire/llrp/writer.hpp"

namespace sensotwin::robot::llrp {
namespace {

using Decoded = Result<Message, DecodeError>;

template <class T>
[[nodiscard]] Decoded decode_as(ByteView body) {
  Reader reader{body};
  T message;
  body_layout(reader, message);
  if (reader.ok() && !reader.at_end()) {
    reader.fail(Fault::kTrailingBytes);
  }
  if (!reader.ok()) {
    return Unexpected{*reader.error()};
  }
  return Message{std::move(message)};
}

[[nodiscard]] Decoded decode_custom(ByteView body) {
  Decoded raw = decode_as<CustomMessage>(body);
  if (!raw) {
    return raw;
  }
  const CustomMessage& message = *std::get_if<CustomMessage>(&*raw);
  if (message.vendor == kImpinj && message.subtype == ImpinjEnableExtensions::kSubtype) {
    return decode_as<ImpinjEnableExtensions>(body);
  }
  if (message.vendor == kImpinj && message.subtype == ImpinjEnableExtensionsResponse::kSubtype) {
    return decode_as<ImpinjEnableExtensionsResponse>(body);
  }
  return raw;
}

/// Tries the alternatives from number I on.
template <std::size_t I>
[[nodiscard]] Decoded decode_from(MessageType type, ByteView body) {
  if constexpr (I == std::variant_size_v<Message>) {
    DecodeError error;
    error.fault = Fault::kUnknownMessage;
    return Unexpected{error};
  } else {
    using T = std::variant_alternative_t<I, Message>;
    if (type == T::kMessage) {
      return decode_as<T>(body);
    }
    return decode_from<I + 1>(type, body);
  }
}

}  // namespace

MessageType type_of(const Message& message) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::kMessage; }, message);
}

Result<Message, DecodeError> decode(const Frame& frame) {
  if (frame.header.version != kVersion) {
    DecodeError error;
    error.fault = Fault::kUnsupportedVersion;
    return Unexpected{error};
  }
  const auto type = static_cast<MessageType>(frame.header.type);
  if (type == MessageType::kCustomMessage) {
    return decode_custom(frame.body);
  }
  return decode_from<0>(type, frame.body);
}

Bytes encode(const Message& message, std::uint32_t id, std::uint8_t version) {
  constexpr std::size_t kMostMessages = 128;  // bytes: a report of one entry has about 100
  Bytes out;
  out.reserve(kMostMessages);
  encode(message, id, out, version);
  return out;
}

void encode(const Message& message, std::uint32_t id, Bytes& out, std::uint8_t version) {
  const std::size_t start = out.size();
  Writer writer{out};
  writer.number(static_cast<std::uint16_t>((version << 10) | static_cast<std::uint16_t>(type_of(message))));
  writer.number(std::uint32_t{0});
  writer.number(id);
  std::visit([&writer](const auto& m) { body_layout(writer, m); }, message);
  const std::size_t length = out.size() - start;
  for (std::size_t i = 0; i < 4; ++i) {
    out[start + 2 + i] = static_cast<std::uint8_t>(length >> (24 - 8 * i));
  }
}

}  // namespace sensotwin::robot::llrp
