// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/program_view.h"

#include "ui/panels/focus_keeper.h"
#include "ui/panels/program_labels.h"
#include "ui/theme/colour.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QTextBlock>
#include <QTextLayout>
#include <QToolTip>

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr int numberPadding = 8, lintMarkWidth = 10;
constexpr double lineTint = 0.08;
constexpr int linesASlice = 3000; // about 20 ms
constexpr int coloured = 1;       // state of a block whose words are coloured

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

/// The margin with the line numbers.
class ProgramView::Margin : public QWidget {
public:
    explicit Margin(ProgramView* view) : QWidget(view), view_(view) { setObjectName(QStringLiteral("programNumbers")); }
    QSize sizeHint() const override { return {view_->marginWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { view_->paintNumbers(event); }
    bool event(QEvent* event) override {
        if (event->type() != QEvent::ToolTip) return QWidget::event(event);
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString marks = view_->marksText(lineAt(help->pos()));
        QToolTip::showText(help->globalPos(),
                           marks.isEmpty() ? tr("Click a line's number to stop a play there") : marks, this);
        return true;
    }
    void mousePressEvent(QMouseEvent* event) override {
        if (event->button() == Qt::LeftButton) emit view_->breakpointToggled(lineAt(event->pos()));
    }

private:
    int lineAt(const QPoint& place) const { return view_->cursorForPosition(QPoint(0, place.y())).blockNumber() + 1; }

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
    connect(document(), &QTextDocument::contentsChange, this, [this](int place, int, int added) {
        if (quiet_) return;
        QTextBlock block = document()->findBlock(place);
        for (; block.isValid() && block.position() <= place + added; block = block.next()) block.setUserState(-1);
    });
    connect(this, &QPlainTextEdit::textChanged, this, [this] {
        if (quiet_ || isReadOnly()) return;
        text_ = toPlainText();
        filled_ = text_.size();
        emit edited();
    });
    placeMargin();
}

void ProgramView::setEditable(bool editable) {
    if (editable == !isReadOnly()) return;
    if (!complete()) fill(std::numeric_limits<int>::max());
    const QScopedValueRollback quiet(quiet_, true);
    setUndoRedoEnabled(editable);
    setReadOnly(!editable);
    setTextInteractionFlags(editable ? Qt::TextEditorInteraction
                                     : Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
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

void ProgramView::setBreakpoints(std::set<int> lines) {
    breakpoints_ = std::move(lines);
    margin_->update();
}

void ProgramView::setMarks(std::vector<LineMark> marks) {
    marks_ = std::move(marks);
    std::ranges::stable_sort(marks_, [](const LineMark& a, const LineMark& b) {
        return a.line != b.line ? a.line < b.line : a.kind > b.kind;
    });
    margin_->update();
}

const LineMark* ProgramView::markOf(int line) const {
    const auto found = std::ranges::lower_bound(marks_, line, {}, &LineMark::line);
    return found == marks_.end() || found->line != line ? nullptr : &*found;
}

QString ProgramView::marksText(int line) const {
    QStringList texts;
    for (const LineMark& mark : marks_)
        if (mark.line == line) texts.append(mark.text);
    return texts.join(QLatin1Char('\n'));
}

qsizetype ProgramView::occurrences(const QString& wanted) const {
    return wanted.isEmpty() ? 0 : text_.count(wanted, Qt::CaseInsensitive);
}

bool ProgramView::find(const QString& wanted, bool backward) {
    if (occurrences(wanted) == 0) return false;
    if (!complete()) fill(std::numeric_limits<int>::max());
    const QTextDocument::FindFlags flags = backward ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    QTextCursor found = document()->find(wanted, textCursor(), flags);
    if (found.isNull()) {
        QTextCursor end(document());
        if (backward) end.movePosition(QTextCursor::End);
        found = document()->find(wanted, end, flags);
    }
    if (found.isNull()) return false; // the text spans a line break
    setTextCursor(found);
    centerCursor();
    return true;
}

int ProgramView::marginWidth() const {
    const int digits = std::max(3, static_cast<int>(QString::number(blockCount()).size()));
    return lintMarkWidth + 2 * numberPadding + digits * fontMetrics().horizontalAdvance(QLatin1Char('0'));
}

void ProgramView::placeMargin() {
    setViewportMargins(marginWidth(), 0, 0, 0);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), marginWidth(), inside.height());
}

void ProgramView::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    placeMargin();
    if (!isReadOnly()) ensureCursorVisible(); // the typed text stays visible when something appears above the editor
}

void ProgramView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() != QEvent::PaletteChange && event->type() != QEvent::StyleChange) return;
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) block.setUserState(-1);
    markCurrentLine();
}

/// Also while the text is read-only: a user who clicks into the text and types "G1" wants neither guides nor the top
/// view.
bool ProgramView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && isTyped(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QPlainTextEdit::event(event);
}

void ProgramView::keyPressEvent(QKeyEvent* event) {
    if (!isReadOnly() || !isTyped(*event)) return QPlainTextEdit::keyPressEvent(event);
    event->accept();
    emit typedWhileLocked();
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
    colourSeen(); // changes only colours: no line changes its size
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

/// An error is a square, a warning a triangle, so that they are not distinguished by colour alone.
void ProgramView::paintMark(QPainter& painter, const LineMark& mark, double top, double height) const {
    const Palette& palette = activePalette();
    const double side = 8.0, left = 4.0, up = top + 0.5 * (height - side);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    if (mark.kind == LineMark::Kind::error) {
        painter.setBrush(palette.force);
        painter.drawRect(QRectF(left, up, side, side));
    } else {
        painter.setBrush(palette.accent);
        painter.drawPolygon(QPolygonF{{left, up + side}, {left + 0.5 * side, up}, {left + side, up + side}});
    }
    painter.restore();
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
        const bool stops = breakpoints_.contains(block.blockNumber() + 1);
        if (stops)
            painter.fillRect(QRectF(lintMarkWidth + 2.0, top, margin_->width() - lintMarkWidth - 2.0, height),
                             palette.accent);
        painter.setPen(stops ? palette.field : block.blockNumber() == current ? palette.accent : palette.quietText);
        painter.drawText(QRectF(0.0, top, margin_->width() - numberPadding, height), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
        if (const LineMark* mark = markOf(block.blockNumber() + 1)) paintMark(painter, *mark, top, height);
        top += height;
    }
}

} // namespace burin
