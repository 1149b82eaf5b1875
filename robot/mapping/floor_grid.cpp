// SPDX-License-Identifier: MIT
#include "robot/mapping/floor_grid.hpp"

#include <algorithm>
#include <cmath>

namespace sensotwin::robot {
namespace {

/// Bits of a cell: four of evidence, then flags.
constexpr std::uint8_t kEvidenceMask = 0x0F;
constexpr std::uint8_t kForbidden = 0x10;
constexpr std::uint8_t kSwept = 0x20;
constexpr std::uint8_t kTrodden = 0x40;
constexpr std::uint8_t kSeenWell = 0x80;
/// A hit counts twice, a beam that went through once: a leg is seen by few of the beams that pass near it.
/// Two hits are needed, so that one stray reading moves nothing.
constexpr int kHitWeight = 2;
constexpr std::uint8_t kEvidenceNeeded = 4;
/// As much as hits from a place known badly add up to: believed, and just so.
constexpr int kDoubtfulEvidence = 5;

}  // namespace

const std::uint8_t* FloorGrid::find(Cell c) const {
  const std::pair key{c.x >> kChunkBits, c.y >> kChunkBits};
  if (last_chunk_ == nullptr || key != last_key_) {
    const auto found = chunks_.find(key);
    if (found == chunks_.end()) {
      return nullptr;
    }
    last_key_ = key;
    last_chunk_ = found->second.get();
  }
  const int index = ((c.y & (kChunkSide - 1)) << kChunkBits) | (c.x & (kChunkSide - 1));
  return &last_chunk_->cells[static_cast<std::size_t>(index)];
}

std::uint8_t& FloorGrid::at(Cell c) {
  if (const std::uint8_t* known = find(c)) {
    return const_cast<std::uint8_t&>(*known);
  }
  const std::pair key{c.x >> kChunkBits, c.y >> kChunkBits};
  last_key_ = key;
  last_chunk_ = chunks_.emplace(key, std::make_unique<Chunk>()).first->second.get();
  return const_cast<std::uint8_t&>(*find(c));
}

void FloorGrid::add_hit(const Vec2& p_M_m, Seen seen) {
  std::uint8_t& cell = at(cell_at(p_M_m));
  const auto evidence = static_cast<std::uint8_t>(cell & kEvidenceMask);
  const int most = std::max<int>(evidence, seen == Seen::kFromKnownPlace ? kEvidenceMask : kDoubtfulEvidence);
  const auto more = static_cast<std::uint8_t>(std::min<int>(evidence + kHitWeight, most));
  const std::uint8_t well = seen == Seen::kFromKnownPlace ? kSeenWell : 0;
  cell = static_cast<std::uint8_t>((cell & ~kEvidenceMask) | more | well);
  if (evidence < kEvidenceNeeded && more >= kEvidenceNeeded) {
    ++revision_;
  }
}

void FloorGrid::see_through(const Vec2& from_M_m, const Vec2& to_M_m) {
  const Vec2 way = to_M_m - from_M_m;
  const int steps = static_cast<int>(way.norm() / kCell_m);
  for (int i = 0; i < steps; ++i) {
    const Cell c = cell_at(from_M_m + way * ((i + 0.5) / steps));
    const std::uint8_t* known = find(c);
    if (known != nullptr && (*known & kEvidenceMask) != 0) {
      std::uint8_t& cell = at(c);
      --cell;
      if ((cell & kEvidenceMask) == 0) {
        cell &= static_cast<std::uint8_t>(~kSeenWell);
      }
      ++revision_;
    }
  }
}

void FloorGrid::forbid_centre(const Vec2& p_M_m) {
  std::uint8_t& cell = at(cell_at(p_M_m));
  if ((cell & kForbidden) == 0) {
    cell |= kForbidden;
    ++revision_;
  }
}

void FloorGrid::forget_doubtful(const Vec2& round_M_m, double radius_m) {
  const Cell low = cell_at(round_M_m - Vec2{radius_m, radius_m});
  const Cell high = cell_at(round_M_m + Vec2{radius_m, radius_m});
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const std::uint8_t* known = find({x, y});
      if (known == nullptr || (centre_m({x, y}) - round_M_m).norm() > radius_m) {
        continue;
      }
      const bool doubtful = (*known & kSeenWell) == 0;
      at({x, y}) &= static_cast<std::uint8_t>(~(kForbidden | (doubtful ? kEvidenceMask : 0)));
      ++revision_;
    }
  }
}

void FloorGrid::clear_disc(const Vec2& centre_M_m, double radius_m) {
  const Cell low = cell_at(centre_M_m - Vec2{radius_m, radius_m});
  const Cell high = cell_at(centre_M_m + Vec2{radius_m, radius_m});
  const auto inside = [&](Cell c) { return (centre_m(c) - centre_M_m).squaredNorm() <= radius_m * radius_m; };
  for (int y = low.y; y <= high.y; ++y) {
    int first = low.x;
    int last = high.x;
    while (first <= last && !inside({first, y})) {
      ++first;
    }
    while (last > first && !inside({last, y})) {
      --last;
    }
    // A row of the disc lies side by side in one chunk or two.
    while (first <= last) {
      const int end = std::min(last, first | (kChunkSide - 1));
      std::uint8_t* const row = &at({first, y});
      for (int i = 0; i <= end - first; ++i) {
        row[i] = static_cast<std::uint8_t>((row[i] & (kForbidden | kTrodden)) | kSwept);
      }
      first = end + 1;
    }
  }
  at(cell_at(centre_M_m)) &= static_cast<std::uint8_t>(~kForbidden);
}

bool FloorGrid::occupied(Cell c) const {
  const std::uint8_t* cell = find(c);
  return cell != nullptr && (*cell & kEvidenceMask) >= kEvidenceNeeded;
}

bool FloorGrid::centre_forbidden(Cell c) const {
  const std::uint8_t* cell = find(c);
  return cell != nullptr && (*cell & kForbidden) != 0;
}

bool FloorGrid::trodden(Cell c) const {
  const std::uint8_t* cell = find(c);
  return cell != nullptr && (*cell & kTrodden) != 0;
}

void FloorGrid::tread(const Vec2& centre_M_m) {
  at(cell_at(centre_M_m)) |= kTrodden;
}

bool FloorGrid::swept(Cell c) const {
  const std::uint8_t* cell = find(c);
  return cell != nullptr && (*cell & kSwept) != 0;
}

bool FloorGrid::blocks(const Vec2& from_M_m, const Vec2& to_M_m, double clearance_m) const {
  const Vec2 along = to_M_m - from_M_m;
  const double length2 = std::max(along.squaredNorm(), 1e-12);
  const Vec2 margin{clearance_m, clearance_m};
  const Cell low = cell_at(from_M_m.cwiseMin(to_M_m) - margin);
  const Cell high = cell_at(from_M_m.cwiseMax(to_M_m) + margin);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      if (!occupied({x, y})) {
        continue;
      }
      const Vec2 p = centre_m({x, y});
      const double t = std::clamp((p - from_M_m).dot(along) / length2, 0.0, 1.0);
      if ((p - from_M_m - t * along).squaredNorm() < clearance_m * clearance_m) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace sensotwin::robot
