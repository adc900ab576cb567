// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/job_states.h"
#include "ui/theme/length_unit.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace burin {

class Workbench;

/// What a step of the first job is judged by.
struct FirstJobFacts {
    Workbench& workbench;
    std::string firstTool; ///< in the spindle when the first job began, by id
    bool exported = false; ///< a program, since then
};

/// One step of the first job. Texts are marked for translation (context "FirstJob"); widgets and entries of menus go by
/// their object names.
struct FirstJobStep {
    const char* title;
    const char* text;                                                           ///< may have %1
    QString (*argument)(const Workbench& workbench, LengthUnit unit) = nullptr; ///< of the text; null: it has none
    std::optional<JobStep> place = {};                ///< in the line of steps; nothing: before there is one
    const char* widget = nullptr;                     ///< that is meant
    const char* action = nullptr;                     ///< entry of a menu that is meant where the widget is not seen
    int (*row)(const Workbench& workbench) = nullptr; ///< of the widget, a list; null: all of it is meant
    std::optional<ActionId> key = {};                 ///< does the same
    bool needed = true;                               ///< what comes after it can't be done without it
    bool (*done)(const FirstJobFacts& facts) = nullptr;
};

/// In their order.
const std::vector<FirstJobStep>& firstJobSteps();

QString titleOf(const FirstJobStep& step);
QString textOf(const FirstJobStep& step, const Workbench& workbench, LengthUnit unit);

} // namespace burin
