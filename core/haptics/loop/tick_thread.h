// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/loop/realtime_scheduling.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace burin {

/// Keeps memory from being paged out as long as it lives, where the limit on locked memory allows (8 MiB as a rule:
/// hence a tick's own memory, never the whole process).
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

/// Reads the program's own code into memory: what a tick runs for the first time does not wait for the disk then. It
/// may be paged out again under pressure. Quick where it is there already. No effect before Linux 5.14.
void makeCodeResident() noexcept;

/// Numbers too small for their full precision count as zero in the calling thread as long as this lives: filters that
/// fade out would make ticks many times slower. Results differ from those with such numbers by less than 1e-300 in
/// what they are added to, hence every pace of a loop uses it, so that all of them agree to the bit.
class DenormalsAreZero {
public:
    DenormalsAreZero() noexcept;
    ~DenormalsAreZero();
    DenormalsAreZero(const DenormalsAreZero&) = delete;
    DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

private:
    std::uint64_t before_;
};

/// What the calling thread needs to tick in real time, as long as this lives: scheduling, its stack touched and locked.
/// May take some hundred milliseconds (D-Bus).
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
