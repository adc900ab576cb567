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

/// The program that was checked last, with its verdict, as stored in a project. After reopening the project, the
/// verdict is known without another check.
struct KeptProgram {
    std::string text, dialect, machine; ///< dialect and machine: ids for which it was checked
    NcUnits units = NcUnits::millimetre;
    double gougeTolerance = 0.0;       ///< mm, used in the check
    double excessTolerance = 0.1;      ///< the same, as VerifyRequest::excessTolerance
    bool overridden = false;           ///< failed the check; the header states why it is used nevertheless
    bool byHand = false;               ///< the user edited its text
    std::vector<std::string> tools;    ///< ids of the tools that it may call
    std::vector<std::int64_t> leftOut; ///< ids of paths that the user excluded from it
    std::string report;                ///< JSON of `toJson(VerifyReport)`
    std::uint64_t judged = 0;          ///< `judgedChecksum` at the time of the check
};

std::string toJson(const KeptProgram& program);
/// Empty if the text was not written by `toJson`.
std::optional<KeptProgram> keptProgramFromJson(std::string_view text);

/// Returns a checksum of everything that a check depends on except the program itself: part, stock, fixtures,
/// recordings and their tools, paths, materials and machine, and the rules of this version of Burin. If the checksums
/// are equal, the check would have the same result.
/// Errors: fileDamaged, those of loadMachine, loadMaterial, toolFor.
Result<std::uint64_t> judgedBasis(const Project& project, const std::string& machine);

/// Returns a checksum of the basis and the program's text, dialect, tolerance, tools and report. @param basis
/// `judgedBasis`
std::uint64_t judgedChecksum(std::uint64_t basis, const KeptProgram& program);

/// Whether the verdict of a stored program still holds. Errors: those of judgedBasis.
Result<bool> isJudgedSo(const Project& project, const KeptProgram& program);

/// A stored program as a checked one, without the results that are not stored: times, loads, deviations, the workpiece.
struct ReopenedProgram {
    KeptProgram kept;
    std::shared_ptr<const CheckedProgram> program; ///< never null
    std::uint64_t basis = 0;                       ///< of the project in its present state
    bool upToDate = false;                         ///< nothing that the check depends on has changed
};
/// Empty if no program is stored, or something that it needs no longer exists. Errors: fileDamaged.
Result<std::optional<ReopenedProgram>> reopenProgram(const Project& project);

/// Stores the verdict of a check of the project in its present state. Errors: those of judgedBasis, and of storing.
Result<void> keepVerdict(Project& project, const CheckedProgram& program, const std::string& machine, NcUnits units);

/// Returns what a project stores of a program. @param basis `judgedBasis` from before the check
KeptProgram keptOf(const CheckedProgram& program, const std::string& machine, NcUnits units, std::uint64_t basis);

} // namespace burin
