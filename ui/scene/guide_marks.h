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

/// How a guide is to be seen.
struct GuideMark {
    Guide guide; ///< its curve outlives the mark's show
    QString label;
    bool holds = false;   ///< the hand, now
    int level = 0;        ///< of level guides: that holds the hand, or is nearest to it
    glm::dvec3 axis{0.0}; ///< lead and tilt: where the guide would have the tool's axis; zero: not known

    friend bool operator==(const GuideMark&, const GuideMark&) = default;
};

/// All guides of the hand that are on, and what they are clipped to and drawn by.
struct GuideMarks {
    std::vector<GuideMark> guides;
    Box room;                                                ///< mm, setup frame: planes and lines end at it
    Box tips;                                                ///< mm, setup frame: surfaces end at it
    std::shared_ptr<const ClearanceField> field;             ///< of the tool; null: no surface is drawn
    std::shared_ptr<const std::vector<glm::dvec3>> lastPass; ///< mm; null: there is none

    friend bool operator==(const GuideMarks& one, const GuideMarks& other) {
        return one.guides == other.guides && one.room.low == other.room.low && one.room.high == other.room.high &&
               one.tips.low == other.tips.low && one.tips.high == other.tips.high && one.field == other.field &&
               one.lastPass == other.lastPass;
    }
};

} // namespace burin
