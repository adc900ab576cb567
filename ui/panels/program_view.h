// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

namespace burin {

/// A program to read: line numbers, coloured words, the current line marked. Only lines that are seen are coloured, and
/// a long program comes in by slices of some ms, so that the window never waits for it.
class ProgramView : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit ProgramView(QWidget* parent = nullptr);
    void showProgram(const QString& text); ///< nothing is done when it shows it
    void showLine(int line);               ///< from 1; brings it into view, without a signal
    bool complete() const noexcept { return filled_ == text_.size(); } ///< all of the program has come in

signals:
    void lineChosen(int line); ///< from 1; the user put the cursor there

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    class Margin;
    void paintNumbers(QPaintEvent* event);
    int marginWidth() const;
    void placeMargin();
    void colourSeen();
    void markCurrentLine();
    void fill(int lines);

    Margin* margin_ = nullptr;
    QString text_;
    qsizetype filled_ = 0; ///< characters of it that have come in
    QTimer filling_;
    int chosen_ = 1;
    bool quiet_ = false;
};

} // namespace burin
