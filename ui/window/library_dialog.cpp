// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/library_dialog.h"

#include "ui/dialogs/questions.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/notice.h"
#include "ui/panels/row_list.h"

#include <QBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>

#include <algorithm>

namespace burin {

namespace {

constexpr int listWidth = 310; // pixels

void addKey(QPushButton* button, const QKeySequence& key, const QString& toolTip) {
    button->setShortcut(key);
    button->setToolTip(toolTip + QStringLiteral(" (") + key.toString(QKeySequence::NativeText) + QLatin1Char(')'));
}

} // namespace

LibraryDialog::LibraryDialog(Texts texts, QSize size, QWidget* parent) : QDialog(parent), texts_(std::move(texts)) {
    setObjectName(named("", "Dialog"));
    setWindowTitle(texts_.title);
    layOut();
    resize(size);
}

/// Surrounds the kind with two words, such as "copy" and "Button" around "Machine"; without a word before it the kind
/// begins with a lower-case letter.
QString LibraryDialog::named(const char* before, const char* after) const {
    QString kind = texts_.kind;
    if (*before == '\0') kind[0] = kind[0].toLower();
    return QLatin1String(before) + kind + QLatin1String(after);
}

void LibraryDialog::layOut() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 12);
    column->setSpacing(12);
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    row->addWidget(makeList());
    pageColumn_ = new QVBoxLayout;
    pageColumn_->setSpacing(8);
    title_ = new QLabel(this);
    title_->setProperty("look", "title");
    title_->setObjectName(named("", "Title"));
    pageColumn_->addWidget(title_);
    notice_ = new Notice(this);
    notice_->setObjectName(named("", "Notice"));
    pageColumn_->addWidget(notice_);
    row->addLayout(pageColumn_, 1);
    column->addLayout(row, 1);
    column->addWidget(makeFoot());
}

QWidget* LibraryDialog::makeList() {
    auto* side = new QWidget(this);
    side->setFixedWidth(listWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    search_ = new QLineEdit(side);
    search_->setObjectName(named("", "Search"));
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(tr("Show those that contain all of these words (Ctrl+F)"));
    search_->setAccessibleName(tr("Search"));
    search_->setClearButtonEnabled(true);
    column->addWidget(search_);
    connect(search_, &QLineEdit::textChanged, this, &LibraryDialog::refreshList);
    auto* finds = new QShortcut(QKeySequence::Find, this);
    connect(finds, &QShortcut::activated, search_, qOverload<>(&QWidget::setFocus));
    list_ = new RowList(side);
    list_->setObjectName(named("", "List"));
    list_->setAccessibleName(texts_.title);
    list_->setTextsWrap(true);
    list_->setFillsHeight(true);
    column->addWidget(list_, 1);
    auto* copies = makeButton(tr("Copy"), QStringLiteral("add"), named("copy", "Button"), side);
    addKey(copies, QKeySequence(Qt::CTRL | Qt::Key_D), texts_.copyTip);
    remove_ = makeButton(tr("Delete"), QStringLiteral("remove"), named("delete", "Button"), side);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(copies);
    buttons->addWidget(remove_);
    column->addLayout(buttons);
    listButtons_ = column;
    auto* add = addListButton(tr("Add from a file…"), QStringLiteral("import"), named("add", "Button"),
                              QKeySequence(Qt::CTRL | Qt::Key_O), texts_.addTip);
    connect(list_, &RowList::rowChosen, this, &LibraryDialog::choose);
    connect(copies, &QPushButton::clicked, this, &LibraryDialog::copyShown);
    connect(remove_, &QPushButton::clicked, this, &LibraryDialog::removeShown);
    connect(add, &QPushButton::clicked, this, &LibraryDialog::addFromFile);
    auto* deletes = new QShortcut(Qt::Key_Delete, list_);
    deletes->setContext(Qt::WidgetShortcut);
    connect(deletes, &QShortcut::activated, remove_, &QPushButton::click);
    return side;
}

QPushButton* LibraryDialog::addListButton(const QString& text, const QString& icon, const QString& name,
                                          const QKeySequence& key, const QString& toolTip) {
    auto* button = makeButton(text, icon, name, this);
    addKey(button, key, toolTip);
    listButtons_->addWidget(button);
    return button;
}

void LibraryDialog::addBelowList(QWidget* widget) {
    listButtons_->insertWidget(listButtons_->indexOf(list_) + 1, widget);
}

void LibraryDialog::addAboveList(QWidget* widget) {
    listButtons_->insertWidget(0, widget);
}

QWidget* LibraryDialog::makeFoot() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    footButtons_ = new QHBoxLayout;
    footButtons_->setSpacing(8);
    row->addLayout(footButtons_);
    row->addStretch(1);
    revert_ = makeButton(tr("Revert"), QStringLiteral("undo"), named("revert", "Button"), foot);
    save_ = makePrimaryButton(tr("Save"), named("save", "Button"), foot);
    auto* close = makeButton(tr("Close"), QStringLiteral("cancel"), named("close", "sButton"), foot);
    close->setToolTip(tr("Close this window (Esc)")); // the dialog handles the key, or a field while it is being edited
    for (QPushButton* button : {revert_, save_, close}) row->addWidget(button);
    connect(save_, &QPushButton::clicked, this, &LibraryDialog::saveChanges);
    connect(revert_, &QPushButton::clicked, this, [this] { showEntry(id_); });
    connect(close, &QPushButton::clicked, this, &LibraryDialog::reject);
    return foot;
}

QPushButton* LibraryDialog::addFootButton(const QString& text, const QString& icon, const QString& name) {
    auto* button = makeButton(text, icon, name, this);
    footButtons_->addWidget(button);
    return button;
}

void LibraryDialog::start(QWidget* page, const QString& nameField, const std::string& id) {
    page_ = page;
    nameField_ = nameField;
    page->setAccessibleName(texts_.title);
    pageColumn_->addWidget(page, 1);
    for (auto* button : findChildren<QPushButton*>()) button->setAutoDefault(false); // Enter belongs to the fields
    showEntry(id);
    list_->setFocus();
}

std::vector<LibraryDialog::Entry> LibraryDialog::foundEntries() const {
    std::vector<Entry> found = entries();
    const QStringList words = search_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::erase_if(found, [&](const Entry& entry) {
        const QString text =
            entry.name + QLatin1Char(' ') + QString::fromStdString(entry.id) + QLatin1Char(' ') + entry.detail;
        return !listed(entry) || !std::ranges::all_of(words, [&](const QString& word) {
            return text.contains(word, Qt::CaseInsensitive);
        });
    });
    return found;
}

void LibraryDialog::refreshList() {
    std::vector<ListRow> rows;
    int chosen = -1;
    for (const Entry& entry : foundEntries()) {
        ListRow row;
        row.title = row.toolTip = entry.name;
        row.badge = entry.shipped ? texts_.shippedBadge : tr("own");
        row.detail = entry.detail.isEmpty() ? QString::fromStdString(entry.id) : entry.detail;
        if (entry.inUse) row.detail += QStringLiteral(" · ") + tr("in use");
        if (entry.id == id_) chosen = static_cast<int>(rows.size());
        rows.push_back(row);
    }
    list_->setRows(rows);
    list_->setChosen(chosen);
}

bool LibraryDialog::lists(const std::string& id) const {
    const std::vector<Entry> all = entries();
    return std::ranges::find(all, id, &Entry::id) != all.end();
}

void LibraryDialog::refresh() {
    if (lists(id_) && edited()) {
        refreshList();
        follow();
    } else {
        showEntry(id_);
    }
}

void LibraryDialog::showEntry(const std::string& id) {
    const std::vector<Entry> all = entries();
    if (all.empty()) return;
    auto entry = std::ranges::find(all, id, &Entry::id);
    const auto isListed = [this](const Entry& one) { return listed(one); };
    if (entry == all.end())
        entry = std::ranges::find_if(all, [&](const Entry& one) { return one.inUse && isListed(one); });
    if (entry == all.end()) entry = std::ranges::find_if(all, isListed);
    if (entry == all.end()) entry = all.begin();
    id_ = entry->id;
    shipped_ = entry->shipped;
    title_->setText(entry->name);
    fill(id_, entry->shipped);
    notice_->tell(entry->shipped ? Notice::Kind::information : Notice::Kind::passed, about(entry->shipped));
    refreshList();
    follow();
}

void LibraryDialog::showListed() {
    const std::vector<Entry> found = foundEntries();
    if (found.empty() || std::ranges::find(found, id_, &Entry::id) != found.end())
        refreshList();
    else
        showEntry(found.front().id);
}

void LibraryDialog::follow() {
    const bool unsaved = edited();
    const QString fault = problem();
    if (unsaved)
        notice_->tell(fault.isEmpty() ? Notice::Kind::warning : Notice::Kind::error,
                      fault.isEmpty() ? tr("Changed, and not saved yet.") : fault);
    enableUnless(remove_, shipped_ ? texts_.notDeletable : QString(), texts_.deleteTip);
    const QString unchanged = unsaved ? QString() : tr("Nothing is changed.");
    enableUnless(save_, fault.isEmpty() ? unchanged : fault, tr("Keep the changed values (Ctrl+S)"));
    enableUnless(revert_, unchanged, tr("Discard the changes (Ctrl+R)"));
    save_->setShortcut(QKeySequence::Save);
    revert_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    followFoot();
}

void LibraryDialog::fail(const Error& error) {
    notice_->tell(Notice::Kind::error, Messages::sentence(error));
}

void LibraryDialog::warn(const QString& text) {
    notice_->tell(Notice::Kind::warning, text);
}

bool LibraryDialog::leaveChanges() {
    return !edited() || confirm(this, tr("Discard the changes of “%1”?").arg(title_->text()),
                                tr("They are not saved. This can't be undone."), tr("Discard"));
}

void LibraryDialog::choose(int row) {
    const std::vector<Entry> all = foundEntries();
    if (row < 0 || row >= static_cast<int>(all.size())) return;
    const std::string id = all[static_cast<std::size_t>(row)].id;
    if (id == id_) return;
    if (leaveChanges())
        showEntry(id);
    else
        refreshList();
}

void LibraryDialog::copyShown() {
    if (id_.empty() || !leaveChanges()) return;
    search_->clear(); // otherwise the copy may not match the search
    const std::string original = id_, made = copy(original);
    if (made == original) return; // as was reported
    showEntry(made);
    auto* name = page_->findChild<QLineEdit*>(nameField_);
    name->setFocus();
    name->selectAll();
}

void LibraryDialog::removeShown() {
    if (shipped_) return;
    const QString name = title_->text();
    const std::string id = id_;
    erase(id);
    const std::vector<Entry> left = entries();
    const bool stays = std::ranges::any_of(left, [&](const Entry& one) { return one.id == id && !one.shipped; });
    if (stays) return; // as was reported
    notice_->tell(Notice::Kind::information, tr("“%1” was deleted; Undo brings it back.").arg(name));
}

void LibraryDialog::addFromFile() {
    if (!leaveChanges()) return;
    const QString file = askFile();
    if (file.isEmpty()) return;
    const Result<Incoming> incoming = read(file.toStdString());
    if (!incoming) {
        fail(incoming.error());
        return;
    }
    if (lists(incoming->id)) {
        notice_->tell(Notice::Kind::error, texts_.known.arg(QString::fromStdString(incoming->id)));
        return;
    }
    search_->clear();
    incoming->keep();
    if (!lists(incoming->id)) return; // as was reported
    showEntry(incoming->id);
    if (!incoming->notes.isEmpty()) warn(incoming->notes);
}

/// Values that can't be saved stay in the fields.
void LibraryDialog::saveChanges() {
    save_->setFocus(); // enters text that is being typed
    if (!edited() || !problem().isEmpty()) return;
    if (const Result<void> kept = keep(); !kept) fail(kept.error());
}

void LibraryDialog::reject() {
    if (leaveChanges()) QDialog::reject();
}

} // namespace burin
