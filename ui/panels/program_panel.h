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

/// The target machine of the program, the verdict of its check, the editor with text and findings, the program's
/// values; Export.
class ProgramPanel : public QWidget {
    Q_OBJECT
public:
    explicit ProgramPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const ProgramState& state);        ///< never emits
    int line() const;                                ///< the line of the text cursor, from 1
    void showLine(int line);                         ///< from 1; emits no signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1; playback stops at them
    /// The machine's state and the time after the selected line; empty and std::nullopt if no line is selected.
    void showMachineState(const QString& state, std::optional<double> seconds);
    /// Text and findings. A child of the panel unless it is shown elsewhere.
    ProgramEditor& editor() const;
    void takeEditor();                ///< takes the editor back from where it is shown
    DeviationCard& deviation() const; ///< the section of the panel for the stock left on the part

signals:
    void postRequested();
    void exportRequested();
    void textEdited(const QString& text); ///< by the user
    void textCheckRequested();            ///< check of the edited text
    void machinesRequested();             ///< to view and edit the machines
    void overrideRequested();             ///< the user wants the program although its check rejects it
    // Permitted depth of cuts into the part, and permitted height of stock left on it.
    void gougeToleranceEdited(double millimetres);
    void excessToleranceEdited(double millimetres);
    void machineChosen(const std::string& id);
    void dialectChosen(const std::string& id);
    void unitsChosen(burin::NcUnits units);
    void pathIncluded(std::int64_t path, bool wanted); ///< @param path id of one of the setup's paths
    void lineChosen(int line);                         ///< from 1
    void breakpointToggled(int line);                  ///< from 1

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
