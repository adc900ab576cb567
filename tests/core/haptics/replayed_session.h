// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/servo_loop.h"
#include "core/haptics/trace/replayed_changes.h"
#include "core/haptics/trace/trace_recorder.h"
#include "core/haptics/trace/trace_stylus.h"
#include "tests/core/haptics/haptic_rig.h"

#include <atomic>
#include <cstring>
#include <optional>
#include <string>

namespace burin::test {

/// Progress of a session. Thread-safe.
struct TickProgress {
    std::atomic<std::uint64_t> ticks{0}, cut{0}, invalid{0}; ///< all, those that cut stock, those without a reading
};

/// Keeps every tick.
class SampleLog final : public TickSink {
public:
    explicit SampleLog(TickProgress* progress = nullptr) : progress_(progress) { samples.reserve(1U << 16U); }
    AtEdge edge() noexcept override { return samples.size() < samples.capacity() ? AtEdge::tick : AtEdge::full; }
    void tick(const Sample& sample, const TickTiming&) noexcept override {
        samples.push_back(sample);
        if (progress_ == nullptr) return;
        ++progress_->ticks;
        if (sample.removed[0].units > 0) ++progress_->cut;
        if ((sample.flags & sampleStylusInvalid) != 0) ++progress_->invalid;
    }
    std::vector<Sample> samples;

private:
    TickProgress* progress_;
};

/// A quarter of a circle in the plane z = -6 mm.
inline GuideCurve quarterCircle() {
    std::vector<glm::dvec3> points, tangents;
    for (int i = 0; i <= 24; ++i) {
        const double angle = pi / 2.0 * i / 24.0;
        points.emplace_back(7.0 * std::cos(angle), 7.0 * std::sin(angle), -6.0);
        tangents.emplace_back(-std::sin(angle), std::cos(angle), 0.0);
    }
    auto curve = GuideCurve::make(std::move(points), std::move(tangents));
    if (!curve) std::abort(); // the test's own set-up
    return std::move(*curve);
}

/// Calls the functions of a step that a session's owner may call at any time, of every kind and at fixed ticks: guides
/// of several kinds, levels, allowance, scale, turn, clutch, recentring, spindle, takes, layers.
class ToldInBetween final : public TickSink {
public:
    ToldInBetween(HapticStep& step, TickSink& next) : step_(step), next_(next) {}

    AtEdge edge() noexcept override {
        const AtEdge answer = next_.edge();
        if (answer == AtEdge::tick && asked_ == ticks_) tell(ticks_);
        asked_ = ticks_ + 1;
        return answer;
    }
    void tick(const Sample& sample, const TickTiming& timing) noexcept override {
        ++ticks_;
        next_.tick(sample, timing);
    }

private:
    void tell(std::size_t tick) noexcept {
        switch (tick % 1000) {
        case 60:
            step_.setAllowance(0.37);
            break;
        case 90: {
            GuideSettings guides;
            guides.guides[0].kind = GuideKind::levels;
            guides.guides[0].on = true;
            guides.guides[0].distance = 0.7;
            guides.guides[3].kind = GuideKind::curve;
            guides.guides[3].on = true;
            guides.guides[3].curve = &curve_;
            guides.guides[5].kind = GuideKind::surface;
            guides.guides[5].on = true;
            guides.guides[5].distance = 0.3;
            guides.stepButton = 4;
            step_.setGuides(guides);
            break;
        }
        case 200:
        case 260:
            step_.stepGuides(tick % 1000 == 200 ? -1 : 1);
            break;
        case 300:
            workspace_.scale = 1.0 + 1.0 / 3.0;
            ++workspace_.recentrings;
            step_.setWorkspace(workspace_);
            break;
        case 360:
            workspace_.clutched = true;
            workspace_.rotation = glm::angleAxis(0.3, glm::dvec3(0.0, 0.0, 1.0));
            step_.setWorkspace(workspace_);
            break;
        case 400:
            workspace_.clutched = false;
            step_.setWorkspace(workspace_);
            break;
        case 450:
            step_.releaseSpindle(false);
            break;
        case 480:
            step_.beginTake();
            step_.releaseSpindle(true);
            step_.resumeCutting();
            break;
        case 520:
            step_.setAllowance(0.0);
            step_.setGuides({});
            break;
        case 600:
            step_.switchLayer(0, false);
            break;
        case 640:
            step_.switchLayer(0, true);
            break;
        default:
            break;
        }
    }

    HapticStep& step_;
    TickSink& next_;
    GuideCurve curve_ = quarterCircle();
    WorkspaceSettings workspace_;
    std::size_t ticks_ = 0, asked_ = 0;
};

/// A session on the block of Rig, including the workpiece afterwards.
struct RecordedSession {
    std::vector<Sample> samples;
    RunAmounts amounts;
    std::string fault; ///< empty: no fault
};

/// What the owner of a session tells its step during the session.
enum class OwnerTells : std::uint8_t {
    nothing,   ///< the tool position depends only on the hand and the stock, however late the ticks are
    everything ///< see ToldInBetween
};

/// Runs a session with a stylus. @return its samples and the trace that it leaves
inline RecordedSession recordSession(const StylusHandle& stylus, const HapticSettings& settings,
                                     const std::filesystem::path& file, double seconds,
                                     OwnerTells tells = OwnerTells::everything,
                                     const std::atomic<bool>& stop = std::atomic<bool>(false),
                                     TickProgress* progress = nullptr) {
    Rig rig(settings);
    SampleLog log(progress);
    ToldInBetween told(rig.step, log);
    TickSink& listener = tells == OwnerTells::everything ? static_cast<TickSink&>(told) : log;
    auto recorder = TraceRecorder::begin(file, listener);
    if (!recorder) return {{}, {}, recorder.error().detail};
    rig.step.listen(recorder->get());
    ServoSettings servo;
    servo.maximumSeconds = seconds;
    servo.period = settings.tickPeriod;
    const auto ran = runServoLoop(stylus, rig.step, **recorder, servo, stop);
    rig.step.listen(nullptr);
    if (!ran) return {{}, {}, ran.error().subject + " " + ran.error().detail};
    auto written = (*recorder)->finish();
    if (!written) return {{}, {}, written.error().detail};
    if (const auto placed = written->putInPlace(); !placed) return {{}, {}, placed.error().detail};
    rig.step.settle();
    return {std::move(log.samples), rig.volume.amounts(), {}};
}

/// The same session, replayed from its trace without a clock.
inline RecordedSession replaySession(const HapticSettings& settings, const std::filesystem::path& file) {
    const auto trace = readSessionTrace(file);
    if (!trace) return {{}, {}, trace.error().place + " " + trace.error().detail};
    TraceStylus stylus(trace->readings, settings.stylus);
    if (!stylus.open()) return {{}, {}, "the trace does not open"};
    Rig rig(settings);
    SampleLog log;
    ReplayedChanges changes(*trace, rig.step, log);
    ServoSettings servo;
    servo.pace = Pace::fast;
    servo.period = settings.tickPeriod;
    const std::atomic<bool> stop{false};
    if (!runServoLoop(stylus, rig.step, changes, servo, stop)) return {{}, {}, "the loop did not run"};
    rig.step.settle();
    return {std::move(log.samples), rig.volume.amounts(), {}};
}

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Whether two ticks are bitwise equal: pose, force, removal, buttons, flags; in a replay number and time continue. A
/// force that was withheld because it was too late for the hand is computed again.
inline bool sameTick(const Sample& original, const Sample& again) {
    if (!sameBits(original.proxy.tip, again.proxy.tip) || !sameBits(original.proxy.axis, again.proxy.axis) ||
        !sameBits(original.stylusTip, again.stylusTip) || !sameBits(original.cuttingForce, again.cuttingForce) ||
        !sameBits(original.reportedRemoval, again.reportedRemoval))
        return false;
    for (std::size_t i = 0; i < original.removed.size(); ++i)
        if (original.removed[i].units != again.removed[i].units ||
            original.removed[i].property != again.removed[i].property)
            return false;
    if ((original.flags & sampleForceLate) != 0) return true;
    return sameBits(original.force, again.force) && original.flags == again.flags && original.buttons == again.buttons;
}

/// Describes the differences between a session and its replay; empty if there are none.
inline std::string differenceOf(const RecordedSession& original, const RecordedSession& again) {
    if (!original.fault.empty()) return "recording: " + original.fault;
    if (!again.fault.empty()) return "replay: " + again.fault;
    if (original.samples.size() != again.samples.size())
        return std::to_string(original.samples.size()) + " ticks, and " + std::to_string(again.samples.size());
    for (std::size_t i = 0; i < original.samples.size(); ++i)
        if (!sameTick(original.samples[i], again.samples[i])) return "tick " + std::to_string(i);
    if (original.amounts != again.amounts) return "the workpiece";
    return {};
}

/// Number of events in a session: a session without events would prove nothing.
struct SessionEvents {
    int cut = 0, held = 0, guided = 0, faults = 0, felt = 0;
};
inline SessionEvents eventsOf(std::span<const Sample> samples) {
    SessionEvents events;
    for (const Sample& sample : samples) {
        events.cut += sample.removed[0].units > 0 ? 1 : 0;
        events.held += (sample.flags & sampleOnBoundary) != 0 ? 1 : 0;
        events.guided += (sample.flags & sampleOnGuide) != 0 ? 1 : 0;
        events.faults += (sample.flags & sampleStylusInvalid) != 0 ? 1 : 0;
        events.felt += glm::length(sample.force) > 0.05 ? 1 : 0;
    }
    return events;
}

} // namespace burin::test
