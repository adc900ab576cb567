// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The program that was checked last, with its verdict, as a project keeps it: whoever opens the project again knows
/// whether it passed without another check.
struct KeptProgram {
    std::string text, dialect, machine; ///< ids of those that it was judged for
    NcUnits units = NcUnits::millimetre;
    double gougeTolerance = 0.0;       ///< mm, that it was judged by
    double excessTolerance = 0.1;      ///< the same, as VerifyRequest::excessTolerance
    bool overridden = false;           ///< its header says why it is wanted all the same
    bool byHand = false;               ///< the user wrote in its text
    std::vector<std::string> tools;    ///< ids of those that it may call
    std::vector<std::int64_t> leftOut; ///< ids of paths that the user left out of it
    std::string report;                ///< JSON of `toJson(VerifyReport)`
    std::uint64_t judged = 0;          ///< `judgedChecksum` when it was checked
};

std::string toJson(const KeptProgram& program);
/// Nothing where `toJson` did not write it.
std::optional<KeptProgram> keptProgramFromJson(std::string_view text);

/// All that a check looks at besides the program itself, as one figure: part, stock, fixtures, recordings and their
/// tools, paths, materials and machine, and the rules of this version of Burin. Equal figures: the check would say the
/// same.
/// Errors: fileDamaged, those of loadMachine, loadMaterial, toolFor.
Result<std::uint64_t> judgedBasis(const Project& project, const std::string& machine);

/// Of that, and of the program's text, dialect, tolerance, tools and report. @param basis `judgedBasis`
std::uint64_t judgedChecksum(std::uint64_t basis, const KeptProgram& program);

/// Whether a kept program's verdict still holds. Errors: those of judgedBasis.
Result<bool> isJudgedSo(const Project& project, const KeptProgram& program);

/// A kept program as one that was checked, but for what is not kept: times, loads, deviations, the workpiece.
struct ReopenedProgram {
    KeptProgram kept;
    std::shared_ptr<const CheckedProgram> program; ///< never null
    std::uint64_t basis = 0;                       ///< of the project as it is
    bool upToDate = false;                         ///< all that it was judged by is as it was
};
/// Nothing: none is kept, or what it needs is not here any more. Errors: fileDamaged.
Result<std::optional<ReopenedProgram>> reopenProgram(const Project& project);

/// Stores the verdict of a check that was made of the project as it is. Errors: those of judgedBasis, and of storing.
Result<void> keepVerdict(Project& project, const CheckedProgram& program, const std::string& machine, NcUnits units);

/// What a project is to keep of a program. @param basis `judgedBasis` from before the check
KeptProgram keptOf(const CheckedProgram& program, const std::string& machine, NcUnits units, std::uint64_t basis);

} // namespace burin
