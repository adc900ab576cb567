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

/// The text of the program together with the findings of its check. Stands in the program panel, the findings below the
/// text, or in a dock, where they stand side by side when that is wider than high. Findings take their room from the
/// text: around it nothing moves as they come and go.
class ProgramEditor final : public QWidget {
    Q_OBJECT
public:
    explicit ProgramEditor(QWidget* parent = nullptr);
    /// Adds a button for it to the bar above the text: the action that moves this widget between panel and dock.
    void offer(QAction& move);
    void setDocked(bool docked);
    void setUnit(LengthUnit unit);
    void setState(const ProgramState& state);        ///< never emits
    std::size_t errors() const;                      ///< findings that keep the program from passing
    int line() const;                                ///< from 1: where the cursor stands in the text
    void showLine(int line);                         ///< from 1; without a signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1, at which a play stops
    /// @param state of the machine when the chosen line is done; empty: no line is chosen
    void showMachineState(const QString& state);
    void startSearch();
    void tellTextNow(); ///< what was typed and is not reported yet

    bool hasHeightForWidth() const override { return false; } ///< its parts have, and share the height that it has
    QSize sizeHint() const override;

signals:
    void textEdited(const QString& text); ///< by the user
    void textCheckRequested();            ///< of the text as it was edited
    void lineChosen(int line);            ///< from 1; by a click on a finding as well
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
    std::vector<LineMark> marks_; ///< what the check found and what the control may not take, a row each
    QBoxLayout* parts_;
    QWidget* side_; ///< the findings and the button that checks again
    RowList* findings_;
    QPushButton* checkText_;
    ProgramText* text_;
    bool docked_ = false;
};

} // namespace burin
