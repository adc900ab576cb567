// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/geometry/box.h"
#include "core/setup/guide.h"

#include <QString>

#include <memory>
#include <vector>

namespace burin {

/// How a guide is drawn.
struct GuideMark {
    Guide guide; ///< its curve must exist as long as the mark is shown
    QString label;
    bool holds = false;   ///< whether it currently constrains the hand
    int level = 0;        ///< for guides with levels: the level that constrains the hand, or is nearest to it
    glm::dvec3 axis{0.0}; ///< for lead and tilt: the tool axis that the guide requests; zero: not known

    friend bool operator==(const GuideMark&, const GuideMark&) = default;
};

/// All guides that are on, the boxes that clip them, and the data that is needed to draw them.
struct GuideMarks {
    std::vector<GuideMark> guides;
    Box room;                                                ///< mm, setup frame: planes and lines end at it
    Box tips;                                                ///< mm, setup frame: surfaces end at it
    std::shared_ptr<const ClearanceField> field;             ///< for the tool; null: no surface is drawn
    std::shared_ptr<const std::vector<glm::dvec3>> lastPass; ///< mm; null: none

    friend bool operator==(const GuideMarks& one, const GuideMarks& other) {
        return one.guides == other.guides && one.room.low == other.room.low && one.room.high == other.room.high &&
               one.tips.low == other.tips.low && one.tips.high == other.tips.high && one.field == other.field &&
               one.lastPass == other.lastPass;
    }
};

} // namespace burin
