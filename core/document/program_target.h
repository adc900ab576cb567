// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/program.h"

#include <string>

namespace burin {

/// The machine of a project's programs until another one is chosen.
inline constexpr const char* firstMachine = "linuxcnc-mill";

/// The machine, dialect and units of a project's programs.
struct ProgramTarget {
    std::string machine = firstMachine; ///< id
    std::string dialect;                ///< id; empty: that of the machine's control
    NcUnits units = NcUnits::millimetre;

    const std::string& dialectFor(const MachineProfile& profile) const noexcept {
        return dialect.empty() ? profile.dialect : dialect;
    }
    friend bool operator==(const ProgramTarget&, const ProgramTarget&) = default;
};

} // namespace burin
