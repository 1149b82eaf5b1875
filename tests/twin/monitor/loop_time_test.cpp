// SPDX-License-Identifier: MIT
// A hundred browsers' worth of streams, slow readers among them, and requests that are none: the robot's loop
// must not notice. Both loads are measured in one run, in turn, so that what else this machine does falls on
// both.
#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <string_view>
#include <thread>
#include <vector>

#include "robot/telemetry/monitor.hpp"
#include "twin/run/mapping_twin.hpp"
#include "twin/run/twin_tap.hpp"
#include "twin/scene/scene_reader.hpp"

namespace sensotwin::twin {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kReaders = 90;
constexpr int kSlowReaders = 10;
/// Ticks after which those who left are forgotten, and those who came have the picture.
constexpr int kSettling = 60;

/// Stands for the browsers, in a process of its own: theirs is not the robot's computer.
class Browsers {
 public:
  /// Before there is any thread.
  Browsers() {
    std::array<int, 2> ends{};
    std::array<int, 2> answers{};
    EXPECT_EQ(::pipe(ends.data()), 0);
    EXPECT_EQ(::pipe(answers.data()), 0);
    child_ = ::fork();
    if (child_ == 0) {
      ::close(ends[1]);
      (void)!::nice(19);
      serve(ends[0], answers[1]);
      ::_exit(0);
    }
    ::close(ends[0]);
    ::close(answers[1]);
    to_child_ = ends[1];
    from_child_ = answers[0];
  }
  Browsers(const Browsers&) = delete;
  Browsers& operator=(const Browsers&) = delete;
  ~Browsers() {
    ::close(to_child_);
    ::close(from_child_);
    ::waitpid(child_, nullptr, 0);
  }
  /// Returns once every stream has sent something. \param port  0: all close their windows
  void open(std::uint16_t port) const {
    ASSERT_EQ(::write(to_child_, &port, sizeof port), 2);
    int streams = 0;
    ASSERT_EQ(::read(from_child_, &streams, sizeof streams), static_cast<ssize_t>(sizeof streams));
    ASSERT_EQ(streams, port == 0 ? 0 : kReaders + kSlowReaders);
  }

 private:
  static int connect_to(std::uint16_t port, std::string_view request, int receive_bytes) {
    const int client = ::socket(AF_INET, SOCK_STREAM, 0);
    if (receive_bytes > 0) {
      ::setsockopt(client, SOL_SOCKET, SO_RCVBUF, &receive_bytes, sizeof receive_bytes);
    }
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    (void)::connect(client, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    (void)::send(client, request.data(), request.size(), MSG_NOSIGNAL);
    return client;
  }

  /// Streams of these that have sent something, waiting up to five seconds for each.
  static int answered(const std::vector<int>& clients) {
    int count = 0;
    for (const int client : clients) {
      pollfd handle{.fd = client, .events = POLLIN, .revents = 0};
      char begin[12]{};
      const bool came = ::poll(&handle, 1, 5000) > 0;
      count += came && ::recv(client, begin, sizeof begin, MSG_PEEK) == sizeof begin &&
                       std::string_view(begin, sizeof begin) == "HTTP/1.1 200"
                   ? 1
                   : 0;
    }
    return count;
  }

  static void serve(int commands, int answers) {
    constexpr std::string_view kEvents = "GET /events HTTP/1.1\r\nHost: localhost\r\n\r\n";
    constexpr std::array<std::string_view, 4> kMalformed{
        "GET /../../etc/passwd HTTP/1.1\r\nHost: localhost\r\n\r\n", "\x16\x03\x01\x02",
        "POST /events HTTP/1.1\r\nHost: localhost\r\nContent-Length: 99999999999\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: evil.example\r\nRange: bytes=0-,0-,0-,0-\r\n\r\n"};
    std::vector<int> readers;
    std::vector<int> slow;
    std::vector<char> sink(1 << 20);
    std::uint16_t port = 0;
    std::size_t next = 0;
    while (true) {
      std::vector<pollfd> handles{{.fd = commands, .events = POLLIN, .revents = 0}};
      for (const int reader : readers) {
        handles.push_back({.fd = reader, .events = POLLIN, .revents = 0});
      }
      ::poll(handles.data(), handles.size(), 20);
      for (std::size_t i = 1; i < handles.size(); ++i) {
        if (handles[i].revents != 0) {
          (void)::recv(handles[i].fd, sink.data(), sink.size(), MSG_DONTWAIT);
        }
      }
      if (port != 0) {
        ::close(connect_to(port, kMalformed[next++ % kMalformed.size()], 0));
      }
      if (handles[0].revents == 0) {
        continue;
      }
      if (::read(commands, &port, sizeof port) != 2) {
        return;
      }
      for (std::vector<int>* group : {&readers, &slow}) {
        std::for_each(group->begin(), group->end(), ::close);
        group->clear();
      }
      for (int i = 0; port != 0 && i < kReaders + kSlowReaders; ++i) {
        // A slow reader takes a kilobyte and then nothing more.
        (i < kReaders ? readers : slow).push_back(connect_to(port, kEvents, i < kReaders ? 0 : 1024));
      }
      const int streams = answered(readers) + answered(slow);
      (void)!::write(answers, &streams, sizeof streams);
    }
  }

  pid_t child_{-1};
  int to_child_{-1};
  int from_child_{-1};
};

/// Of the times that ticks took, the one that 99 of 100 stay below, us.
double p99_us(std::vector<double> ticks_us) {
  const auto at = ticks_us.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(ticks_us.size()));
  std::nth_element(ticks_us.begin(), at, ticks_us.end());
  return *at;
}

class LoopTime : public ::testing::Test {
 protected:
  LoopTime()
      : scene_(read_scene(SENSOTWIN_SOURCE_DIR "/scenes/house.yaml")),
        monitor_(robot::WebAddress{}),
        twin_(scene_),
        tap_(&monitor_.hub(), scene_, robot_settings_of(scene_, twin_.map_id())) {
    const std::string url = monitor_.url();
    port_ = static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
  }

  void tick_into(std::vector<double>& ticks_us) {
    const Clock::time_point begun = Clock::now();
    twin_.tick();
    tap_.after_tick(twin_);
    ticks_us.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begun).count());
  }

  /// \param wait  called before each tick
  template <class Wait>
  void measure(int blocks, int ticks, Wait wait) {
    for (int block = 0; block < 2 * blocks; ++block) {
      const bool loaded = block % 2 == 1;
      browsers_.open(loaded ? port_ : 0);
      for (int tick = 0; tick < kSettling; ++tick) {
        wait();
        twin_.tick();
        tap_.after_tick(twin_);
      }
      for (int tick = 0; tick < ticks; ++tick) {
        wait();
        tick_into(loaded ? loaded_us_ : quiet_us_);
      }
    }
    browsers_.open(0);
    quiet_p99_us_ = p99_us(quiet_us_);
    loaded_p99_us_ = p99_us(loaded_us_);
    std::cout << fmt::format(
        "p99 of a tick: {:.1f} us quiet, {:.1f} us with {} streams, ratio {:.3f}, {} ticks each\n",
        quiet_p99_us_, loaded_p99_us_, kReaders + kSlowReaders, loaded_p99_us_ / quiet_p99_us_,
        quiet_us_.size());
  }

  Browsers browsers_;  // first: it forks
  Scene scene_;
  robot::Monitor monitor_;
  MappingTwin twin_;
  TwinTap tap_;
  std::uint16_t port_{0};
  std::vector<double> quiet_us_;
  std::vector<double> loaded_us_;
  double quiet_p99_us_{0.0};
  double loaded_p99_us_{0.0};
};

// The bound: 10 %.
constexpr double kMost = 1.10;

TEST_F(LoopTime, AHundredStreamsDoNotSlowALoopThatKeepsRealTime) {
  Clock::time_point due = Clock::now();
  measure(6, 500, [&] {
    due = std::max(due + robot::kTick, Clock::now());
    std::this_thread::sleep_until(due);
  });
  EXPECT_LE(loaded_p99_us_, kMost * quiet_p99_us_);
}

TEST_F(LoopTime, AHundredStreamsDoNotSlowALoopThatRunsAsFastAsItCan) {
  measure(10, 8000, [] {});
  EXPECT_LE(loaded_p99_us_, kMost * quiet_p99_us_);
}

}  // namespace
}  // namespace sensotwin::twin
