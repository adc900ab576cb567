// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/program_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <optional>
#include <set>

namespace burin {

class DeviationCard;
class ProgramEditor;

/// What the program is made for, the verdict of its check, the editor with text and findings, its figures; Export.
class ProgramPanel : public QWidget {
    Q_OBJECT
public:
    explicit ProgramPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const ProgramState& state);        ///< never emits
    int line() const;                                ///< from 1: where the cursor stands in the text
    void showLine(int line);                         ///< from 1, without a signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1, at which a play stops
    /// When the chosen line is done: the machine's state, and the time; nothing: no line is looked at.
    void showMachineState(const QString& state, std::optional<double> seconds);
    /// Text and findings. The panel's own child, unless somebody shows it elsewhere.
    ProgramEditor& editor() const;
    void takeEditor();                ///< back from elsewhere
    DeviationCard& deviation() const; ///< the part of the panel that tells what is left on the part

signals:
    void postRequested();
    void exportRequested();
    void textEdited(const QString& text); ///< by the user
    void textCheckRequested();            ///< of the text as it was edited
    void machinesRequested();             ///< to look at them and to change them
    void overrideRequested();             ///< the program is wanted although its check refuses it
    // Depth that may be cut into the part, and height that may be left on it.
    void gougeToleranceEdited(double millimetres);
    void excessToleranceEdited(double millimetres);
    void machineChosen(const std::string& id);
    void dialectChosen(const std::string& id);
    void unitsChosen(burin::NcUnits units);
    void pathIncluded(std::int64_t path, bool wanted); ///< @param path id of one of the setup's
    void lineChosen(int line);                         ///< from 1
    void breakpointToggled(int line);                  ///< from 1

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
