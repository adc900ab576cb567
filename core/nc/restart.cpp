// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/restart.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace burin {

namespace {

constexpr double shortestRest = 0.01; // mm: a shorter remainder of a move is not written

bool isCut(const NcMotion& motion) noexcept {
    return motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc;
}

Error lineError(std::uint32_t line, std::string allowed) {
    return {ErrorCode::argumentInvalid, "restart line", std::to_string(line), std::move(allowed)};
}

/// mm by which the control may deviate from the path, as in NcProgram.
double blendOf(const NcMotion& motion) noexcept {
    switch (motion.pathMode) {
    case PathMode::machine:
        return PostRequest{}.blendTolerance; // for dialects that state it elsewhere
    case PathMode::blend:
        return motion.blendTolerance;
    case PathMode::exactPath:
    case PathMode::exactStop:
        break;
    }
    return 0.0;
}

/// Returns, for each motion, how often the program has stopped the spindle before it.
std::vector<std::size_t> stopsBefore(const ParsedProgram& program) {
    std::vector<std::size_t> stops(program.motions.size(), 0);
    auto setting = program.settings.begin();
    std::size_t count = 0;
    for (std::size_t i = 0; i < stops.size(); ++i) {
        for (; setting != program.settings.end() && setting->motions <= i; ++setting)
            if (setting->kind == NcSettingKind::spindle && setting->value == static_cast<int>(SpindleState::off))
                ++count;
        stops[i] = count;
    }
    return stops;
}

/// The lowest feed at which the tool moves down into material, or `otherwise`.
double plungeFeed(std::span<const NcMotion> motions, int tool, double otherwise) {
    double feed = otherwise;
    for (const NcMotion& motion : motions) {
        if (motion.kind != NcMotionKind::line || motion.tool != tool || !motion.startKnown()) continue;
        const glm::dvec3 way = motion.to.linear() - motion.from.linear();
        if (way.z < 0.0 && -way.z >= glm::length(glm::dvec2(way)) && motion.feed > 0.0)
            feed = std::min(feed, motion.feed);
    }
    return feed;
}

NcMove moveTo(NcMoveKind kind, AxisValues target, double feed = 0.0) {
    NcMove move;
    move.kind = kind;
    move.target = std::move(target);
    move.feed = feed;
    return move;
}

NcMove dwellOf(const NcMotion& motion) {
    NcMove move = moveTo(NcMoveKind::dwell, motion.to);
    move.seconds = motion.seconds;
    return move;
}

/// The point within a motion at which the remainder of a program begins.
struct Begin {
    std::size_t motion = 0;
    double share = 0.0; ///< fraction of the motion that is left out
    double lead = 0.0;  ///< mm of path up to the next cut
};

/// Goes back along the path from the start of a cut, only over cuts of the same tool.
Begin leadBefore(std::span<const NcMotion> motions, std::size_t cut, double lead) {
    Begin begin{cut, 0.0, 0.0};
    for (std::size_t i = cut; i-- > 0 && begin.lead < lead;) {
        const NcMotion& motion = motions[i];
        if (motion.kind == NcMotionKind::dwell) continue;
        if (!isCut(motion) || motion.tool != motions[cut].tool || !motion.spindleOn() || !motion.startKnown()) break;
        const double length = lengthOf(motion), left = lead - begin.lead;
        begin.motion = i;
        if (length > left + shortestRest) {
            begin.share = 1.0 - left / length;
            begin.lead = lead;
            break;
        }
        begin.lead += length;
    }
    return begin;
}

/// After the last motion before a cut that ends at a free height with the same tool; at the first motion of the tool if
/// there is none.
Begin retractBefore(std::span<const NcMotion> motions, std::size_t cut, double freeHeight) {
    std::size_t first = cut;
    for (std::size_t i = cut; i-- > 0;) {
        const NcMotion& motion = motions[i];
        if (motion.tool != motions[cut].tool || !motion.endKnown()) break;
        first = i;
        if (motion.rapid() && motion.to[Axis::z] >= freeHeight) break;
    }
    double lead = 0.0;
    for (std::size_t i = first; i < cut; ++i)
        if (isCut(motions[i])) lead += lengthOf(motions[i]);
    return {first, 0.0, lead};
}

/// Collects the moves of the remainder in sections.
class RestWriter {
public:
    RestWriter(const ParsedProgram& program, const RestartRequest& request, NcProgram& rest)
        : motions_(program.motions), request_(request), rest_(rest), stops_(stopsBefore(program)) {}

    Result<void> write(const Begin& begin, std::size_t cut) {
        findNextCuts();
        for (std::size_t i = begin.motion; i < motions_.size(); ++i) {
            if (i == cut) comment_ = "Line " + std::to_string(motions_[i].line) + " of the interrupted program";
            if (Result<void> added = add(i, i == begin.motion ? begin.share : 0.0); !added) return added;
        }
        return {};
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// By motion, the first cut at or after it.
    void findNextCuts() {
        nextCut_.assign(motions_.size(), none);
        std::size_t next = none;
        for (std::size_t i = motions_.size(); i-- > 0;) {
            if (isCut(motions_[i])) next = i;
            nextCut_[i] = next;
        }
    }

    Result<void> add(std::size_t i, double share) {
        const NcMotion& motion = motions_[i];
        if (!motion.endKnown() && motion.kind != NcMotionKind::dwell) lost_ = true;
        if (!motion.endKnown() || nextCut_[i] == none) return {}; // the dialect's own blocks, which it writes again
        const NcMotion& asCut = motions_[nextCut_[i]];
        if (isCut(motion)) return addCut(i, share);
        if (motion.kind == NcMotionKind::dwell) {
            if (goesOn(nextCut_[i])) push(dwellOf(motion), &asCut);
            return {};
        }
        if (motion.tool != asCut.tool) return {}; // returns from the last cut of a tool, as the end of the section does
        if (!goesOn(nextCut_[i]))
            if (Result<void> begun = beginSection(nextCut_[i]); !begun) return begun;
        push(moveTo(NcMoveKind::rapid, motion.to), &asCut);
        return {};
    }

    /// Whether a cut belongs to the open section. Speed and coolant may change within a section, but a new one begins
    /// if the program stops the spindle to change the coolant, and after a motion to a point that the text does not
    /// state (home): without it, the next rapid would begin at the depth of the last cut.
    bool goesOn(std::size_t cut) const {
        if (open_ == none || lost_) return false;
        const NcMotion &last = motions_[open_], &next = motions_[cut];
        return last.tool == next.tool && last.spindle == next.spindle &&
               (stops_[open_] == stops_[cut] || (last.mist == next.mist && last.flood == next.flood));
    }

    Result<void> addCut(std::size_t i, double share) {
        const NcMotion& motion = motions_[i];
        if (Result<void> sound = check(motion); !sound) return sound;
        if (!goesOn(i)) {
            if (Result<void> begun = beginSection(i); !begun) return begun;
            enter(placeIn(motion, share), motion);
        }
        open_ = i;
        if (motion.kind == NcMotionKind::arc)
            addArc(motion, share);
        else
            push(moveTo(NcMoveKind::line, motion.to, motion.feed), &motion);
        return {};
    }

    Result<void> check(const NcMotion& motion) const {
        if (!motion.startKnown())
            return lineError(request_.line, "a line with no cut from an unknown position behind it (line " +
                                                std::to_string(motion.line) + ")");
        if (!(motion.feed > 0.0))
            return lineError(request_.line,
                             "a line with no cut without a feed behind it (line " + std::to_string(motion.line) + ")");
        if (!motion.spindleOn())
            return lineError(request_.line, "a line with no cut without a spindle behind it (line " +
                                                std::to_string(motion.line) + ")");
        if (motion.ownZero)
            return Error{ErrorCode::notSupported, "a restart of a program that sets its own zero", {}, {}};
        if (motion.workOffset != rest_.workOffset)
            return Error{ErrorCode::notSupported, "a restart over a change of the work offset", {}, {}};
        if (blendOf(motion) != rest_.blendTolerance)
            return Error{ErrorCode::notSupported, "a restart over a change of the path mode (G61, G64)", {}, {}};
        return {};
    }

    Result<void> beginSection(std::size_t first) {
        const NcMotion& cut = motions_[first];
        const auto tool = request_.tools.find(cut.tool);
        if (tool == request_.tools.end())
            return Error{ErrorCode::nameUnknown, "tool", "T" + std::to_string(cut.tool), {}};
        NcSection& section = rest_.sections.emplace_back();
        section.toolNumber = tool->second.number;
        section.toolName = tool->second.name;
        section.spindleSpeed = speed_ = cut.spindleSpeed;
        section.direction =
            cut.spindle == SpindleState::anticlockwise ? SpindleDirection::anticlockwise : SpindleDirection::clockwise;
        section.coolant = coolant_ = coolantOf(cut);
        lost_ = false;
        open_ = first;
        return {};
    }

    /// Moves above a point of the path, then straight down onto it: an upright tool that was there has room above.
    void enter(const AxisValues& place, const NcMotion& cut) {
        AxisValues above = place;
        above.set(Axis::z, std::max(place[Axis::z], request_.freeHeight));
        push(moveTo(NcMoveKind::rapid, std::move(above)));
        if (place[Axis::z] < request_.freeHeight)
            push(moveTo(NcMoveKind::line, place, plungeFeed(motions_, cut.tool, cut.feed)));
    }

    /// Written in as many pieces as it has turns: a block makes at most one.
    void addArc(const NcMotion& motion, double share) {
        const double turns = std::abs(motion.turn().sweep) * (1.0 - share) / (2.0 * pi);
        const int pieces = std::max(1, static_cast<int>(std::ceil(turns - 1e-9)));
        for (int i = 1; i <= pieces; ++i) {
            const double end = i == pieces ? 1.0 : share + (1.0 - share) * i / pieces;
            NcMove move = moveTo(NcMoveKind::arc, placeIn(motion, end), motion.feed);
            move.arc = {motion.centre, motion.arcAxis, motion.clockwise};
            push(std::move(move), &motion);
        }
    }

    /// @param cut the move gets its speed and coolant; null: those in force
    void push(NcMove move, const NcMotion* cut = nullptr) {
        if (cut != nullptr && cut->spindleSpeed > 0.0 && cut->spindleSpeed != speed_)
            move.spindleSpeed = speed_ = cut->spindleSpeed;
        if (cut != nullptr && coolantOf(*cut) != coolant_) move.coolant = coolant_ = coolantOf(*cut);
        if (move.kind == NcMoveKind::line || move.kind == NcMoveKind::arc) {
            move.comment = std::move(comment_);
            comment_.clear();
        }
        rest_.sections.back().moves.push_back(std::move(move));
    }

    std::span<const NcMotion> motions_;
    const RestartRequest& request_;
    NcProgram& rest_;
    std::vector<std::size_t> stops_; ///< spindle stops before each motion
    std::vector<std::size_t> nextCut_;
    std::size_t open_ = none; ///< last cut of the open section, or the cut for which it was begun
    bool lost_ = false;       ///< a motion to an unknown point was left out since the last section began
    double speed_ = 0.0;      ///< 1/min, in force
    Coolant coolant_ = Coolant::off;
    std::string comment_;
};

} // namespace

Result<Restart> restartAt(const ParsedProgram& program, const RestartRequest& request) {
    const std::span<const NcMotion> motions = program.motions;
    const auto first = std::ranges::find_if(motions, [&](const NcMotion& one) { return one.line >= request.line; });
    const auto cut = std::find_if(first, motions.end(), isCut);
    if (cut == motions.end()) {
        const auto last = std::find_if(motions.rbegin(), motions.rend(), isCut);
        return lineError(request.line, last == motions.rend()
                                           ? std::string("none; the program cuts nothing")
                                           : "1 to " + std::to_string(last->line) + ", the line of the last cut");
    }
    const auto next = static_cast<std::size_t>(cut - motions.begin());
    Restart restart;
    restart.done = static_cast<std::size_t>(first - motions.begin());
    restart.cut = cut->line;
    NcProgram& rest = restart.program;
    rest.name = request.programName;
    rest.header = request.header;
    rest.units = request.units;
    rest.workOffset = cut->workOffset;
    rest.safeHeight = request.safeHeight;
    rest.blendTolerance = blendOf(*cut);
    const Begin begin = request.entry == RestartEntry::retract ? retractBefore(motions, next, request.freeHeight)
                        : cut == first                         ? leadBefore(motions, next, request.lead)
                                                               : Begin{next, 0.0, 0.0};
    restart.lead = begin.lead;
    const NcMotion& entered = motions[begin.motion];
    restart.place = isCut(entered) ? placeIn(entered, begin.share) : entered.to;
    if (Result<void> written = RestWriter(program, request, rest).write(begin, next); !written) return written.error();
    return restart;
}

} // namespace burin
