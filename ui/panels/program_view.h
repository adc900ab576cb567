// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include <set>
#include <vector>

namespace burin {

/// A finding at a line of a program.
struct LineMark {
    int line = 1; ///< from 1
    enum class Kind { warning, error } kind = Kind::error;
    QString text; ///< for the tooltip
};

/// Shows the text of a program, and edits it while it is editable: line numbers, coloured words, the current line
/// marked. Only visible lines are coloured, and a long program is loaded in slices of some ms, so that the window never
/// waits for it.
class ProgramView : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit ProgramView(QWidget* parent = nullptr);
    void showProgram(const QString& text);        ///< does nothing if it is already shown
    int line() const noexcept { return chosen_; } ///< the line of the text cursor, from 1
    void showLine(int line);                      ///< from 1; scrolls it into view and emits no signal
    /// The text is loaded completely before it becomes editable. Editing has its own undo history.
    void setEditable(bool editable);
    const QString& program() const noexcept { return text_; } ///< as it is now
    /// In any order; a line with several marks is shown in the colour of the most severe one.
    void setMarks(std::vector<LineMark> marks);
    void setBreakpoints(std::set<int> lines); ///< from 1; their line numbers are drawn on a bar
    /// Moves to the next (or previous) occurrence of a text from the cursor, case-insensitive, wrapping around at the
    /// end; emits `lineChosen`. @return false if there is no occurrence
    bool find(const QString& wanted, bool backward);
    qsizetype occurrences(const QString& wanted) const;
    bool complete() const noexcept { return filled_ == text_.size(); } ///< whether the program is loaded completely

signals:
    void edited();                    ///< the user changed the text
    void lineChosen(int line);        ///< from 1; the user moved the cursor there
    void breakpointToggled(int line); ///< from 1; by a click on its number
    void typedWhileLocked();          ///< the user pressed a key that enters text while the text is read-only

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override; ///< typing keys are handled by the text only, not as shortcuts
    void keyPressEvent(QKeyEvent* event) override;

private:
    class Margin;
    void paintNumbers(QPaintEvent* event);
    int marginWidth() const;
    void placeMargin();
    void colourSeen();
    void markCurrentLine();
    void paintMark(QPainter& painter, const LineMark& mark, double top, double height) const;
    const LineMark* markOf(int line) const;
    QString marksText(int line) const;
    void fill(int lines);

    Margin* margin_ = nullptr;
    QString text_;
    std::vector<LineMark> marks_; ///< by line, the most severe of each line first
    std::set<int> breakpoints_;
    qsizetype filled_ = 0; ///< number of its characters that are loaded
    QTimer filling_;
    int chosen_ = 1;
    bool quiet_ = false;
};

} // namespace burin
