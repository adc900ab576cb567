// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/corner_cutting.h"

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
constexpr double towardsPart = 0.2; // mm: a tool pushed on by so much meets a part that is there

/// A corner and the parabola that cuts it: tangent to both blocks.
struct Cut {
    glm::dvec3 from{0.0}, corner{0.0}, to{0.0};

    glm::dvec3 at(double share) const noexcept {
        return glm::mix(glm::mix(from, corner, share), glm::mix(corner, to, share), share);
    }
    double leaves() const noexcept { return glm::distance(at(0.5), corner); } ///< mm, at most
};

/// Finds the corners, one after the other, and asks the part about each.
class CornerJudge {
public:
    CornerJudge(const std::vector<ToolMove>& moves, std::span<const Tool> tools, const VerifyRequest& request)
        : moves_(moves), request_(request), motions_(request.program->motions) {
        for (const Tool& tool : tools) stacks_.push_back(pieces(tool.cutter));
        for (const auto& stack : stacks_) parts_.push_back(std::make_unique<ClearanceAsker>(*request.part, stack));
    }

    Result<void> run(const Progress& progress) {
        auto setting = request_.program->settings.begin();
        const auto end = request_.program->settings.end();
        for (std::size_t i = 0; i + 1 < moves_.size(); ++i) {
            if (i % 1024 == 0 && progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
            for (; setting != end && setting->motions <= moves_[i].motion; ++setting)
                if (setting->kind == NcSettingKind::pathControl) line_ = setting->line;
            if (const std::optional<Cut> cut = cutAt(i)) judge(moves_[i].tool, *cut);
        }
        return {};
    }
    void conclude(Findings& findings) const {
        for (const auto& [key, finding] : found_) findings.add(finding);
    }

private:
    /// Of the corner behind a move; nothing where the control goes exactly, or as good as that.
    std::optional<Cut> cutAt(std::size_t i) const {
        const ToolMove &before = moves_[i], &behind = moves_[i + 1];
        const NcMotion& motion = motions_[before.motion];
        if (motion.pathMode != PathMode::blend || before.motion == behind.motion || before.tool != behind.tool)
            return std::nullopt;
        const bool known = before.startKnown && before.endKnown && behind.startKnown && behind.endKnown;
        if (!known || behind.motion != before.motion + 1 || glm::distance(before.to, behind.from) > sameCorner)
            return std::nullopt;
        const double tolerance =
            motion.blendTolerance > 0.0 ? motion.blendTolerance : std::numeric_limits<double>::infinity();
        if (tolerance <= request_.gougeTolerance) return std::nullopt;
        const glm::dvec3 in = before.to - before.from, out = behind.to - behind.from;
        if (glm::length(in) < sameCorner || glm::length(out) < sameCorner) return std::nullopt;
        const double half = 0.5 * glm::length(glm::normalize(out) - glm::normalize(in));
        const double blocks = 0.5 * std::min(lengthOf(motion), lengthOf(motions_[behind.motion]));
        const double leg = std::min(2.0 * tolerance / half, blocks);
        if (!(0.5 * half * leg > request_.gougeTolerance)) return std::nullopt;
        return Cut{pointBefore(i, leg), before.to, pointBehind(i + 1, leg)};
    }
    /// Where the way is so far before the end of a move, or behind the start of one; within its motion.
    glm::dvec3 pointBefore(std::size_t i, double way) const {
        const std::uint32_t motion = moves_[i].motion;
        for (;; --i) {
            const double length = glm::distance(moves_[i].from, moves_[i].to);
            if (way <= length) return glm::mix(moves_[i].to, moves_[i].from, way / length);
            way -= length;
            if (i == 0 || moves_[i - 1].motion != motion) return moves_[i].from;
        }
    }
    glm::dvec3 pointBehind(std::size_t i, double way) const {
        const std::uint32_t motion = moves_[i].motion;
        for (;; ++i) {
            const double length = glm::distance(moves_[i].from, moves_[i].to);
            if (way <= length) return glm::mix(moves_[i].from, moves_[i].to, way / length);
            way -= length;
            if (i + 1 == moves_.size() || moves_[i + 1].motion != motion) return moves_[i].to;
        }
    }

    void judge(std::uint16_t tool, const Cut& cut) {
        ClearanceAsker& part = *parts_[tool];
        const double leaves = cut.leaves(), reach = leaves + towardsPart + onPartDistance;
        const ToolClearance there = part.ask(cut.corner, reach, cornerAnswers);
        const double chord = glm::distance(cut.from, cut.to);
        const auto steps = static_cast<int>(std::ceil(chord / request_.sampling)) + 4;
        ToolClearance deepest = there;
        deepest.clearance = std::numeric_limits<double>::infinity();
        for (int i = 1; i < steps; ++i) {
            const ToolClearance here = part.ask(cut.at(static_cast<double>(i) / steps), 0.5, cornerAnswers);
            if (here.clearance < deepest.clearance) deepest = here;
        }
        if (-deepest.clearance > request_.gougeTolerance)
            add(FindingKind::cornerGouge, deepest.meshPoint, -deepest.clearance);
        if (!(request_.excessTolerance > 0.0) || leaves <= request_.excessTolerance) return;
        if (there.clearance > onPartDistance) return;
        // Stock stays on the side that the tool no longer comes to: it matters where the part stands behind it.
        const glm::dvec3 outward = glm::normalize(cut.corner - cut.at(0.5));
        const ToolClearance on = part.ask(cut.corner + towardsPart * outward, reach, cornerAnswers);
        if (on.clearance < there.clearance - 0.5 * towardsPart) add(FindingKind::cornerExcess, cut.corner, leaves);
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
