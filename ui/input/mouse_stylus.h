// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/device/stylus.h"

namespace burin {

/// Where the mouse or the keyboard wants the tool.
struct StylusTarget {
    glm::dvec3 tip{0.0};         ///< mm, setup frame
    double maximumSpeed = 400.0; ///< mm/s on the way there
    bool cutting = false;        ///< first button: the spindle turns
};

/// The simulated stylus: mouse or keyboard. Its device frame is the setup frame (mapping 1 : 1). It leads the tip to
/// the newest target along a smooth, speed-limited way, so that the loop sees a hand and not an event queue. Thread:
/// `wish` the user interface's, the rest the haptic loop's. No lock, no allocation.
class MouseStylus final : public Stylus {
public:
    /// @param start where the tip is first, mm, setup frame; clear of everything
    explicit MouseStylus(const glm::dvec3& start);

    /// The newest one counts.
    void wish(const StylusTarget& target) noexcept;

    StylusDescription description() const override;
    Result<void> open() override;
    StylusState read(double time) noexcept override;
    void write(const glm::dvec3& force) noexcept override;
    void close() noexcept override;

private:
    Mailbox<StylusTarget> wishes_;
    StylusTarget target_;
    glm::dvec3 tip_{0.0}, velocity_{0.0}; ///< mm, mm/s
    double lastTime_ = 0.0;
    bool cutting_ = false;
};

} // namespace burin
