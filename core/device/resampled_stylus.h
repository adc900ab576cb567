// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/device_driver.h"

#include <atomic>
#include <memory>

namespace burin {

/// A self-paced stylus for a loop that keeps edges of its own. What is read is the device's newest reading, what is
/// written goes out with its next one: two clocks that nobody binds together, so that pose and force are up to one more
/// period of the device old. The description's delay says so. Where a loop can be called by the device, let it.
///
/// Thread: read and write the loop's; the rest the owner's.
class ResampledStylus final : public Stylus, private StylusClient {
public:
    static constexpr double longestSilence = 0.02; ///< s without a new reading; from then on they are not valid
    static constexpr double longestWait = 0.02;    ///< s without a new wrench; from then on the device gets none

    explicit ResampledStylus(std::unique_ptr<SelfPacedStylus> stylus) noexcept : stylus_(std::move(stylus)) {}
    ~ResampledStylus() override { close(); }
    ResampledStylus(const ResampledStylus&) = delete;
    ResampledStylus& operator=(const ResampledStylus&) = delete;

    StylusDescription description() const override;
    Result<void> open() override;
    void close() noexcept override;
    std::optional<Error> takeFault() override { return stylus_->takeFault(); }
    DeviceHealth health() const noexcept override { return stylus_->health(); }
    void cutMotors() noexcept override;
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override { wrenches_.post(wrench); }

private:
    Wrench tick(const StylusState& state) noexcept override; // the device's thread

    std::unique_ptr<SelfPacedStylus> stylus_;
    Mailbox<StylusState> states_;
    Mailbox<Wrench> wrenches_;
    std::atomic<bool> cut_{false}; ///< what was written so far does not count any more
    StylusState newest_;           ///< the loop's
    double freshAt_ = 0.0;         ///< s, the loop's time
    Wrench wrench_;                ///< the device's thread
    double wantedAt_ = 0.0;        ///< s, the device's time
};

/// Any stylus as one that the loop calls.
std::unique_ptr<Stylus> calledByLoop(AnyStylus stylus);

} // namespace burin
