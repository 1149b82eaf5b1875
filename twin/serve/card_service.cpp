// SPDX-License-Identifier: MIT
#include "twin/serve/card_service.hpp"

#include <winscard.h>

#include <algorithm>

namespace sensotwin::twin {
namespace {

/// FRIENDLYNAME of Debian's /etc/reader.conf.d/vpcd. pcscd adds the reader's number and the slot's.
constexpr const char* kPrefix = "Virtual PCD ";

}  // namespace

struct CardService::Session {
  Session()
      : good(SCardEstablishContext(SCARD_SCOPE_SYSTEM, nullptr, nullptr, &context) == SCARD_S_SUCCESS) {}
  ~Session() {
    if (good) {
      SCardReleaseContext(context);
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  SCARDCONTEXT context{};
  bool good;
};

CardService::CardService() : session_(std::make_unique<Session>()) {}
CardService::~CardService() = default;

bool CardService::is_there() const {
  return session_->good && SCardIsValidContext(session_->context) == SCARD_S_SUCCESS;
}

void CardService::renew() {
  if (!is_there()) {
    session_ = std::make_unique<Session>();
  }
}

std::vector<std::string> CardService::readers() const {
  std::vector<std::string> names;
  DWORD size = 0;
  if (!session_->good || SCardListReaders(session_->context, nullptr, nullptr, &size) != SCARD_S_SUCCESS) {
    return names;
  }
  // One after the other, each ended by a zero, then one more zero.
  std::string all(size, '\0');
  if (SCardListReaders(session_->context, nullptr, all.data(), &size) != SCARD_S_SUCCESS) {
    return names;
  }
  for (const char* name = all.c_str(); *name != '\0'; name += names.back().size() + 1) {
    names.emplace_back(name);
  }
  return names;
}

std::vector<std::string> virtual_slots_among(const std::vector<std::string>& readers) {
  std::vector<std::string> slots{std::string{kPrefix} + "00 00", std::string{kPrefix} + "00 01"};
  for (std::string& slot : slots) {
    const std::string ending = slot.substr(slot.size() - 3);
    const auto found = std::ranges::find_if(readers, [&](const std::string& name) {
      return name.starts_with(kPrefix) && name.ends_with(ending);
    });
    if (found != readers.end()) {
      slot = *found;
    }
  }
  return slots;
}

}  // namespace sensotwin::twin
