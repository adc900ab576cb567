// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/program_view.h"

#include <QTimer>
#include <QWidget>

#include <set>

class QAction;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace burin {

/// A program's text, with a search bar above it and the machine's state after the selected line below it.
class ProgramText : public QWidget {
    Q_OBJECT
public:
    explicit ProgramText(QWidget* parent = nullptr);

    void offer(QAction& action);                     ///< adds a button for the action to the right of the search field
    void showProgram(const QString& text);           ///< does nothing if it is already shown
    int line() const;                                ///< the line of the text cursor, from 1
    void showLine(int line);                         ///< from 1; scrolls it into view and emits no signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1; playback stops at them
    void setMarks(std::vector<LineMark> marks);
    /// @param state of the machine after the selected line; empty: nothing to show
    void showState(const QString& state);
    bool editable() const;
    void tellNow(); ///< reports typed text that has not been reported yet
    /// Moves the keyboard focus to the search field and selects its text.
    void startSearch();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< handles Enter and Esc in the search field

signals:
    void textEdited(const QString& text); ///< by the user, some time after the last key
    void lineChosen(int line);            ///< from 1; the user or a search moved the cursor there
    void breakpointToggled(int line);     ///< from 1

private:
    void search(bool backward);
    void tell();
    void told();
    void hintAtEditing();

    QHBoxLayout* bar_;
    QLineEdit* wanted_;
    QToolButton *edit_, *previous_, *next_;
    QLabel *found_, *state_;
    ProgramView* view_;
    QTimer settled_;
};

} // namespace burin
