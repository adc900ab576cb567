// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_view.h"

#include "ui/panels/program_words.h"
#include "ui/theme/colour.h"

#include <QFontDatabase>
#include <QPaintEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QTextBlock>
#include <QTextLayout>

namespace burin {

namespace {

constexpr int numberPadding = 8;
constexpr double lineTint = 0.08;
constexpr int linesASlice = 3000; // about 20 ms
constexpr int coloured = 1;       // state of a block whose words have their colours

QList<QTextLayout::FormatRange> colours(const QString& line) {
    QList<QTextLayout::FormatRange> ranges;
    for (const ProgramWord& word : programWords(line)) {
        QTextLayout::FormatRange range;
        range.start = word.start;
        range.length = word.length;
        range.format.setForeground(activePalette().*roleOf(word.kind));
        ranges.append(range);
    }
    return ranges;
}

} // namespace

/// The strip with the line numbers.
class ProgramView::Margin : public QWidget {
public:
    explicit Margin(ProgramView* view) : QWidget(view), view_(view) {}
    QSize sizeHint() const override { return {view_->marginWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { view_->paintNumbers(event); }

private:
    ProgramView* view_;
};

ProgramView::ProgramView(QWidget* parent) : QPlainTextEdit(parent), margin_(new Margin(this)) {
    setReadOnly(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setTabChangesFocus(true);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setUndoRedoEnabled(false);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(9.5);
    setFont(fixed);
    filling_.setSingleShot(true);
    connect(&filling_, &QTimer::timeout, this, [this] {
        if (!complete()) fill(linesASlice);
    });
    connect(this, &QPlainTextEdit::blockCountChanged, this, &ProgramView::placeMargin);
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
        if (dy != 0)
            margin_->scroll(0, dy);
        else
            margin_->update(0, rect.y(), margin_->width(), rect.height());
    });
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        markCurrentLine();
        const int line = textCursor().blockNumber() + 1;
        if (quiet_ || line == chosen_) return;
        chosen_ = line;
        emit lineChosen(line);
    });
    placeMargin();
}

void ProgramView::showProgram(const QString& text) {
    if (text == text_) return;
    const QScopedValueRollback quiet(quiet_, true);
    text_ = text;
    filled_ = 0;
    clear();
    fill(linesASlice);
    chosen_ = 1;
    moveCursor(QTextCursor::Start);
    markCurrentLine();
}

void ProgramView::fill(int lines) {
    const QScopedValueRollback quiet(quiet_, true);
    qsizetype end = filled_;
    for (int i = 0; i < lines && end < text_.size(); ++i) {
        const qsizetype next = text_.indexOf(QLatin1Char('\n'), end);
        end = next < 0 ? text_.size() : next + 1;
    }
    QTextCursor cursor(document());
    cursor.movePosition(QTextCursor::End);
    cursor.insertText(text_.mid(filled_, end - filled_));
    filled_ = end;
    if (!complete()) filling_.start();
}

void ProgramView::showLine(int line) {
    if (line >= blockCount() && !complete()) fill(line - blockCount() + linesASlice);
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (!block.isValid()) return;
    const QScopedValueRollback quiet(quiet_, true);
    chosen_ = line;
    setTextCursor(QTextCursor(block));
    centerCursor();
}

int ProgramView::marginWidth() const {
    const int digits = std::max(3, static_cast<int>(QString::number(blockCount()).size()));
    return 2 * numberPadding + digits * fontMetrics().horizontalAdvance(QLatin1Char('0'));
}

void ProgramView::placeMargin() {
    setViewportMargins(marginWidth(), 0, 0, 0);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), marginWidth(), inside.height());
}

void ProgramView::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    placeMargin();
}

void ProgramView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) block.setUserState(-1);
    markCurrentLine();
}

void ProgramView::colourSeen() {
    const double bottom = viewport()->height();
    double top = blockBoundingGeometry(firstVisibleBlock()).translated(contentOffset()).top();
    for (QTextBlock block = firstVisibleBlock(); block.isValid() && top <= bottom; block = block.next()) {
        top += blockBoundingRect(block).height();
        if (block.userState() == coloured) continue;
        block.setUserState(coloured);
        block.layout()->setFormats(colours(block.text()));
    }
}

void ProgramView::paintEvent(QPaintEvent* event) {
    colourSeen(); // colours alone: no line changes its size
    QPlainTextEdit::paintEvent(event);
}

void ProgramView::markCurrentLine() {
    QTextEdit::ExtraSelection line;
    line.format.setBackground(mixed(activePalette().field, activePalette().accent, lineTint));
    line.format.setProperty(QTextFormat::FullWidthSelection, true);
    line.cursor = textCursor();
    line.cursor.clearSelection();
    setExtraSelections({line});
    margin_->update();
}

void ProgramView::paintNumbers(QPaintEvent* event) {
    QPainter painter(margin_);
    const Palette& palette = activePalette();
    painter.fillRect(event->rect(), mixed(palette.field, palette.panel, 0.5));
    painter.setFont(font());
    const int current = textCursor().blockNumber();
    QTextBlock block = firstVisibleBlock();
    double top = blockBoundingGeometry(block).translated(contentOffset()).top();
    for (; block.isValid() && top <= event->rect().bottom(); block = block.next()) {
        const double height = blockBoundingRect(block).height();
        painter.setPen(block.blockNumber() == current ? palette.accent : palette.quietText);
        painter.drawText(QRectF(0.0, top, margin_->width() - numberPadding, height), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
        top += height;
    }
}

} // namespace burin
