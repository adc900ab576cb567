// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include <set>
#include <vector>

namespace burin {

/// What a line of a program is to be looked at for.
struct LineMark {
    int line = 1; ///< from 1
    enum class Kind { warning, error } kind = Kind::error;
    QString text; ///< for the tooltip
};

/// A program to read, and to write while it is editable: line numbers, coloured words, the current line marked. Only
/// lines that are seen are coloured, and a long program comes in by slices of some ms, so that the window never waits
/// for it.
class ProgramView : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit ProgramView(QWidget* parent = nullptr);
    void showProgram(const QString& text);        ///< nothing is done when it shows it
    int line() const noexcept { return chosen_; } ///< from 1: where the cursor stands
    void showLine(int line);                      ///< from 1; brings it into view, without a signal
    /// All of the text has come in when it becomes editable. Editing has an undo of its own.
    void setEditable(bool editable);
    const QString& program() const noexcept { return text_; } ///< as it is now
    /// In any order; a line with several is shown in the colour of the worst.
    void setMarks(std::vector<LineMark> marks);
    void setBreakpoints(std::set<int> lines); ///< from 1; their numbers stand on a bar
    /// Goes to the next place behind the cursor (or the one before it) where a text stands, whatever its case, and on
    /// from the other end where there is none; tells the line. @return false: it stands nowhere
    bool find(const QString& wanted, bool backward);
    qsizetype occurrences(const QString& wanted) const;
    bool complete() const noexcept { return filled_ == text_.size(); } ///< all of the program has come in

signals:
    void edited();                    ///< the user changed the text
    void lineChosen(int line);        ///< from 1; the user put the cursor there
    void breakpointToggled(int line); ///< from 1; by a click on its number
    void typedWhileLocked();          ///< a key that would have written something, while the text can't be edited

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override; ///< keys that write are the text's alone
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
    std::vector<LineMark> marks_; ///< by line, the worst of each first
    std::set<int> breakpoints_;
    qsizetype filled_ = 0; ///< characters of it that have come in
    QTimer filling_;
    int chosen_ = 1;
    bool quiet_ = false;
};

} // namespace burin
