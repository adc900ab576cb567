// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace burin {

struct CheckMemory;

/// What a check of a program found out, kept for the next check of a program that differs in parts: what a move meets
/// is not examined again where the same move was made before, nor stock cut again where the same moves come near in the
/// same order. A check that uses it reports the same as one that does not, bit for bit.
/// Belongs to one model with its setup, materials and part mesh: its owner begins a new object when these change. Other
/// tools, obstacles and tolerances are noticed, and begin anew. One thread at a time.
class KeptCheck {
public:
    /// Memory that it may occupy between checks, next to the workpiece that the last check left; what needs more is not
    /// kept.
    static constexpr std::size_t mostBytes = 400'000'000;

    KeptCheck();
    ~KeptCheck();
    KeptCheck(const KeptCheck&) = delete;
    KeptCheck& operator=(const KeptCheck&) = delete;

    std::size_t bytes() const noexcept; ///< occupied now; 0: nothing is kept

    /// For the check: what is kept for a basis (basisText); empty if that of the last check was another.
    CheckMemory& begin(std::string basis);
    void end() noexcept; ///< for the check: discards what is too much

private:
    std::unique_ptr<CheckMemory> memory_; ///< null: nothing is kept
};

} // namespace burin
