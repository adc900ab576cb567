// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/tool_dialog.h"

#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/details.h"
#include "ui/panels/buttons.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"
#include "ui/panels/tool_drawing.h"
#include "ui/panels/tool_form.h"
#include "ui/window/context_menu.h"
#include "ui/window/tool_library_bar.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>
#include <filesystem>

namespace burin {

namespace {

constexpr QSize firstToolSize(1180, 780);

} // namespace

ToolDialog::ToolDialog(ToolController& tools, LengthUnit unit, QWidget* parent)
    : LibraryDialog({QStringLiteral("Tool"), tr("Tools"), tr("shipped"),
                     tr("Copy this tool to one of your own and change that"),
                     tr("Add a tool file, or a tool bit of FreeCAD (.fctb)"),
                     tr("Delete this tool; Undo brings it back (Del in the list)"),
                     tr("The tools that Burin is shipped with can't be deleted."),
                     tr("There is a tool with the ID “%1” already; give the one in the file another ID.")},
                    firstToolSize, parent)
    , tools_(tools)
    , unit_(unit) {
    addButtons();
    connect(&tools, &Controller::changed, this, &ToolDialog::refresh);
    connect(&tools, &Controller::failed, this, &ToolDialog::fail);
    connect(bar_, &ToolLibraryBar::chosen, this, &ToolDialog::showLibrary);
    connect(bar_, &ToolLibraryBar::failed, this, &ToolDialog::fail);
    start(makePage(), QStringLiteral("toolName"), tools.current().id);
    connect(form_, &ToolForm::edited, this, [this] {
        drawing_->setTool(form_->tool());
        follow();
    });
}

void ToolDialog::addButtons() {
    bar_ = new ToolLibraryBar(tools_, this);
    addAboveList(bar_);
    place_ =
        addListButton(tr("Move or copy to…"), QStringLiteral("next"), QStringLiteral("placeToolButton"),
                      QKeySequence(Qt::CTRL | Qt::Key_M), tr("Put this tool, or a copy of it, into another library"));
    connect(place_, &QPushButton::clicked, this, &ToolDialog::offerLibraries);
    auto* exports = addListButton(tr("Export…"), QStringLiteral("export"), QStringLiteral("exportToolButton"),
                                  QKeySequence(Qt::CTRL | Qt::Key_E),
                                  tr("Write this tool for FreeCAD (.fctb), or the listed library for FreeCAD (.fctl), "
                                     "LinuxCNC (.tbl), Fusion (.tools) or CAMotics (.ctbl)"));
    connect(exports, &QPushButton::clicked, this, &ToolDialog::exportTools);
    use_ = addFootButton(tr("Load into the spindle"), QStringLiteral("check"), QStringLiteral("useToolButton"));
    connect(use_, &QPushButton::clicked, this, [this] { tools_.choose(shownId()); });
}

QWidget* ToolDialog::makePage() {
    form_ = new ToolForm(tools_.holders(), tools_.materials());
    form_->setLengthUnit(unit_);
    drawing_ = new ToolDrawing(this);
    drawing_->setUnit(unit_);
    addBelowList(drawing_);
    return makeFormArea(form_, this);
}

const Tool* ToolDialog::tool(const std::string& id) const {
    const auto& library = tools_.library();
    const auto found = std::ranges::find(library, id, &Tool::id);
    return found == library.end() ? nullptr : &*found;
}

std::vector<LibraryDialog::Entry> ToolDialog::entries() const {
    std::vector<Entry> entries;
    for (const Tool& tool : tools_.library())
        entries.push_back({tool.id, toolName(tool), isShippedTool(tool.id), tool.id == tools_.current().id,
                           QStringLiteral("T%1 · ").arg(tool.number) + toolSummary(tool, unit_)});
    return entries;
}

bool ToolDialog::listed(const Entry& entry) const {
    return tools_.libraries().isIn(entry.id, bar_->library());
}

std::vector<Tool> ToolDialog::listedTools() const {
    std::vector<Tool> tools = tools_.library();
    std::erase_if(tools, [this](const Tool& tool) { return !tools_.libraries().isIn(tool.id, bar_->library()); });
    return tools;
}

/// Values that are not saved keep their tool shown, whatever library is listed.
void ToolDialog::showLibrary() {
    if (edited())
        refresh();
    else
        showListed();
    if (listedTools().empty()) warn(tr("This library is empty. Copy or move tools into it, or add them from a file."));
}

void ToolDialog::fill(const std::string& id, bool shipped) {
    const Tool* wanted = tool(id);
    if (wanted == nullptr) return;
    form_->showTool(*wanted, shipped);
    drawing_->setTool(*wanted);
}

bool ToolDialog::edited() const {
    const Tool* shown = tool(shownId());
    return shown != nullptr && toJson(form_->tool()) != toJson(*shown);
}

QString ToolDialog::problem() const {
    const std::vector<CuttingPreset>& presets = form_->tool().presets;
    for (const CuttingPreset& preset : presets) {
        const QString name = QString::fromStdString(preset.name);
        if (name.isEmpty()) return tr("A preset has no name; enter one.");
        if (std::ranges::count(presets, preset.name, &CuttingPreset::name) > 1)
            return tr("Two presets are called “%1”; rename one of them.").arg(name);
        if (!(preset.spindleSpeed > 0.0) || !(preset.feed + preset.chipLoad > 0.0))
            return tr("The preset “%1” needs a speed, and a feed or a feed per tooth.").arg(name);
    }
    return {};
}

QString ToolDialog::about(bool shipped) const {
    if (tools_.milledWith(shownId()))
        return tr("The open project has recordings with this tool and keeps the values that they were made with.");
    if (shipped)
        return tr("Burin is shipped with this tool, which can't be changed. Copy it and enter the values of your own.");
    const std::string library = tools_.libraries().libraryOf(shownId());
    return library == ownLibrary ? tr("Your own tool.")
                                 : tr("Your own tool, in the library “%1”.").arg(toolLibraryName(library));
}

void ToolDialog::followFoot() {
    const bool inSpindle = shownId() == tools_.current().id;
    enableUnless(use_,
                 tools_.locked() ? tr("A recording is running; end it first.")
                 : inSpindle     ? tr("It is in the spindle.")
                                 : QString(),
                 tr("Mill with this tool (Ctrl+Return)"));
    use_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Return));
}

std::string ToolDialog::copy(const std::string& id) {
    const Tool* original = tool(id);
    if (original == nullptr) return id;
    const std::string library =
        bar_->library() == allTools && !isShippedTool(id) ? tools_.libraries().libraryOf(id) : bar_->ownTarget();
    const std::string made = tools_.copyTool(Tool(*original), tr("%1 (copy)").arg(toolName(*original)), library);
    if (made != id && !tools_.libraries().isIn(made, bar_->library())) bar_->choose(library);
    return made;
}

/// Offers the user's own libraries, and a new one.
void ToolDialog::offerLibraries() {
    if (!leaveChanges()) return;
    showEntry(std::string(shownId())); // without the discarded values
    const std::string id = shownId(), now = tools_.libraries().libraryOf(id);
    std::vector<std::string> targets = tools_.libraries().names;
    targets.insert(targets.begin(), std::string(ownLibrary));
    QMenu* menu = makeContextMenu("toolLibraryMenu", tr("Move or copy to…"), this);
    const auto label = [](std::string library) {
        return toolLibraryName(library).replace(QLatin1Char('&'), QStringLiteral("&&"));
    };
    const auto add = [&](const QString& text, const QByteArray& name, const std::function<void()>& use) {
        addEntry(*menu, text, {}, name.constData(), use);
    };
    for (std::size_t i = 0; !isShippedTool(id) && i < targets.size(); ++i)
        if (targets[i] != now)
            add(tr("Move to “%1”").arg(label(targets[i])), "moveTool" + QByteArray::number(i),
                [this, to = targets[i]] { moveTo(to); });
    for (std::size_t i = 0; i < targets.size(); ++i)
        add(tr("Copy to “%1”").arg(label(targets[i])), "copyTool" + QByteArray::number(i),
            [this, to = targets[i]] { copyTo(to); });
    add(tr("Copy to a new library…"), "copyToolToNew", [this] {
        const std::string copied = shownId(); // a new library is shown at once
        const std::string library = bar_->addLibrary();
        if (library.empty()) return;
        showEntry(copied);
        copyTo(library);
    });
    menu->popup(place_->mapToGlobal(QPoint(0, place_->height())));
}

void ToolDialog::moveTo(std::string library) {
    const std::string id = shownId();
    tools_.moveTool(id, library);
    if (bar_->library() != allTools) bar_->choose(library);
    showEntry(id);
}

void ToolDialog::copyTo(std::string library) {
    const Tool* original = tool(shownId());
    if (original == nullptr) return;
    const std::string from = original->id;
    const std::string made = tools_.copyTool(Tool(*original), tr("%1 (copy)").arg(toolName(*original)), library);
    if (made == from) return; // as was reported
    if (bar_->library() != allTools) bar_->choose(library);
    showEntry(made);
}

void ToolDialog::erase(const std::string& id) {
    tools_.deleteTool(id);
}

QString ToolDialog::askFile() {
    return askToolToAdd(this, QDir::homePath());
}

/// A single tool keeps its own id, or is refused if that exists; several tools get free ids.
Result<LibraryDialog::Incoming> ToolDialog::read(const std::string& file) {
    const Tool* like = tool(shownId());
    const Result<ReadTools> read = toolsFromFile(file, like == nullptr ? Tool{} : *like, 1.0);
    if (!read) return read.error();
    QStringList notes;
    if (read->tools.size() == 1) {
        const ReadTool& one = read->tools.front();
        for (const std::string& note : one.notes) notes << detailText(note);
        for (const std::string& out : read->leftOut) notes << detailText(out);
        return Incoming{one.tool.id,
                        [this, tool = one.tool] {
                            const std::string library = bar_->ownTarget();
                            tools_.addTool(tool, library);
                            if (bar_->library() != allTools) bar_->choose(library);
                        },
                        notes.join(QLatin1Char(' '))};
    }
    std::vector<Tool> tools;
    for (const ReadTool& each : read->tools) tools.push_back(each.tool);
    const std::string library =
        freeLibraryName(tools_.libraries(), std::filesystem::path(file).stem().string()); // as the file is called
    notes << tr("%n tools were added to the library “%1”.", nullptr, static_cast<int>(tools.size()))
                 .arg(toolLibraryName(library))
          << tr("Check the stick-out, holder and limits of each tool; other programs may not store them.");
    QStringList ofTools; // what several tools have in common is stated once
    for (const ReadTool& each : read->tools)
        for (const std::string& note : each.notes) ofTools << detailText(note);
    ofTools.removeDuplicates();
    notes << ofTools;
    for (const std::string& out : read->leftOut) notes << detailText(out);
    return Incoming{tools_.freeId(QString::fromStdString(tools.front().id)),
                    [this, tools, library] {
                        if (!tools_.addTools(tools, library).empty()) bar_->choose(library);
                    },
                    notes.join(QLatin1Char(' '))};
}

void ToolDialog::exportTools() {
    const Tool* shown = tool(shownId());
    if (shown == nullptr || !leaveChanges()) return;
    const QString file = askToolExport(this, QDir::homePath(), QString::fromStdString(shown->id));
    if (file.isEmpty()) return;
    const QString suffix = QFileInfo(file).suffix();
    const bool one = suffix == QLatin1String("fctb") || suffix == QLatin1String("json");
    const std::vector<Tool> exported = one ? std::vector<Tool>{*shown} : listedTools();
    if (exported.empty()) {
        warn(tr("This library is empty: there is nothing to export."));
        return;
    }
    const Result<WrittenTools> written = toolsFor(file.toStdString(), shown->id, exported, 1.0);
    if (!written) {
        fail(written.error());
        return;
    }
    if (const Result<void> done = writeTools(file.toStdString(), *written); !done) {
        fail(done.error());
        return;
    }
    QStringList notes{tr("Written to “%1”.").arg(QFileInfo(file).fileName())};
    for (const std::string& note : written->notes) notes << detailText(note);
    warn(notes.join(QLatin1Char(' ')));
}

/// Validates the values as when a file is read.
Result<void> ToolDialog::keep() {
    const Tool wanted = form_->tool();
    const Result<Tool> sound = toolFromJson(toJson(wanted), wanted.id + ".json");
    if (!sound) return sound.error();
    tools_.keepTool(wanted);
    return {};
}

} // namespace burin
