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

/// States of the program panels. Panels own no model: they are given one of these states and report the user's requests
/// by signals.
namespace burin {

/// An item that can be chosen by its name.
struct NamedChoice {
    std::string id;
    QString name;
};

/// A path that can be included in a program.
struct ProgramPathState {
    std::int64_t id = 0;
    QString name; ///< the name of its tool
    bool included = true;
};

struct ProgramState {
    bool hasPath = false;                ///< whether at least one path is included
    bool upToDate = false;               ///< whether the current tool's path is up to date, or there is none
    std::vector<ProgramPathState> paths; ///< in the order of milling
    QStringList withoutPath;             ///< tools that have takes but no path yet
    NcUnits units = NcUnits::millimetre;
    std::vector<NamedChoice> machines, dialects;
    std::string machine, dialect; ///< ids of the current ones
    bool typicalMachine = false;  ///< whether the current machine is shipped with Burin
    QString missingMachine;       ///< the machine that the project names, if it is not available; otherwise empty
    QString text;                 ///< empty: not posted
    bool edited = false;          ///< whether it was edited by hand after it was posted, and not checked since
    std::size_t blocks = 0;
    std::shared_ptr<const VerifyReport> report; ///< null: not checked; shared because it is large
    std::vector<LintMark> lint;                 ///< of the program to which the report refers
    bool released = false;         ///< whether it passed, or its header states why it is wanted nevertheless
    double gougeTolerance = 0.02;  ///< mm, for the next check
    double excessTolerance = 0.1;  ///< mm, for the next check; 0: not judged
    double judgedTolerance = 0.02; ///< mm, the tolerance by which the report was judged
    bool outdated = false;
    bool busy = false;
    QString problem;
};

} // namespace burin
