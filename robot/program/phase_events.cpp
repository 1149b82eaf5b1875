// SPDX-License-Identifier: MIT
#include "robot/program/phase_events.hpp"

namespace sensotwin::robot {
namespace {

std::string_view name_of(FuzzyEventKind kind) {
  switch (kind) {
    case FuzzyEventKind::kLegBegun:
      return "leg_begun";
    case FuzzyEventKind::kDestinationHeard:
      return "tag_heard";
    case FuzzyEventKind::kArrived:
      return "tag_reached";
    case FuzzyEventKind::kDestinationSilent:
      return "tag_silent";
    case FuzzyEventKind::kHeardAgain:
      return "tag_heard_again";
    case FuzzyEventKind::kReaderDown:
      return "reader_down";
    case FuzzyEventKind::kReaderUp:
      return "reader_up";
    case FuzzyEventKind::kGivenUp:
      return "given_up";
    case FuzzyEventKind::kLegTooLong:
      return "leg_too_long";
    case FuzzyEventKind::kBumped:
      return "bumped";
    case FuzzyEventKind::kDone:
      break;
  }
  return "arrived";
}

std::string_view name_of(CeilingEventKind kind) {
  switch (kind) {
    case CeilingEventKind::kTagFound:
      return "tag_found";
    case CeilingEventKind::kTagReached:
      return "tag_reached";
    case CeilingEventKind::kTagMissing:
      return "tag_missing";
    case CeilingEventKind::kTagSilent:
      return "tag_silent";
    case CeilingEventKind::kTagSkipped:
      return "tag_skipped";
    case CeilingEventKind::kTagLost:
      return "tag_lost";
    case CeilingEventKind::kTagMoved:
      return "tag_moved";
    case CeilingEventKind::kOrderDoubtful:
      return "order_doubtful";
    case CeilingEventKind::kOrderExchanged:
      return "order_exchanged";
    case CeilingEventKind::kReaderSilent:
      return "reader_silent";
    case CeilingEventKind::kReaderBack:
      return "reader_back";
    case CeilingEventKind::kCablesSwapped:
      return "cables_swapped";
    case CeilingEventKind::kCablesDoubted:
      return "cables_doubted";
    case CeilingEventKind::kBump:
      return "bumped";
    case CeilingEventKind::kSearching:
      return "searching";
    case CeilingEventKind::kOffPath:
      return "off_path";
    case CeilingEventKind::kStopped:
      return "stopped";
    case CeilingEventKind::kArrived:
      break;
  }
  return "arrived";
}

}  // namespace

PhaseEvent event_of(const FuzzyEvent& event) {
  return {event.stamp, name_of(event.kind), words(event.kind), event.destination, 0.0};
}

PhaseEvent event_of(const CeilingEvent& event) {
  return {event.stamp, name_of(event.kind), say(event.kind), event.tag, event.value};
}

}  // namespace sensotwin::robot
