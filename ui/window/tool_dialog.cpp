// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/tool_dialog.h"

#include "core/base/file.h"
#include "core/tool/tool_exchange.h"
#include "core/tool/tool_library.h"
#include "ui/dialogs/file_dialogs.h"
#include "ui/messages/details.h"
#include "ui/panels/buttons.h"
#include "ui/panels/texts.h"
#include "ui/panels/tool_drawing.h"
#include "ui/panels/tool_form.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

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
    auto* exports = addListButton(tr("Export…"), QStringLiteral("export"), QStringLiteral("exportToolButton"),
                                  QKeySequence(Qt::CTRL | Qt::Key_E),
                                  tr("Write this tool for FreeCAD (.fctb), or all for LinuxCNC (.tbl)"));
    connect(exports, &QPushButton::clicked, this, &ToolDialog::exportTools);
    use_ = addFootButton(tr("Load into the spindle"), QStringLiteral("check"), QStringLiteral("useToolButton"));
    connect(use_, &QPushButton::clicked, this, [this] { tools_.choose(shownId()); });
    connect(&tools, &Controller::changed, this, &ToolDialog::refresh);
    connect(&tools, &Controller::failed, this, &ToolDialog::fail);
    start(makePage(), QStringLiteral("toolName"), tools.current().id);
    connect(form_, &ToolForm::edited, this, [this] {
        drawing_->setTool(form_->tool());
        follow();
    });
}

QWidget* ToolDialog::makePage() {
    form_ = new ToolForm(tools_.holders());
    form_->setLengthUnit(unit_);
    auto* area = new QScrollArea(this);
    area->setWidget(form_);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFrameShape(QFrame::NoFrame);
    drawing_ = new ToolDrawing(this);
    drawing_->setUnit(unit_);
    addBelowList(drawing_);
    return area;
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

QString ToolDialog::about(bool shipped) const {
    if (tools_.milledWith(shownId()))
        return tr("The open project has recordings with this tool and keeps the values that they were made with.");
    return shipped ? tr("Burin is shipped with this tool, which can't be changed. Copy it and enter the values of your "
                        "own.")
                   : tr("Your own tool.");
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
    return original == nullptr ? id : tools_.copyTool(Tool(*original), tr("%1 (copy)").arg(toolName(*original)));
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
        return Incoming{one.tool.id, [this, tool = one.tool] { tools_.keepTool(tool); }, notes.join(QLatin1Char(' '))};
    }
    std::vector<Tool> tools;
    for (const ReadTool& each : read->tools) tools.push_back(each.tool);
    notes << tr("%n tools were added.", nullptr, static_cast<int>(tools.size()))
          << tr("Check the stick-out, holder and limits of each tool; other programs may not store them.");
    for (const std::string& out : read->leftOut) notes << detailText(out);
    return Incoming{tools_.freeId(QString::fromStdString(tools.front().id)), [this, tools] { tools_.keepTools(tools); },
                    notes.join(QLatin1Char(' '))};
}

void ToolDialog::exportTools() {
    const Tool* shown = tool(shownId());
    if (shown == nullptr || !leaveChanges()) return;
    const QString file = askToolExport(this, QDir::homePath(), QString::fromStdString(shown->id));
    if (file.isEmpty()) return;
    const Result<WrittenTools> written = toolsFor(file.toStdString(), shown->id, tools_.library(), 1.0);
    if (!written) {
        fail(written.error());
        return;
    }
    if (const Result<void> done = writeFileAtomically(file.toStdString(), written->text); !done) {
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
