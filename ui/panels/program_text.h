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

/// A program's text with a search above it, and below it what the machine is like when the chosen line is done.
class ProgramText : public QWidget {
    Q_OBJECT
public:
    explicit ProgramText(QWidget* parent = nullptr);

    void offer(QAction& action);                     ///< by a button on the right of the search
    void showProgram(const QString& text);           ///< nothing is done when it shows it
    int line() const;                                ///< from 1: where the cursor stands
    void showLine(int line);                         ///< from 1; brings it into view, without a signal
    void setBreakpoints(const std::set<int>& lines); ///< from 1, at which a play stops
    void setMarks(std::vector<LineMark> marks);
    /// @param state of the machine when the chosen line is done; empty: there is nothing to tell
    void showState(const QString& state);
    bool editable() const;
    void tellNow(); ///< what was typed and not told yet
    /// The keyboard goes to the search, what stood there is chosen.
    void startSearch();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< Enter and Esc in the search

signals:
    void textEdited(const QString& text); ///< by the user, some time after the last key
    void lineChosen(int line);            ///< from 1; the user put the cursor there, or a search led there
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
