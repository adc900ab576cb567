// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/realtime_scheduling.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace burin {

/// Keeps memory from being paged out for the lifetime of the object, if the limit on locked memory allows it (usually 8
/// MiB, hence only a tick's own memory and never the whole process).
class LockedMemory {
public:
    LockedMemory(const void* begin, std::size_t bytes) noexcept;
    ~LockedMemory();
    LockedMemory(const LockedMemory&) = delete;
    LockedMemory& operator=(const LockedMemory&) = delete;
    bool locked() const noexcept { return locked_; }

private:
    const void* begin_;
    std::size_t bytes_;
    bool locked_;
};

/// Reads the program's own code into memory, so that code that a tick runs for the first time does not wait for the
/// disk. It may be paged out again under memory pressure. Fast if the code is in memory already. No effect before Linux
/// 5.14.
void makeCodeResident() noexcept;

/// Treats denormal numbers as zero in the calling thread for the lifetime of the object: filters that fade out would
/// otherwise make ticks many times slower. Results differ from those with denormals by less than 1e-300 in the sums
/// that they are added to; therefore every pace of a loop uses it, so that all of them agree to the bit.
class DenormalsAreZero {
public:
    DenormalsAreZero() noexcept;
    ~DenormalsAreZero();
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

private:
    std::uint64_t before_;
};

/// Prepares the calling thread for real-time ticks, for the lifetime of the object: sets its scheduling, and touches
/// and locks its stack. May take some hundred milliseconds (D-Bus).
class TickThread {
public:
    TickThread() noexcept;
    SchedulingClass scheduling() const noexcept { return scheduling_.obtained(); }
    bool stackLocked() const noexcept { return stack_ && stack_->locked(); }

private:
    RealtimeScheduling scheduling_{RealtimeScheduling::Role::loop};
    std::optional<LockedMemory> stack_;
};

} // namespace burin
