// SPDX-License-Identifier: MIT
#include "robot/ports/guardian.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace sensotwin::robot {
namespace {

enum Word : char { kBeat = 'b', kPort = 'p', kGoHome = 'h' };

/// At most this long for one stop on the line. Chosen: ten times what it takes at 57600 baud.
constexpr int kSay_ms = 100;

/// Everything, unless the port takes nothing for too long.
void say(int port, ByteView bytes) {
  // What the program left unsent is no longer wanted; the stop's zeros complete what is torn by that.
  tcflush(port, TCOFLUSH);
  while (!bytes.empty()) {
    const ssize_t taken = ::write(port, bytes.data(), bytes.size());
    if (taken > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(taken));
      continue;
    }
    pollfd room{port, POLLOUT, 0};
    if ((taken < 0 && errno != EAGAIN && errno != EINTR) || ::poll(&room, 1, kSay_ms) <= 0) {
      return;
    }
  }
}

/// One word of the program, and the descriptor that came with it.
struct Heard {
  ssize_t size{0};
  char word{};
  Descriptor port;
};

Heard hear(int socket) {
  Heard heard;
  iovec text{&heard.word, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> extra{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = extra.data();
  message.msg_controllen = extra.size();
  heard.size = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  const cmsghdr* const header = heard.size > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    int port = -1;
    std::memcpy(&port, CMSG_DATA(header), sizeof port);
    heard.port = Descriptor{port};
  }
  return heard;
}

[[noreturn]] void guard(int socket, const GuardianConfig& config, const sigset_t& signals) {
  ::setsid();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP}) {
    (void)std::signal(signal, SIG_IGN);
  }
  ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  Bytes farewell = config.stop;
  farewell.insert(farewell.end(), config.farewell.begin(), config.farewell.end());
  Descriptor port;
  bool armed = false;
  for (;;) {
    pollfd state{socket, POLLIN, 0};
    const int ready = ::poll(&state, 1, armed ? static_cast<int>(config.silent_after.count()) : -1);
    if (ready == 0) {
      armed = false;  // once; the next beat arms it again
      if (port) {
        say(port.get(), config.stop);
      }
      continue;
    }
    Heard heard = hear(socket);
    if (heard.size < 0 && errno == EINTR) {
      continue;
    }
    if (heard.size <= 0 || heard.word == kGoHome) {
      if (port && heard.size <= 0) {
        say(port.get(), farewell);
      }
      ::_exit(0);
    }
    if (heard.word == kPort) {
      port = std::move(heard.port);
    }
    armed = armed || heard.word == kBeat;
  }
}

bool tell(int socket, char word) {
  return ::send(socket, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT) == 1 || errno == EAGAIN;
}

}  // namespace

Result<Guardian, int> Guardian::begin(const GuardianConfig& config) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return Unexpected{errno};
  }
  Descriptor ours{ends[0]};
  Descriptor its{ends[1]};
  // A signal between the fork and the guardian's own handlers must not end it.
  sigset_t every{};
  sigset_t before{};
  sigfillset(&every);
  ::sigprocmask(SIG_SETMASK, &every, &before);
  const pid_t pid = ::fork();
  const int error = errno;
  if (pid == 0) {
    ours.close();
    guard(its.get(), config, before);
  }
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (pid < 0) {
    return Unexpected{error};
  }
  return Guardian{std::move(ours), pid};
}

void Guardian::release() {
  if (socket_) {
    tell(socket_.get(), kGoHome);
    socket_.close();
    (void)::waitpid(pid_, nullptr, 0);
  }
}

bool Guardian::watch(int serial_port) {
  char word = kPort;
  iovec text{&word, 1};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> extra{};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = extra.data();
  message.msg_controllen = extra.size();
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(header), &serial_port, sizeof serial_port);
  return ::sendmsg(socket_.get(), &message, MSG_NOSIGNAL) == 1;
}

bool Guardian::beat() {
  return tell(socket_.get(), kBeat);
}

}  // namespace sensotwin::robot
