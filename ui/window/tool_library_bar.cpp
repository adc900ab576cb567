// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/tool_library_bar.h"

#include "ui/dialogs/questions.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/window/context_menu.h"

#include <QHBoxLayout>

#include <algorithm>

namespace burin {

namespace {

QString withKey(const QString& text, const QKeySequence& key) {
    return text + QStringLiteral(" (") + key.toString(QKeySequence::NativeText) + QLatin1Char(')');
}

} // namespace

QString toolLibraryName(const std::string& library) {
    if (library == allTools) return ToolLibraryBar::tr("All tools");
    if (library == starterLibrary) return ToolLibraryBar::tr("Starter library");
    return library == ownLibrary ? ToolLibraryBar::tr("My tools") : QString::fromStdString(library);
}

ToolLibraryBar::ToolLibraryBar(ToolController& tools, QWidget* parent)
    : QWidget(parent), tools_(tools), library_(allTools), box_(new ChoiceBox(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    box_->setObjectName(QStringLiteral("toolLibrary"));
    box_->setAccessibleName(tr("Tool library"));
    box_->setToolTip(tr("The tool library whose tools are listed"));
    row->addWidget(box_, 1);
    QToolButton* add = addButton("add", "addLibraryButton", tr("New tool library"), QKeySequence(Qt::CTRL | Qt::Key_N));
    rename_ = addButton("edit", "renameLibraryButton", tr("Rename this library"), QKeySequence(Qt::Key_F2));
    delete_ = addButton("remove", "deleteLibraryButton", tr("Delete this library and its tools"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Delete));
    for (QToolButton* button : {add, rename_, delete_}) row->addWidget(button);
    connect(box_, &QComboBox::activated, this,
            [this](int index) { choose(box_->itemData(index).toString().toStdString()); });
    connect(add, &QToolButton::clicked, this, &ToolLibraryBar::addLibrary);
    connect(rename_, &QToolButton::clicked, this, &ToolLibraryBar::renameLibrary);
    connect(delete_, &QToolButton::clicked, this, &ToolLibraryBar::deleteLibrary);
    connect(&tools, &Controller::changed, this, &ToolLibraryBar::follow);
    follow();
}

QToolButton* ToolLibraryBar::addButton(const char* icon, const char* name, const QString& text,
                                       const QKeySequence& key) {
    auto* button = makeIconButton(QLatin1String(icon), text, QLatin1String(name), this);
    button->setShortcut(key);
    button->setToolTip(withKey(text, key));
    return button;
}

/// The chosen library may have been deleted, or renamed by undo.
void ToolLibraryBar::follow() {
    const ToolLibraries& libraries = tools_.libraries();
    QStringList ids;
    for (const std::string_view id : {allTools, starterLibrary, ownLibrary})
        ids << QString::fromLatin1(id.data(), static_cast<qsizetype>(id.size()));
    for (const std::string& name : libraries.names) ids << QString::fromStdString(name);
    QStringList texts;
    for (const QString& id : ids) texts << toolLibraryName(id.toStdString());
    const bool lost = !ids.contains(QString::fromStdString(library_));
    if (lost) library_ = allTools;
    box_->offer(texts, ids, QString::fromStdString(library_));
    const QString reason =
        libraries.contains(library_) ? QString() : tr("Choose a library that you have named yourself.");
    for (QToolButton* button : {rename_, delete_})
        enableUnless(button, reason, withKey(button->accessibleName(), button->shortcut()));
    if (lost) emit chosen();
}

std::string ToolLibraryBar::ownTarget() const {
    const bool takesOwn = library_ == ownLibrary || tools_.libraries().contains(library_);
    return takesOwn ? library_ : std::string(ownLibrary);
}

void ToolLibraryBar::choose(const std::string& library) {
    library_ = library;
    follow();
    emit chosen();
}

std::string ToolLibraryBar::addLibrary() {
    const std::string name = askName(tr("New tool library"), {}, this).toStdString();
    if (name.empty()) return {};
    if (const Result<void> added = tools_.addLibrary(name); !added) {
        emit failed(added.error());
        return {};
    }
    choose(name);
    return name;
}

void ToolLibraryBar::renameLibrary() {
    const std::string name =
        askName(tr("Rename the tool library"), QString::fromStdString(library_), this).toStdString();
    if (name.empty()) return;
    const std::string before = std::exchange(library_, name); // followed while it is renamed
    if (const Result<void> renamed = tools_.renameLibrary(before, name); !renamed) {
        library_ = before;
        emit failed(renamed.error());
    }
    follow();
}

void ToolLibraryBar::deleteLibrary() {
    const auto tools = static_cast<int>(std::ranges::count_if(
        tools_.library(), [this](const Tool& tool) { return tools_.libraries().isIn(tool.id, library_); }));
    const QString name = toolLibraryName(library_);
    const QString question = tools == 0   ? tr("Delete the empty library “%1”?").arg(name)
                             : tools == 1 ? tr("Delete the library “%1” and its tool?").arg(name)
                                          : tr("Delete the library “%1” and its %n tools?", nullptr, tools).arg(name);
    if (confirm(this, question, tr("Undo brings them back. Projects keep the tools that they use."), tr("Delete")))
        tools_.deleteLibrary(library_);
}

} // namespace burin
