// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/program_states.h"
#include "ui/panels/program_view.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <set>

class QAction;
class QBoxLayout;
class QPushButton;

namespace burin {

class ProgramText;
class RowList;
struct ListRow;

/// The text of the program together with the findings of its check. Placed in the program panel, with the findings
/// below the text, or in a dock, where they are side by side if the dock is wider than high. The findings take their
/// space from the text, so that nothing around the editor moves when they appear or disappear.
class ProgramEditor final : public QWidget {
    Q_OBJECT
public:
    explicit ProgramEditor(QWidget* parent = nullptr);
    /// Adds a button to the bar above the text for the action that moves this widget between panel and dock.
    void offer(QAction& move);
    void setDocked(bool docked);
    void setUnit(LengthUnit unit);
    void setState(const ProgramState& state); ///< never emits
    std::size_t errors() const;               ///< number of findings that prevent the program from passing the check
    int line() const;                         ///< the line of the text cursor, from 1
    void showLine(int line);                  ///< from 1; emits no signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1; playback stops at them
    /// @param state of the machine after the selected line; empty: no line is selected
    void showMachineState(const QString& state);
    void startSearch();
    void tellTextNow(); ///< reports typed text that has not been reported yet

    bool hasHeightForWidth() const override { return false; } ///< its parts have it, and share the available height
    QSize sizeHint() const override;

signals:
    void textEdited(const QString& text); ///< by the user
    void textCheckRequested();            ///< check of the edited text
    void lineChosen(int line);            ///< from 1; also by a click on a finding
    void breakpointToggled(int line);     ///< from 1

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();
    void refresh();
    void gather();
    void gatherNearPasses(const std::vector<NearPass>& passes);
    std::vector<ListRow> rows() const;

    ProgramState state_;
    LengthUnit unit_ = LengthUnit::millimetre;
    std::vector<LineMark> marks_; ///< findings of the check and lines that the control may reject, one per row
    QBoxLayout* parts_;
    QWidget* side_; ///< the findings and the button that repeats the check
    RowList* findings_;
    QPushButton* checkText_;
    ProgramText* text_;
    bool docked_ = false;
};

} // namespace burin
