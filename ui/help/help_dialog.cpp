// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/help/help_dialog.h"

#include "core/base/file.h"
#include "ui/help/help_browser.h"
#include "ui/panels/buttons.h"
#include "ui/theme/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace burin {

namespace {

constexpr QSize helpSize(900, 640);                // pixels
constexpr int topicWidth = 220, topicMargins = 24; // pixels
constexpr std::array topics{"start", "part", "stock", "tool", "mill", "time", "path", "program", "window"};

/// Empty text: the page does not exist in that language.
HelpPage pageIn(const QString& language, const char* topic) {
    const std::filesystem::path folder = resourceDirectory() / "help" / language.toStdString();
    const Result<std::string> read = readFile(folder / (std::string(topic) + ".md"));
    const QString text = read ? QString::fromStdString(*read) : QString();
    return {QString::fromLatin1(topic), text.section(QLatin1Char('\n'), 0, 0).remove(0, 2), text,
            QString::fromStdString(folder.string())};
}

/// Whether a page contains every word of a text; names of files do not count.
bool holds(const HelpPage& page, const QString& text) {
    static const QRegularExpression file(QStringLiteral("\\]\\([^)]*\\)"));
    const QString words = QString(page.text).remove(file);
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        if (!words.contains(word, Qt::CaseInsensitive)) return false;
    return true;
}

} // namespace

std::vector<HelpPage> helpPages(const QString& language) {
    std::vector<HelpPage> pages;
    for (const char* topic : topics) {
        HelpPage page = pageIn(language, topic);
        if (page.text.isEmpty()) page = pageIn(language.section(QLatin1Char('_'), 0, 0), topic);
        if (page.text.isEmpty()) page = pageIn(QStringLiteral("en"), topic);
        if (!page.text.isEmpty()) pages.push_back(std::move(page)); // empty: an installation without help pages
    }
    return pages;
}

HelpDialog::HelpDialog(std::vector<HelpPage> pages, QWidget* parent) : QDialog(parent), pages_(std::move(pages)) {
    setObjectName(QStringLiteral("helpDialog"));
    setWindowTitle(tr("Help"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 24, 24, 16);
    layout->setSpacing(16);
    search_ = new QLineEdit(this);
    search_->setObjectName(QStringLiteral("helpSearch"));
    search_->setPlaceholderText(tr("Search the help"));
    search_->setAccessibleName(tr("Search the help"));
    search_->setToolTip(tr("Only topics that contain these words are shown."));
    search_->setClearButtonEnabled(true);
    layout->addWidget(search_);
    auto* row = new QHBoxLayout;
    topics_ = new QListWidget(this);
    topics_->setObjectName(QStringLiteral("helpTopics"));
    topics_->setAccessibleName(tr("Topics"));
    for (const HelpPage& page : pages_) topics_->addItem(page.title);
    topics_->ensurePolished(); // the width depends on the font of the style
    topics_->setFixedWidth(std::max(topicWidth, topics_->sizeHintForColumn(0) + topicMargins));
    row->addWidget(topics_);
    page_ = new HelpBrowser(this);
    page_->setObjectName(QStringLiteral("helpPage"));
    page_->setAccessibleName(tr("Page of the help"));
    row->addWidget(page_, 1);
    layout->addLayout(row, 1);
    nothing_ = new QLabel(tr("No topic contains these words."), this);
    nothing_->setObjectName(QStringLiteral("helpEmpty"));
    nothing_->setProperty("look", "quiet");
    nothing_->hide();
    layout->addWidget(nothing_);
    layout->addWidget(makeCloseRow(*this));
    connect(search_, &QLineEdit::textChanged, this, &HelpDialog::showOnly);
    connect(topics_, &QListWidget::currentRowChanged, this, &HelpDialog::showPage);
    topics_->setCurrentRow(0);
    resize(helpSize);
}

void HelpDialog::showTopic(const QString& topic) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        if (pages_[i].topic != topic) continue;
        search_->clear();
        topics_->setCurrentRow(static_cast<int>(i));
    }
}

void HelpDialog::showOnly(const QString& text) {
    int first = -1;
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        const int row = static_cast<int>(i);
        const bool fits = holds(pages_[i], text);
        topics_->item(row)->setHidden(!fits);
        if (fits && first < 0) first = row;
    }
    nothing_->setVisible(first < 0);
    if (first >= 0 && (topics_->currentRow() < 0 || topics_->currentItem()->isHidden())) topics_->setCurrentRow(first);
    mark(text);
}

void HelpDialog::showPage(int row) {
    if (row < 0 || static_cast<std::size_t>(row) >= pages_.size()) return;
    const HelpPage& page = pages_[static_cast<std::size_t>(row)];
    page_->showPage(page.text, page.folder);
    mark(search_->text());
}

/// Highlights the search text in the page.
void HelpDialog::mark(const QString& text) {
    QList<QTextEdit::ExtraSelection> found;
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        for (QTextCursor at = page_->document()->find(word); !at.isNull(); at = page_->document()->find(word, at)) {
            QTextEdit::ExtraSelection selection;
            selection.cursor = at;
            selection.format.setBackground(activePalette().accent);
            selection.format.setForeground(activePalette().field);
            found.append(selection);
        }
    }
    page_->setExtraSelections(found);
    if (!found.isEmpty()) {
        QTextCursor first = found.front().cursor;
        first.clearSelection();
        page_->setTextCursor(first);
        page_->ensureCursorVisible();
    }
}

} // namespace burin
