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

/// The facts that decide whether a step of the first job is done.
struct FirstJobFacts {
    Workbench& workbench;
    std::string firstTool; ///< id of the tool in the spindle when the first job began
    bool exported = false; ///< whether a program was exported since then
};

/// One step of the first job. Texts are marked for translation (context "FirstJob"); widgets and menu entries are given
/// by their object names.
struct FirstJobStep {
    const char* title;
    const char* text;                                                           ///< may contain %1
    QString (*argument)(const Workbench& workbench, LengthUnit unit) = nullptr; ///< replaces %1; null if there is none
    std::optional<JobStep> place = {};                ///< in the step bar; empty before there is a bar
    const char* widget = nullptr;                     ///< target widget
    const char* action = nullptr;                     ///< target menu entry if the widget is not visible
    int (*row)(const Workbench& workbench) = nullptr; ///< target row of a list widget; null: all of it
    std::optional<ActionId> key = {};                 ///< action with a shortcut that does the same
    bool needed = true;                               ///< whether the later steps depend on it
    bool (*done)(const FirstJobFacts& facts) = nullptr;
};

/// The steps, in order.
const std::vector<FirstJobStep>& firstJobSteps();

QString titleOf(const FirstJobStep& step);
QString textOf(const FirstJobStep& step, const Workbench& workbench, LengthUnit unit);

} // namespace burin
