// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/program.h"

#include <string>

namespace burin {

/// The machine that a project's programs are for until something else is said.
inline constexpr const char* firstMachine = "linuxcnc-mill";

/// What the programs of a project are for.
struct ProgramTarget {
    std::string machine = firstMachine; ///< id
    std::string dialect;                ///< id; empty: the one that the machine's control reads
    NcUnits units = NcUnits::millimetre;

    const std::string& dialectFor(const MachineProfile& profile) const noexcept {
        return dialect.empty() ? profile.dialect : dialect;
    }
    friend bool operator==(const ProgramTarget&, const ProgramTarget&) = default;
};

} // namespace burin
