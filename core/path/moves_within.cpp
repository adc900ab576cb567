// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/moves_within.h"

#include "core/path/hand_interval.h"

#include <optional>

namespace burin {
namespace {

/// Whether a move belongs to a link or leads into a stroke, so that it gets the values of a cut.
bool goesWithCut(const PathPoint& point) noexcept {
    return point.kind == MoveKind::plunge || !hasMoment(point);
}

} // namespace

std::vector<bool> movesWithin(const std::vector<PathPoint>& points, const SourceInterval& interval) {
    std::vector<bool> within(points.size(), false), decided(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i)
        within[i] = interval.contains(momentOf(points[i])) &&
                    (i == 0 || !hasMoment(points[i - 1]) || interval.contains(momentOf(points[i - 1])));
    std::optional<bool> other; // whether the nearest cut is within: the next, then the previous, up to a rapid
    for (std::size_t i = points.size(); i-- > 0;) {
        if (points[i].kind == MoveKind::rapid) {
            other.reset();
        } else if (!goesWithCut(points[i])) {
            other = within[i];
        } else if (other) {
            within[i] = *other;
            decided[i] = true;
        }
    }
    other.reset();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].kind == MoveKind::rapid) {
            other.reset();
            continue;
        }
        if (other && !hasMoment(points[i]) && !decided[i]) within[i] = *other;
        other = within[i];
    }
    return within;
}

} // namespace burin
