// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/line_frame.h"
#include "core/cutting/solid_contact.h"
#include "core/verify/row_replay.h"

#include <optional>

namespace burin {

/// @param from, to line frame
void RowReplay::cutSolid(const SolidColumns& solid, const glm::dvec3& from, const glm::dvec3& to, UnitSum& removed) {
    std::int32_t brick = -1; // the last one that was cut and whose upper limit is not up to date
    std::optional<SolidStay> before;
    SolidTrack track(solid, grid_, inSetupFrame(grid_, from), inSetupFrame(grid_, to));
    while (const std::optional<SolidStay> stay = track.next()) {
        solid.forEachSpan(SolidColumns::Section::flutes, grid_, *stay, before ? &*before : nullptr, rows(),
                          [&](LineIndex line, RunPosition low, RunPosition high) {
                              const std::uint64_t units = removed.units;
                              take(line, low, high, removed);
                              if (removed.units == units || line.u / brickSide == brick) return true;
                              if (brick >= 0) stock_.settle(brick);
                              brick = line.u / brickSide;
                              return true;
                          });
        before = stay;
    }
    if (brick >= 0) stock_.settle(brick);
}

bool RowReplay::shankTouches(const SolidColumns& solid, const glm::dvec3& from, const glm::dvec3& to) const {
    bool found = false;
    UnitSum sum;
    std::optional<SolidStay> before;
    SolidTrack track(solid, grid_, inSetupFrame(grid_, from), inSetupFrame(grid_, to));
    while (const std::optional<SolidStay> stay = found ? std::nullopt : track.next()) {
        solid.forEachSpan(SolidColumns::Section::shank, grid_, *stay, before ? &*before : nullptr, rows(),
                          [&](LineIndex line, RunPosition low, RunPosition high) {
                              if (static_cast<std::int32_t>(low) < stock_.brickReach(line.u / brickSide))
                                  found = stock_.overlap(line, low, high, sum) > solidContactTolerance;
                              return !found;
                          });
        before = stay;
    }
    return found;
}

void RowReplay::lookAtShank(const ReplayTool& tool, const glm::dvec3& tip, std::uint32_t number, std::uint32_t step) {
    const std::optional<SolidStay> stay = SolidTrack::at(*tool.solid, grid_, inSetupFrame(grid_, tip));
    if (!stay) return;
    UnitSum touched;
    tool.solid->forEachSpan(SolidColumns::Section::shank, grid_, *stay, nullptr, rows(),
                            [&](LineIndex line, RunPosition from, RunPosition to) {
                                UnitSum here;
                                if (stock_.overlap(line, from, to, here) > solidContactTolerance) touched.add(here);
                                return true;
                            });
    if (touched.units > 0)
        result_.contacts.push_back({number, step, static_cast<std::uint32_t>(tool.fluteCount), touched});
}

} // namespace burin
