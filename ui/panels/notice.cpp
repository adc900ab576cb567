// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/notice.h"

#include "ui/panels/announcement.h"
#include "ui/panels/panel_layout.h"
#include "ui/theme/colour.h"
#include "ui/theme/icon.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

#include <algorithm>

namespace burin {

namespace {

constexpr int noticeIconSize = 18, noticePaddingAcross = 12, noticePaddingAlong = 8, noticeGap = 8;
constexpr double tint = 0.12, noticeCorner = 8.0;
constexpr int keptLines = 3; // of a NoticePlace
constexpr int footGap = 4;   // pixels

ColourRole roleOf(Notice::Kind kind) {
    switch (kind) {
    case Notice::Kind::information:
        return &Palette::part;
    case Notice::Kind::passed:
        return &Palette::inOrder;
    case Notice::Kind::warning:
        return &Palette::accent;
    case Notice::Kind::error:
        return &Palette::force;
    }
    return &Palette::text;
}

QString iconOf(Notice::Kind kind) {
    switch (kind) {
    case Notice::Kind::information:
        return QStringLiteral("information");
    case Notice::Kind::passed:
        return QStringLiteral("passed");
    case Notice::Kind::warning:
        return QStringLiteral("warning");
    case Notice::Kind::error:
        return QStringLiteral("error");
    }
    return {};
}

/// The part of a wrapped text that fits into a number of lines.
QString beginningOf(const QString& text, const QFontMetrics& font, int width, int lines) {
    const QRect room(0, 0, width, 1 << 20);
    const auto fits = [&](const QString& part) {
        return font.boundingRect(room, Qt::TextWordWrap, part).height() <= lines * font.lineSpacing();
    };
    if (fits(text)) return text;
    qsizetype kept = 0, tooMuch = text.size();
    while (tooMuch - kept > 1) {
        const qsizetype middle = (kept + tooMuch) / 2;
        (fits(text.left(middle).trimmed() + QChar(0x2026)) ? kept : tooMuch) = middle;
    }
    return text.left(kept).trimmed() + QChar(0x2026);
}

} // namespace

Notice::Notice(QWidget* parent) : QFrame(parent), text_(makeWrappedLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(noticePaddingAcross + noticeIconSize + noticeGap, noticePaddingAlong, noticePaddingAcross,
                            noticePaddingAlong);
    row->addWidget(text_);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    hide();
}

void Notice::tell(Kind kind, const QString& sentence) {
    if (sentence == sentence_ && kind == kind_) return;
    update();
    kind_ = kind;
    sentence_ = sentence;
    showText(width());
    const QString kindName = kind == Kind::warning ? tr("Warning") : kind == Kind::error ? tr("Error") : QString();
    setAccessibleName(kindName.isEmpty() ? sentence : kindName + QStringLiteral(": ") + sentence);
    setVisible(!sentence.isEmpty());
    announce(*this);
    emit told();
}

QString Notice::sentence() const {
    return sentence_;
}

void Notice::setMaximumLines(int lines) {
    maximumLines_ = lines;
    showText(width());
}

int Notice::fitTo(int width) {
    showText(width);
    const QMargins margins = layout()->contentsMargins();
    return margins.top() + text_->heightForWidth(width - margins.left() - margins.right()) + margins.bottom();
}

int Notice::heightOfLines(int lines) const {
    return 2 * noticePaddingAlong + lines * text_->fontMetrics().lineSpacing();
}

void Notice::showText(int width) {
    if (maximumLines_ > 0) text_->clear(); // it may contain only a part of the sentence
    setWrappedText(text_, sentence_);
    if (maximumLines_ == 0) return;
    const QMargins margins = layout()->contentsMargins();
    const int room = width - margins.left() - margins.right();
    const QString whole = text_->text(), shown = beginningOf(whole, text_->fontMetrics(), room, maximumLines_);
    text_->setText(shown);
    setToolTip(shown == whole ? QString() : sentence_);
}

void Notice::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    if (maximumLines_ > 0) showText(width());
}

void Notice::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(activePalette().panel, activePalette().*roleOf(kind_), tint));
    painter.drawRoundedRect(rect(), noticeCorner, noticeCorner);
    themedIcon(iconOf(kind_), roleOf(kind_))
        .paint(&painter, {noticePaddingAcross, noticePaddingAlong, noticeIconSize, noticeIconSize});
}

NoticePlace::NoticePlace(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

Notice* NoticePlace::add(const char* name) {
    auto* notice = new Notice(this);
    notice->setObjectName(QLatin1String(name));
    notice->setMaximumLines(keptLines);
    notices_.push_back(notice);
    connect(notice, &Notice::told, this, &NoticePlace::showFirst);
    return notice;
}

void NoticePlace::setFoot(QWidget* foot) {
    foot_ = foot;
    foot_->setParent(this);
    foot_->hide();
    updateGeometry();
}

void NoticePlace::setFootRequested(bool wanted) {
    if (wanted == footRequested_) return;
    footRequested_ = wanted;
    for (Notice* notice : notices_) notice->setMaximumLines(wanted ? 1 : keptLines);
    foot_->setVisible(wanted);
    showFirst();
}

QSize NoticePlace::sizeHint() const {
    if (notices_.empty()) return {200, 0};
    const Notice& any = *notices_.front();
    const int withFoot = foot_ != nullptr ? any.heightOfLines(1) + footGap + foot_->sizeHint().height() : 0;
    return {200, std::max(any.heightOfLines(keptLines), withFoot)};
}

void NoticePlace::showFirst() {
    const auto first =
        std::ranges::find_if(notices_, [](const Notice* notice) { return !notice->sentence().isEmpty(); });
    for (auto it = notices_.begin(); it != notices_.end(); ++it) (*it)->setVisible(it == first);
    if (first == notices_.end()) return;
    // Not by a resize, which a hidden notice hears of only when it is shown.
    (*first)->resize(width(), std::min(height(), (*first)->fitTo(width())));
    if (footRequested_) foot_->setGeometry(0, (*first)->height() + footGap, width(), foot_->sizeHint().height());
}

void NoticePlace::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showFirst();
}

} // namespace burin
