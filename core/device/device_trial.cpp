// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_trial.h"

#include "core/base/mailbox.h"
#include "core/base/numbers.h"
#include "core/device/device_thread.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <thread>

namespace burin {
namespace {

constexpr double forceShare = 0.2;  // of the maximum force of the motors
constexpr double forceStep = 0.01;  // N: limits are reported in these steps
constexpr double rounding = 1e-6;   // share of a step
constexpr double fadeSeconds = 1.0; // of the force, while the button is held
constexpr double longest = 3600.0;  // s
constexpr double period = 0.001;    // s, for a stylus without a clock of its own
constexpr std::chrono::milliseconds reportEvery{100};
constexpr std::size_t bins = 2000; // of intervals, 10 µs each
constexpr double binSeconds = 1e-5;

/// Measurements so far, as published by the reading thread.
struct Gathered {
    std::uint64_t readings = 0, invalid = 0;
    double firstAt = 0.0, lastAt = 0.0; ///< s, of the steady clock
    double maximumInterval = 0.0, smallestStep = 0.0, maximumRotation = 0.0, maximumForce = 0.0;
    double maximumAssist = 0.0; ///< share
    glm::dvec3 lowest{0.0}, highest{0.0}, position{0.0};
    glm::dquat first{1.0, 0.0, 0.0, 0.0};
    std::uint32_t buttons = 0;
    std::array<std::uint32_t, bins> intervals{};
};

/// The interval that this share of all intervals does not exceed, s.
double quantileOf(const Gathered& gathered, double share) {
    std::uint64_t all = 0, below = 0;
    for (const std::uint32_t count : gathered.intervals) all += count;
    for (std::size_t i = 0; i + 1 < bins && all > 0; ++i)
        if (static_cast<double>(below += gathered.intervals[i]) >= share * static_cast<double>(all))
            return (static_cast<double>(i) + 0.5) * binSeconds;
    return gathered.maximumInterval; // the last bin has no upper end
}

/// The value that nine of ten do not exceed; 0: there are none.
double usualOf(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto usual = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 9 / 10);
    std::ranges::nth_element(values, usual);
    return *usual;
}

TrialFigures figuresOf(const Gathered& gathered) {
    TrialFigures figures;
    figures.seconds = gathered.lastAt - gathered.firstAt;
    figures.readings = gathered.readings;
    figures.invalid = gathered.invalid;
    const auto intervals = static_cast<double>(gathered.readings + gathered.invalid) - 1.0;
    if (figures.seconds > 0.0) figures.rate = intervals / figures.seconds;
    figures.medianInterval = quantileOf(gathered, 0.5);
    figures.usualInterval = quantileOf(gathered, 0.99);
    figures.maximumInterval = gathered.maximumInterval;
    figures.maximumRotation = gathered.maximumRotation;
    figures.smallestStep = gathered.smallestStep;
    figures.lowest = gathered.lowest;
    figures.highest = gathered.highest;
    figures.position = gathered.position;
    figures.buttons = gathered.buttons;
    figures.maximumForce = gathered.maximumForce;
    figures.maximumAssist = gathered.maximumAssist;
    return figures;
}

/// Measures the readings of a stylus and answers them, on the thread that reads; publishes the measurements.
class Gathering {
public:
    Gathering(const TrialSettings& settings, bool hasButtons)
        : force_(settings.force), assist_(settings.assist), hasButtons_(hasButtons) {}

    /// Called on the thread that reads. @return the wrench to render
    Wrench take(const StylusState& state) noexcept {
        const double at = steadySeconds();
        noteTime(at);
        if (state.valid)
            notePose(state);
        else
            ++now_.invalid;
        Wrench wrench;
        const bool held = state.valid && hasButtons_ && (state.buttons & 1U) != 0;
        if (!held) heldAt_.reset();
        if (held && !heldAt_) heldAt_ = at;
        if (held) wrench.force.z = force_ * std::min((at - *heldAt_) / fadeSeconds, 1.0);
        if (held) wrench.assist = trialAssist(at - *heldAt_, assist_);
        now_.maximumForce = std::max(now_.maximumForce, wrench.force.z);
        now_.maximumAssist = std::max(now_.maximumAssist, glm::length(wrench.assist.force));
        news_.post(now_);
        return wrench;
    }

    /// Called on the owner's thread.
    TrialFigures figures() {
        news_.take(seen_);
        return figuresOf(seen_);
    }

private:
    void noteTime(double at) noexcept {
        if (now_.firstAt == 0.0) now_.firstAt = at;
        if (now_.lastAt > 0.0) {
            const double interval = at - now_.lastAt;
            now_.maximumInterval = std::max(now_.maximumInterval, interval);
            ++now_.intervals[std::min(bins - 1, static_cast<std::size_t>(interval / binSeconds))];
        }
        now_.lastAt = at;
    }
    void notePose(const StylusState& state) noexcept {
        const glm::dvec3 position = state.pose.position;
        if (now_.readings++ == 0) {
            now_.lowest = now_.highest = position;
            now_.first = state.pose.rotation;
        } else if (const double step = glm::distance(position, now_.position); step > 0.0) {
            now_.smallestStep = now_.smallestStep > 0.0 ? std::min(now_.smallestStep, step) : step;
        }
        now_.position = position;
        now_.lowest = glm::min(now_.lowest, position);
        now_.highest = glm::max(now_.highest, position);
        now_.buttons |= state.buttons;
        const double cosine = std::min(1.0, std::abs(glm::dot(now_.first, state.pose.rotation)));
        now_.maximumRotation = std::max(now_.maximumRotation, 2.0 * std::acos(cosine));
    }

    const double force_;  ///< N
    const double assist_; ///< share
    const bool hasButtons_;
    Mailbox<Gathered> news_;
    Gathered seen_; ///< used by the owner's thread only
    Gathered now_;  ///< this member and the following belong to the reading thread
    std::optional<double> heldAt_;
};

class TrialClient final : public StylusClient {
public:
    explicit TrialClient(Gathering& gathering) : gathering_(gathering) {}
    Wrench tick(const StylusState& state) noexcept override { return gathering_.take(state); }

private:
    Gathering& gathering_;
};

/// Reads a stylus without a clock on a thread of its own, until this object is destroyed.
class Reader {
public:
    Reader(Stylus& stylus, Gathering& gathering)
        : thread_([&](const std::stop_token& stop) {
            const double start = steadySeconds();
            auto due = std::chrono::steady_clock::now();
            while (!stop.stop_requested()) {
                stylus.write(gathering.take(stylus.read(steadySeconds() - start)));
                due = std::max(due + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                         std::chrono::duration<double>(period)),
                               std::chrono::steady_clock::now());
                std::this_thread::sleep_until(due);
            }
            stylus.write({});
        }) {}

private:
    std::jthread thread_;
};

Result<void> checkSettings(const StylusDescription& stylus, const TrialSettings& settings) {
    if (!(settings.seconds > 0.0 && settings.seconds <= longest))
        return Error{ErrorCode::argumentInvalid, "seconds", formatShortest(settings.seconds), "0 … 3600 s"};
    const double limit = stylus.buttons > 0 ? trialForceLimit(stylus) : 0.0; // a button to hold is required
    if (!(settings.force >= 0.0 && settings.force <= limit))
        return Error{ErrorCode::argumentInvalid, "test force", formatShortest(settings.force),
                     limit > 0.0 ? "0 … " + formatFixed(limit, 2) + " N" : "0 N"};
    const bool assists = stylus.buttons > 0 && stylus.assist.works();
    if (!(settings.assist >= 0.0 && settings.assist <= (assists ? 1.0 : 0.0)))
        return Error{ErrorCode::argumentInvalid, "test strength", formatShortest(settings.assist),
                     assists ? "0 … 1" : "0"};
    return {};
}

} // namespace

Assist trialAssist(double seconds, double ceiling) noexcept {
    constexpr std::array<glm::dvec3, 4> pushes{glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
                                               glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0)};
    const double turn = std::floor(std::max(seconds, 0.0));
    const double strength = ceiling * (std::max(seconds, 0.0) - turn);
    const auto phase = static_cast<std::size_t>(std::fmod(turn, pushes.size()));
    Assist assist;
    assist.force = strength * pushes[phase];
    (phase % 2 == 0 ? assist.contact : assist.load) = strength;
    assist.ceiling = ceiling;
    return assist;
}

double trialForceLimit(const StylusDescription& stylus) noexcept {
    if (stylus.actuated.translations < 3) return 0.0;
    const double limit = forceShare * stylus.maximumForce.value;
    const double borne = stylus.continuousForce.value > 0.0 ? std::min(limit, stylus.continuousForce.value) : limit;
    return std::floor(borne / forceStep + rounding) * forceStep;
}

Result<TrialFigures> tryDevice(const StylusHandle& stylus, const TrialSettings& settings, Progress& progress) {
    StylusDevice& device = stylus.device();
    const StylusDescription description = device.description();
    if (const Result<void> checked = checkSettings(description, settings); !checked) return checked.error();
    if (const Result<void> opened = device.open(); !opened) return opened.error();
    const auto gathering = std::make_unique<Gathering>(settings, description.buttons > 0); // 24 kB
    TrialClient client(*gathering);
    std::vector<Error> faults;
    std::vector<double> roundTrips;
    const auto look = [&] {
        TrialFigures figures = gathering->figures();
        while (std::optional<Error> fault = device.takeFault()) faults.push_back(std::move(*fault));
        figures.health = device.health();
        if (figures.health.roundTrip > 0.0) roundTrips.push_back(figures.health.roundTrip);
        figures.latency = usualOf(roundTrips);
        figures.faults = faults;
        return figures;
    };
    {
        std::optional<Reader> reader;
        if (SelfPacedStylus* paced = stylus.selfPaced()) {
            if (const Result<void> started = paced->start(client); !started) {
                device.close();
                return started.error();
            }
        } else {
            reader.emplace(*stylus.called(), *gathering);
        }
        const double start = steadySeconds();
        for (double passed = 0.0; passed < settings.seconds && !progress.cancelled();
             passed = steadySeconds() - start) {
            const std::chrono::duration<double> rest(settings.seconds - passed);
            std::this_thread::sleep_for(std::min<std::chrono::duration<double>>(rest, reportEvery));
            progress.report((steadySeconds() - start) / settings.seconds);
            if (settings.report) settings.report(look());
        }
        if (SelfPacedStylus* paced = stylus.selfPaced()) paced->stop();
    }
    TrialFigures figures = look();
    device.close();
    if (progress.cancelled()) return Error{ErrorCode::cancelled, description.name, {}, {}};
    return figures;
}

} // namespace burin
