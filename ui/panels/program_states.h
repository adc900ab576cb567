// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/lint.h"
#include "core/nc/program.h"
#include "core/verify/verify.h"

#include <QString>
#include <QStringList>

#include <memory>
#include <string>
#include <vector>

/// What the panels of the program show. Panels own no model: they get one of these and tell by signals what the user
/// wants.
namespace burin {

/// Something that can be chosen by its name.
struct NamedChoice {
    std::string id;
    QString name;
};

/// A path that may belong into a program.
struct ProgramPathState {
    std::int64_t id = 0;
    QString name; ///< its tool's
    bool included = true;
};

struct ProgramState {
    bool hasPath = false;                ///< some path belongs into it
    bool upToDate = false;               ///< that of the tool in force is, or there is none
    std::vector<ProgramPathState> paths; ///< in the order of milling
    QStringList withoutPath;             ///< tools that milled and have no path yet
    NcUnits units = NcUnits::millimetre;
    std::vector<NamedChoice> machines, dialects;
    std::string machine, dialect; ///< ids of those in force
    bool typicalMachine = false;  ///< the one in force is shipped with Burin
    QString missingMachine;       ///< that the project names, and that is not here; empty: it is
    QString text;                 ///< empty: not posted
    bool edited = false;          ///< by hand, after it was posted, and not checked since
    std::size_t blocks = 0;
    std::shared_ptr<const VerifyReport> report; ///< null: not checked; large, so that it is shared
    std::vector<LintMark> lint;                 ///< of the program that the report is about
    bool released = false;                      ///< it passed, or its header says why it is wanted all the same
    double gougeTolerance = 0.02;               ///< mm, for the next check
    double excessTolerance = 0.1;               ///< mm, the same; 0: not judged
    double judgedTolerance = 0.02;              ///< mm, that the report was judged by
    bool outdated = false;
    bool busy = false;
    QString problem;
};

} // namespace burin
