// SPDX-License-Identifier: MIT
#include "world/radio/report_queue.hpp"

#include <algorithm>

namespace sensotwin::world {

ReportQueue::ReportQueue(const RadioDescription& radio)
    : every_(static_cast<std::size_t>(std::max(1, radio.report_every))),
      accumulate_(radio.accumulate_reads),
      latency_s_(radio.report_latency_s) {}

void ReportQueue::push(const RadioRead& read) {
  const auto known = accumulate_ ? std::find_if(open_.begin(), open_.end(),
                                                [&](const RadioRead& row) {
                                                  return row.tag == read.tag && row.antenna == read.antenna;
                                                })
                                 : open_.end();
  if (known == open_.end()) {
    open_.push_back(read);
  } else {
    const std::uint16_t first_channel = known->channel;
    *known = read;
    known->channel = first_channel;
  }
  if (++reads_ < every_) {
    return;
  }
  for (const RadioRead& row : open_) {
    sent_.push_back({row, read.time_s + latency_s_});
  }
  open_.clear();
  reads_ = 0;
}

void ReportQueue::take_arrived(double now_s, std::vector<RadioRead>& into) {
  std::size_t arrived = 0;
  while (arrived < sent_.size() && sent_[arrived].arrives_s <= now_s) {
    into.push_back(sent_[arrived++].read);
  }
  sent_.erase(sent_.begin(), sent_.begin() + static_cast<std::ptrdiff_t>(arrived));
}

}  // namespace sensotwin::world
