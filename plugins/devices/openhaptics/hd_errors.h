// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/openhaptics/hd_api.h"

#include <array>
#include <cstddef>

namespace burin::openhaptics {

/// Sorts the library's errors by device, because the library keeps one stack of errors for all devices. Called on the
/// scheduler's thread. No allocation.
class HdErrors {
public:
    explicit HdErrors(const HdApi& api) noexcept : api_(api) {}

    /// Removes errors from the stack, and passes on those of one device, or of no particular device.
    /// @param each called with the code of each error
    template <class Each>
    void take(HdHandle device, Each each) noexcept {
        for (std::size_t i = 0; i < mostAtOnce; ++i) {
            const HdError error = api_.getError();
            if (error.code == 0) break;
            if (error.device == device || error.device == hdInvalidHandle || count_ == waiting_.size())
                each(error.code);
            else
                waiting_[count_++] = error;
        }
        for (std::size_t i = 0; i < count_;) {
            if (waiting_[i].device != device) {
                ++i;
                continue;
            }
            each(waiting_[i].code);
            waiting_[i] = waiting_[--count_];
        }
    }

private:
    static constexpr std::size_t mostAtOnce = 16; // the remaining ones are taken in the next frame

    const HdApi& api_;
    std::array<HdError, 32> waiting_{}; ///< errors of other devices, kept until their next frame
    std::size_t count_ = 0;
};

} // namespace burin::openhaptics
