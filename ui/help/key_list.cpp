// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/help/key_list.h"

#include "ui/panels/buttons.h"
#include "ui/panels/panel_layout.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr QSize usualSize(820, 640); // pixels
constexpr std::size_t columns = 2;

} // namespace

KeyList::KeyList(const std::vector<KeySection>& sections, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("keyList"));
    setWindowTitle(tr("Keys and mouse"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 16);
    layout->setSpacing(16);
    auto* search = new QLineEdit(this);
    search->setObjectName(QStringLiteral("keySearch"));
    search->setPlaceholderText(tr("Search for a key or its effect"));
    search->setAccessibleName(search->placeholderText());
    search->setToolTip(tr("Only lines that contain this text are shown."));
    search->setClearButtonEnabled(true);
    connect(search, &QLineEdit::textChanged, this, &KeyList::showOnly);
    layout->addWidget(search);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setAccessibleName(windowTitle());
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(columnsOf(sections));
    alignKeys();
    layout->addWidget(area, 1);
    nothing_ = new QLabel(tr("No key does that."), this);
    nothing_->setObjectName(QStringLiteral("keyListEmpty"));
    nothing_->setProperty("look", "quiet");
    nothing_->hide();
    layout->addWidget(nothing_);
    layout->addWidget(makeCloseRow(*this));
    resize(usualSize);
}

/// Each section is added to the column with fewer lines so far.
QWidget* KeyList::columnsOf(const std::vector<KeySection>& sections) {
    auto* whole = new QWidget;
    auto* beside = new QHBoxLayout(whole);
    beside->setContentsMargins(0, 0, 8, 0);
    beside->setSpacing(32);
    std::array<QVBoxLayout*, columns> column{};
    std::array<std::size_t, columns> lines{};
    for (QVBoxLayout*& one : column) {
        one = new QVBoxLayout;
        one->setSpacing(24);
        beside->addLayout(one, 1);
    }
    for (const KeySection& section : sections) {
        const auto shortest = static_cast<std::size_t>(std::ranges::min_element(lines) - lines.begin());
        auto* box = new QWidget(whole);
        auto* rows = new QVBoxLayout(box);
        rows->setContentsMargins(0, 0, 0, 0);
        rows->setSpacing(8);
        rows->addWidget(makeSectionTitle(section.title, box));
        auto* keys = new KeyLines(section.lines, box);
        rows->addWidget(keys);
        column[shortest]->addWidget(box);
        lines[shortest] += section.lines.size() + 2; // the title and the gap
        sections_.push_back({box, keys});
    }
    for (QVBoxLayout* one : column) one->addStretch(1);
    return whole;
}

/// Aligns the descriptions in all sections.
void KeyList::alignKeys() {
    int widest = 0;
    for (const Shown& section : sections_) widest = std::max(widest, section.lines->keyWidth());
    for (const Shown& section : sections_) section.lines->setKeyWidth(widest);
}

void KeyList::showOnly(const QString& text) {
    bool any = false;
    for (const Shown& section : sections_) {
        const bool shown = section.lines->showOnly(text.trimmed());
        section.whole->setVisible(shown);
        any = any || shown;
    }
    nothing_->setVisible(!any);
}

} // namespace burin
