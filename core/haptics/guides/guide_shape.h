// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/guides/last_pass.h"
#include "core/haptics/guides/polyline_tracker.h"
#include "core/setup/guide.h"

namespace burin {

/// What guides depend on besides their own parameters.
struct GuideSurroundings {
    const ClearanceField& field; ///< of the tool
    const LastPass& lastPass;
};

/// The nearest point of a guide to the hand.
struct GuideFoot {
    bool known = false;
    glm::dvec3 point{0.0};
    double distance = 0.0; ///< mm, from the hand
};

/// A guide linearised near a point: up to two planes, with perpendicular unit normals, on which a tip on the guide
/// lies: dot(normal, tip) = offset.
struct GuideRows {
    struct Row {
        glm::dvec3 normal{0.0};
        double offset = 0.0; ///< mm
    };
    std::array<Row, 2> rows{};
    int count = 0;

    void add(const glm::dvec3& normal, const glm::dvec3& point) noexcept {
        rows[static_cast<std::size_t>(count++)] = {normal, glm::dot(normal, point)};
    }
    const Row* begin() const noexcept { return rows.data(); }
    const Row* end() const noexcept { return rows.data() + count; }
};

/// The geometry of one guide, with the state kept from tick to tick: its level, its side, its nearest point (foot).
/// Called in the haptic tick.
class GuideShape {
public:
    /// Replaces the guide, starting at its level 0; no state of the previous guide is kept.
    void set(const Guide& guide) noexcept;
    const Guide& guide() const noexcept { return guide_; }
    bool curved() const noexcept {
        return guide_.kind == GuideKind::curve || guide_.kind == GuideKind::surface ||
               guide_.kind == GuideKind::stepOver;
    }

    /// The nearest point of the guide. @param held whether the level, side, branch and the neighbourhood of the
    /// previous foot are kept; otherwise the nearest point of all is taken. @param moved mm that the hand has moved
    /// since the last call
    GuideFoot foot(const GuideSurroundings& around, const glm::dvec3& hand, bool held, double moved) noexcept;
    /// The guide linearised at its foot, as seen from the hand: the first normal points to the hand.
    GuideRows atFoot(const GuideSurroundings& around, const glm::dvec3& hand) const noexcept;
    /// The guide linearised at another point near its foot. Empty if that is not possible there.
    GuideRows near(const GuideSurroundings& around, const glm::dvec3& place) const noexcept;

    /// Distance between neighbours, mm, for guides with several levels or passes, which divide the space between them.
    /// 0: a single guide.
    double spacing() const noexcept;
    int level() const noexcept { return level_; }
    void setLevel(int level) noexcept { level_ = level; }

private:
    GuideFoot planeFoot(const glm::dvec3& hand, bool held) noexcept;
    GuideFoot surfaceFoot(const GuideSurroundings& around, const glm::dvec3& hand, bool held) const noexcept;
    GuideFoot surfaceFromOutside(const ClearanceField& field, const glm::dvec3& hand,
                                 const glm::dvec3& start) const noexcept;
    GuideFoot passFoot(const LastPass& lastPass, const glm::dvec3& hand, bool held, double moved) noexcept;
    GuideRows curveRows(const PolylineFoot& foot, const glm::dvec3& place) const noexcept;
    GuideRows passRow(const Polyline& pass, const PolylineFoot& foot, const glm::dvec3& place) const noexcept;
    glm::dvec3 across(const glm::dvec3& place) const noexcept; ///< component perpendicular to `direction`
    double offsetOfPlane() const noexcept;
    Polyline curve() const noexcept;

    Guide guide_;
    PolylineTracker tracker_;
    GuideFoot foot_;
    int level_ = 0;
    double side_ = 0.0;        ///< of the last pass: +1 left of it, seen against `direction`; 0: not known yet
    std::uint32_t passes_ = 0; ///< number of passes known when the side was determined
};

} // namespace burin
