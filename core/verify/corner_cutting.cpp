// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/corner_cutting.h"

#include "core/path/polyline.h"
#include "core/verify/gouge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

namespace burin {

namespace {

constexpr double sameCorner = 1e-6; // mm
constexpr ClearanceTolerance cornerAnswers{1e-3, 0.0, 1e-6};
constexpr double towardsPart = 0.2; // mm: pushed on by this much, a tool meets a part that is there

/// A corner and the parabola that cuts it, tangent to both blocks.
struct Cut {
    glm::dvec3 from{0.0}, corner{0.0}, to{0.0};
    glm::dvec3 axis{uprightAxis}; ///< of the tool at the corner

    glm::dvec3 at(double share) const noexcept {
        return glm::mix(glm::mix(from, corner, share), glm::mix(corner, to, share), share);
    }
};

/// Moves that are one block to the control: chords of an arc, or lines that it merges into one (LinuxCNC's "naive cam
/// detector").
struct ControlBlock {
    std::size_t first = 0, last = 0; ///< moves
    bool merged = false;
};

/// Finds the corners, one after the other, and judges each against the part.
class CornerJudge {
public:
    CornerJudge(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request)
        : moves_(moves), request_(request), motions_(request.program->motions) {
        for (const Tool& tool : tools) stacks_.push_back(pieces(tool.cutter));
        for (const auto& stack : stacks_) parts_.push_back(std::make_unique<ClearanceAsker>(*request.part, stack));
    }

    Result<void> run(const Progress& progress) {
        if (std::ranges::none_of(motions_, [&](const NcMotion& motion) { return leavesPath(motion); })) return {};
        auto setting = request_.program->settings.begin();
        const auto end = request_.program->settings.end();
        ControlBlock before = blockFrom(0);
        while (before.last < moves_.size()) {
            if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
            for (; setting != end && setting->motions <= moves_[before.last].motion; ++setting)
                if (setting->kind == NcSettingKind::pathControl) line_ = setting->line;
            if (before.merged) judgeMerged(before);
            if (before.last + 1 == moves_.size()) break;
            const ControlBlock behind = blockFrom(before.last + 1);
            if (const std::optional<Cut> cut = cutBetween(before, behind)) judge(moves_[before.last].tool, *cut);
            before = behind;
        }
        return {};
    }
    void conclude(Findings& findings) const {
        for (const auto& [key, finding] : found_) findings.add(finding);
    }

private:
    bool leavesPath(const NcMotion& motion) const noexcept {
        return motion.pathMode == PathMode::blend &&
               (!(motion.blendTolerance > 0.0) || motion.blendTolerance > request_.gougeTolerance || merges(motion));
    }
    bool merges(const NcMotion& motion) const noexcept {
        return motion.pathMode == PathMode::blend && motion.kind == NcMotionKind::line &&
               motion.mergeTolerance > request_.gougeTolerance;
    }
    /// Whether a move continues from the one before it without a stop.
    bool follows(std::size_t i) const noexcept {
        const ToolMove &before = moves_[i - 1], &behind = moves_[i];
        return before.tool == behind.tool && before.startKnown && before.endKnown && behind.startKnown &&
               behind.endKnown && behind.motion <= before.motion + 1 &&
               glm::distance(before.to.tip, behind.from.tip) <= sameCorner;
    }

    /// Lines of the same feed are merged as long as all ends between them stay within the tolerance of the line that
    /// replaces them (`linkable` of LinuxCNC's emccanon.cc).
    ControlBlock blockFrom(std::size_t first) const {
        constexpr std::size_t most = 100;
        ControlBlock block{first, first, false};
        if (first >= moves_.size()) return block;
        const NcMotion& motion = motions_[moves_[first].motion];
        const auto extends = [&](std::size_t next) {
            if (!follows(next)) return false;
            if (moves_[next].motion == moves_[first].motion) return true; // an arc, or a rapid with corners
            const NcMotion& other = motions_[moves_[next].motion];
            return merges(motion) && merges(other) && keepsAxis(first, next) && other.feed == motion.feed &&
                   other.mergeTolerance == motion.mergeTolerance && next - first < most &&
                   farthest({first, next, true}) <= motion.mergeTolerance;
        };
        while (block.last + 1 < moves_.size() && extends(block.last + 1)) ++block.last;
        block.merged = moves_[block.last].motion != moves_[first].motion;
        return block;
    }
    /// Lines are not merged where a rotary axis turns (`see_segment` of LinuxCNC's emccanon.cc).
    bool keepsAxis(std::size_t first, std::size_t next) const noexcept {
        const glm::dvec3& axis = moves_[first].to.axis;
        return moves_[first].from.axis == axis && moves_[next].from.axis == axis && moves_[next].to.axis == axis;
    }
    /// The largest distance of the inner ends from the line that replaces a block, mm.
    double farthest(const ControlBlock& block) const {
        double most = 0.0;
        for (std::size_t i = block.first; i < block.last; ++i)
            most = std::max(most, glm::distance(moves_[i].to.tip, onLine(block, moves_[i].to.tip)));
        return most;
    }
    glm::dvec3 onLine(const ControlBlock& block, const glm::dvec3& place) const {
        return nearestOnSegment(place, moves_[block.first].from.tip, moves_[block.last].to.tip);
    }
    double lengthOfBlock(const ControlBlock& block) const {
        return block.merged ? glm::distance(moves_[block.first].from.tip, moves_[block.last].to.tip)
                            : lengthOf(motions_[moves_[block.first].motion]);
    }

    /// The cut of the corner between two blocks; empty where the control follows the path exactly, or nearly so.
    std::optional<Cut> cutBetween(const ControlBlock& before, const ControlBlock& behind) const {
        const NcMotion& motion = motions_[moves_[before.last].motion];
        if (motion.pathMode != PathMode::blend || !follows(behind.first)) return std::nullopt;
        const double tolerance =
            motion.blendTolerance > 0.0 ? motion.blendTolerance : std::numeric_limits<double>::infinity();
        if (tolerance <= request_.gougeTolerance) return std::nullopt;
        const glm::dvec3& corner = moves_[before.last].to.tip;
        const glm::dvec3 in = corner - pointBefore(before, sameCorner), out = pointBehind(behind, sameCorner) - corner;
        if (!(glm::length(in) > 0.0) || !(glm::length(out) > 0.0)) return std::nullopt;
        const double half = 0.5 * glm::length(glm::normalize(out) - glm::normalize(in));
        const double blocks = 0.5 * std::min(lengthOfBlock(before), lengthOfBlock(behind));
        const double leg = std::min(2.0 * tolerance / half, blocks);
        if (!(0.5 * half * leg > request_.gougeTolerance)) return std::nullopt;
        return Cut{pointBefore(before, leg), corner, pointBehind(behind, leg), moves_[before.last].to.axis};
    }
    /// The point at a distance before the end of a block, or after its start.
    glm::dvec3 pointBefore(const ControlBlock& block, double way) const {
        if (block.merged) return along(moves_[block.last].to.tip, moves_[block.first].from.tip, way);
        for (std::size_t i = block.last;; --i) {
            const double length = glm::distance(moves_[i].from.tip, moves_[i].to.tip);
            if (way <= length || i == block.first) return along(moves_[i].to.tip, moves_[i].from.tip, way);
            way -= length;
        }
    }
    glm::dvec3 pointBehind(const ControlBlock& block, double way) const {
        if (block.merged) return along(moves_[block.first].from.tip, moves_[block.last].to.tip, way);
        for (std::size_t i = block.first;; ++i) {
            const double length = glm::distance(moves_[i].from.tip, moves_[i].to.tip);
            if (way <= length || i == block.last) return along(moves_[i].from.tip, moves_[i].to.tip, way);
            way -= length;
        }
    }
    static glm::dvec3 along(const glm::dvec3& from, const glm::dvec3& to, double way) noexcept {
        const double length = glm::distance(from, to);
        return length > 0.0 ? glm::mix(from, to, std::min(1.0, way / length)) : to;
    }

    /// Judges the line that replaces others, and the ends that it leaves out.
    void judgeMerged(const ControlBlock& block) {
        if (farthest(block) <= request_.gougeTolerance) return;
        ClearanceAsker& part = *parts_[moves_[block.first].tool];
        const glm::dvec3 &from = moves_[block.first].from.tip, &to = moves_[block.last].to.tip;
        const glm::dvec3& axis = moves_[block.first].to.axis;
        judgeGouge(part, glm::distance(from, to), axis, [&](double share) { return glm::mix(from, to, share); });
        for (std::size_t i = block.first; i < block.last; ++i)
            judgeExcess(part, moves_[i].to, onLine(block, moves_[i].to.tip));
    }

    /// @param length approximate length, mm, of the path that `at` describes from 0 to 1
    template <class Way>
    void judgeGouge(ClearanceAsker& part, double length, const glm::dvec3& axis, const Way& at) {
        const auto steps = static_cast<int>(std::ceil(length / request_.sampling)) + 4;
        ToolClearance deepest;
        deepest.clearance = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= steps; ++i) {
            const ToolClearance here = part.ask(ToolPose{at(static_cast<double>(i) / steps), axis}, 0.5, cornerAnswers);
            if (here.clearance < deepest.clearance) deepest = here;
        }
        if (-deepest.clearance > request_.gougeTolerance)
            add(FindingKind::cornerGouge, deepest.meshPoint, -deepest.clearance);
    }

    /// Stock stays on the side of a point that the tool no longer reaches; it matters if the part is behind it.
    void judgeExcess(ClearanceAsker& part, const ToolPose& pose, const glm::dvec3& instead) {
        const glm::dvec3& place = pose.tip;
        const double leaves = glm::distance(place, instead);
        if (!(request_.excessTolerance > 0.0) || leaves <= request_.excessTolerance) return;
        const double reach = leaves + towardsPart + onPartDistance;
        const ToolClearance there = part.ask(pose, reach, cornerAnswers);
        if (there.clearance > onPartDistance) return;
        const glm::dvec3 outward = (place - instead) / leaves;
        const ToolClearance on = part.ask(ToolPose{place + towardsPart * outward, pose.axis}, reach, cornerAnswers);
        if (on.clearance < there.clearance - 0.5 * towardsPart) add(FindingKind::cornerExcess, place, leaves);
    }

    void judge(std::uint16_t tool, const Cut& cut) {
        ClearanceAsker& part = *parts_[tool];
        judgeGouge(part, glm::distance(cut.from, cut.to), cut.axis, [&](double share) { return cut.at(share); });
        judgeExcess(part, {cut.corner, cut.axis}, cut.at(0.5));
    }

    void add(FindingKind kind, const glm::dvec3& place, double amount) {
        const auto [entry, isNew] = found_.try_emplace({line_, kind}, Finding{kind, line_, place, amount});
        if (isNew) return;
        const std::uint32_t count = entry->second.count + 1;
        if (amount > entry->second.amount) entry->second = Finding{kind, line_, place, amount};
        entry->second.count = count;
    }

    const std::vector<ToolMove>& moves_;
    const VerifyRequest& request_;
    const std::vector<NcMotion>& motions_;
    std::vector<std::vector<RevolvedPiece>> stacks_;     ///< by tool
    std::vector<std::unique_ptr<ClearanceAsker>> parts_; ///< the same
    std::uint32_t line_ = 1;                             ///< of the G64 in force
    std::map<std::pair<std::uint32_t, FindingKind>, Finding> found_;
};

} // namespace

Result<void> judgeCorners(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request,
                          Findings& findings, const Progress& progress) {
    CornerJudge judge(moves, tools, request);
    if (Result<void> done = judge.run(progress); !done) return done;
    judge.conclude(findings);
    return {};
}

} // namespace burin
