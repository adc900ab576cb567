// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/hid/force_watch.h"

#include "plugins/devices/open_stylus/firmware/open_stylus.h"

#include <algorithm>
#include <cmath>

namespace burin::test {
namespace {

constexpr double step = 0x1.0p-16;      // N, mm, N·mm
constexpr double rounding = 2.0 * step; // of a vector whose components are rounded to half a step each

std::uint16_t word(const Report& report, std::size_t at) {
    return static_cast<std::uint16_t>(report[at] | report[at + 1] << 8);
}
double number(const Report& report, std::size_t at) {
    const std::uint32_t bits = word(report, at) | static_cast<std::uint32_t>(word(report, at + 2)) << 16U;
    return static_cast<double>(static_cast<std::int32_t>(bits));
}
glm::dvec3 vector(const Report& report, std::size_t at) {
    return glm::dvec3(number(report, at), number(report, at + 4), number(report, at + 8)) * step;
}
bool whole(const Report& report, std::size_t size, std::uint8_t id) {
    return report.size() == size && report[0] == id &&
           word(report, size - 2) == open_stylus_crc(report.data(), size - 2);
}

/// Motors on, pose valid, no fault, a rotation: the reading may be trusted.
bool believable(const Report& report) {
    double square = 0.0;
    for (std::size_t at = 20; at < 36; at += 4) square += std::pow(number(report, at) * 0x1.0p-30, 2);
    return (report[1] & 3U) == 3U && word(report, 40) == 0 && std::abs(std::sqrt(square) - 1.0) <= 0.01;
}

} // namespace

void ForceWatch::sends(const Report& report) {
    if (!whole(report, OPEN_STYLUS_INPUT_SIZE, OPEN_STYLUS_INPUT_ID)) return; // the host cannot take it for a reading
    const std::lock_guard lock(mutex_);
    Sent& sent = sent_[word(report, 2)];
    const glm::dvec3 position = vector(report, 8);
    sent.several = sent.several || (sent.there && (sent.believable != believable(report) || sent.position != position));
    sent.there = true;
    sent.believable = believable(report);
    sent.position = position;
}

void ForceWatch::forget() {
    const std::lock_guard lock(mutex_);
    sent_.fill({});
}

void ForceWatch::violate(Violation violation) {
    ++verdict_.violations;
    ++verdict_.kinds[violation];
}

void ForceWatch::hears(const Report& report) {
    const std::lock_guard lock(mutex_);
    ++verdict_.outputs;
    if (!whole(report, OPEN_STYLUS_OUTPUT_SIZE, OPEN_STYLUS_OUTPUT_ID)) {
        violate(damaged);
        return;
    }
    const glm::dvec3 force = vector(report, 4);
    const double size = glm::length(force);
    motors_ = (report[1] & 1U) != 0;
    answered_ = word(report, 28);
    // A full queue drops reports of the host: this many steps lie between two reports that arrived.
    const double steps =
        known_ ? std::max(1.0, static_cast<double>(static_cast<std::uint16_t>(word(report, 2) - number_))) : 1.0;
    if (size > bounds_.largest + rounding) violate(tooLarge);
    if (glm::length(vector(report, 16)) > bounds_.largestTorque + rounding) violate(torque);
    if (!motors_ && size > 0.0) violate(motorsOff);
    if (size > 0.0 && (glm::length(force - before_) > steps * bounds_.fall + rounding ||
                       size - glm::length(before_) > steps * bounds_.rise + rounding))
        violate(slew);
    const Sent& reading = sent_[answered_];
    const bool sure = reading.there && !reading.several;
    const bool jumped = sure && position_ && steps == 1.0 && glm::length(reading.position - *position_) > bounds_.jump;
    if (sure && (!reading.believable || jumped)) {
        ++verdict_.unbelieved;
        if (size > 0.0) violate(believed);
    }
    // The position that the host knows is certain only after an answer to a reading that it had to accept as good.
    if (sure && reading.believable)
        position_ = reading.position;
    else
        position_.reset();
    if (verdict_.violations > 0 && verdict_.first.empty())
        verdict_.first = std::to_string(glm::length(before_)) + " N to " + std::to_string(size) + " N in " +
                         std::to_string(steps) + " reports, flags " + std::to_string(report[1]);
    if (size > 0.0) ++verdict_.pressed;
    before_ = force;
    number_ = word(report, 2);
    known_ = true;
}

std::string ForceWatch::Verdict::text() const {
    constexpr std::array<const char*, 6> names{"damaged", "too large", "torque", "motors off", "slew", "believed"};
    std::string words = std::to_string(outputs) + " answers, " + std::to_string(pressed) + " with force, " +
                        std::to_string(unbelieved) + " to readings not believed";
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i] > 0) words += ", " + std::string(names[i]) + " " + std::to_string(kinds[i]);
    return first.empty() ? words : words + "; first " + first;
}

bool ForceWatch::motors() const {
    const std::lock_guard lock(mutex_);
    return motors_;
}

std::uint16_t ForceWatch::answered() const {
    const std::lock_guard lock(mutex_);
    return answered_;
}

ForceWatch::Verdict ForceWatch::verdict() const {
    const std::lock_guard lock(mutex_);
    return verdict_;
}

} // namespace burin::test
