// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/motion_writer.h"

namespace burin {

/// Inverse time needs the length of the move, which is unknown for a move from an unknown position: its feed stays 0.
void MotionWriter::resolveFeed(NcMotion& motion) const noexcept {
    switch (state_.feedMode) {
    case FeedMode::perMinute:
        motion.feed = state_.feed;
        break;
    case FeedMode::perRevolution:
        motion.feed = state_.feed * state_.spindleSpeed;
        break;
    case FeedMode::inverseTime:
        motion.feed = motion.startKnown() ? lengthOf(motion) * state_.feed : 0.0;
        break;
    }
    // Degrees are no length: their feed is in degrees/min, whatever the unit.
    if (motion.kind != NcMotionKind::line || !motion.startKnown() || lengthOf(motion) > 0.0) return;
    const double rotation = rotationOf(motion);
    if (!(rotation > 0.0)) return;
    motion.feed = state_.feedMode == FeedMode::inverseTime ? rotation * state_.feed : motion.feed / state_.length;
}

NcMotion& MotionWriter::move(NcMotionKind kind, const AxisValues& target, AxisSet known, std::uint32_t column) {
    NcMotion& motion = program_.motions.emplace_back();
    motion.kind = kind;
    motion.spindle = state_.spindle;
    motion.feedMode = state_.feedMode;
    motion.pathMode = state_.pathMode;
    motion.blendTolerance = state_.blendTolerance;
    motion.mergeTolerance = state_.mergeTolerance;
    motion.mist = state_.mist;
    motion.flood = state_.flood;
    motion.fromKnown = state_.frames.known();
    motion.toKnown = known;
    motion.from = state_.frames.place();
    motion.to = target;
    motion.spindleSpeed = state_.spindleSpeed;
    motion.tool = state_.tool;
    motion.lengthOffset = state_.frames.lengthOffsetNumber();
    motion.workOffset = state_.frames.workOffset();
    motion.ownZero = state_.frames.ownZero();
    motion.line = line_;
    motion.column = column;
    if (kind == NcMotionKind::line) resolveFeed(motion);
    state_.frames.moveTo(target, known);
    return motion;
}

void MotionWriter::arc(const ArcWords& words, const AxisValues& target, AxisSet known, std::uint32_t column) {
    NcMotion& motion = move(NcMotionKind::arc, target, known, column);
    motion.centre = words.arc.centre;
    motion.arcAxis = static_cast<std::uint8_t>(words.arc.axis);
    motion.clockwise = words.arc.clockwise;
    motion.wholeTurns = words.wholeTurns;
    resolveFeed(motion);
}

void MotionWriter::dwell(double seconds, std::uint32_t column) {
    NcMotion& motion = move(NcMotionKind::dwell, state_.frames.place(), state_.frames.known(), column);
    motion.seconds = seconds;
}

} // namespace burin
