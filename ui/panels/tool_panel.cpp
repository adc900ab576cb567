// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/tool_panel.h"

#include "core/base/units.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/notice.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/row_list.h"
#include "ui/panels/texts.h"
#include "ui/panels/tool_drawing.h"
#include "ui/panels/value_row.h"

#include <algorithm>

namespace burin {

namespace {

constexpr int leastTools = 6, mostTools = 16; // rows that are visible at once

} // namespace

class ToolPanel::Fields : public QObject {
public:
    explicit Fields(ToolPanel* panel);
    void refresh();

    ToolState state;
    LengthUnit unit = LengthUnit::millimetre;

private:
    ValueRow* addRow(const QString& label, const char* name);
    void showMeasures(const Tool& tool);
    void showConditions(bool turns);

    ToolPanel* panel_;
    QVBoxLayout* column_;
    RowList* tools_;
    ToolDrawing* drawing_;
    ValueRow *diameter_, *corner_, *flutes_, *stickOut_, *depth_, *feed_, *plunge_, *speed_;
    QLabel* source_;
    Notice *notice_, *estimate_;
};

ToolPanel::Fields::Fields(ToolPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(ToolPanel::tr("Tool"), panel));
    tools_ = new RowList(panel);
    tools_->setObjectName(QStringLiteral("toolList"));
    tools_->setAccessibleName(ToolPanel::tr("Tools"));
    tools_->setToolTip(ToolPanel::tr("Choose the tool to mill with"));
    tools_->setMaximumRows(mostTools);
    tools_->setLeastRows(leastTools);
    column_->addWidget(tools_, 100); // gets the height before the empty space below
    notice_ = new Notice(panel);
    notice_->setObjectName(QStringLiteral("toolNotice"));
    column_->addWidget(notice_);
    drawing_ = new ToolDrawing(panel);
    column_->addWidget(drawing_);
    diameter_ = addRow(ToolPanel::tr("Diameter"), "toolDiameter");
    corner_ = addRow(ToolPanel::tr("Corner radius"), "toolCornerRadius");
    flutes_ = addRow(ToolPanel::tr("Flutes"), "toolFlutes");
    stickOut_ = addRow(ToolPanel::tr("Stick-out"), "toolStickOut");
    depth_ = addRow(ToolPanel::tr("Deepest cut"), "toolDepthOfCut");
    column_->addWidget(makeSectionTitle(ToolPanel::tr("In this stock"), panel));
    feed_ = addRow(ToolPanel::tr("Feed"), "feed");
    plunge_ = addRow(ToolPanel::tr("Plunge feed"), "plungeFeed");
    speed_ = addRow(ToolPanel::tr("Spindle speed"), "spindleSpeed");
    estimate_ = new Notice(panel);
    estimate_->setObjectName(QStringLiteral("conditionsNotice"));
    column_->addWidget(estimate_);
    column_->addWidget(makeSectionTitle(ToolPanel::tr("Source of the dimensions"), panel));
    source_ = makeWrappedLabel(panel);
    source_->setProperty("look", "quiet");
    source_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column_->addWidget(source_);
    column_->addStretch(1);
    connect(tools_, &RowList::rowChosen, this, [this](int row) {
        const auto index = static_cast<std::size_t>(row);
        if (index >= state.tools.size() || state.tools[index].id == state.current) return;
        state.current = state.tools[index].id;
        refresh();
        emit panel_->toolChosen(state.current);
    });
}

ValueRow* ToolPanel::Fields::addRow(const QString& label, const char* name) {
    auto* row = new ValueRow(label, panel_);
    row->setObjectName(QLatin1String(name));
    column_->addWidget(row);
    return row;
}

void ToolPanel::Fields::showMeasures(const Tool& tool) {
    diameter_->setValue(lengthText(tool.cutter.diameter, unit));
    corner_->setValue(lengthText(tool.cutter.cornerRadius, unit));
    flutes_->setValue(ToolPanel::tr("%1, %2 long").arg(tool.fluteCount).arg(lengthText(tool.cutter.fluteLength, unit)));
    stickOut_->setValue(lengthText(tool.cutter.stickOut, unit));
    depth_->setValue(lengthText(tool.maximumDepthOfCut, unit));
    setWrappedText(source_, QString::fromStdString(tool.source));
}

/// The tables state feeds and speeds of teeth that turn.
void ToolPanel::Fields::showConditions(bool turns) {
    feed_->setValue(feedText(turns ? state.feed : 0.0, unit));
    plunge_->setValue(feedText(turns ? state.plungeFeed : 0.0, unit));
    speed_->setValue(spindleSpeedText(turns ? state.spindleSpeed : 0.0));
    if (!turns)
        return estimate_->tell(Notice::Kind::information,
                               ToolPanel::tr("This tool doesn't turn: it cuts what its model sweeps, upright and in a "
                                             "fixed direction. It has no feeds, passes or programs."));
    if (state.preset.empty())
        estimate_->tell(Notice::Kind::warning,
                        state.conditionsEstimated && state.feed > 0.0
                            ? ToolPanel::tr("Feed and speed come from values that are estimates.")
                            : QString());
    else
        estimate_->tell(Notice::Kind::information,
                        (state.plungeByPreset
                             ? ToolPanel::tr("By the preset “%1” of this tool.")
                             : ToolPanel::tr("By the preset “%1” of this tool; the plunge feed by the material."))
                            .arg(QString::fromStdString(state.preset)));
}

void ToolPanel::Fields::refresh() {
    std::vector<ListRow> rows;
    int chosen = -1;
    for (const Tool& tool : state.tools) {
        if (tool.id == state.current) chosen = static_cast<int>(rows.size());
        ListRow row;
        row.title = row.toolTip = toolName(tool);
        row.value = QStringLiteral("T%1").arg(tool.number);
        row.detail = toolSummary(tool, unit);
        if (const auto takes = std::ranges::count(state.ofTakes, tool.id); takes > 0) {
            row.badge = ToolPanel::tr("milled");
            row.toolTip += QLatin1Char('\n') + (takes == 1 ? ToolPanel::tr("1 take was milled with this tool")
                                                           : ToolPanel::tr("%n takes were milled with this tool",
                                                                           nullptr, static_cast<int>(takes)));
        }
        rows.push_back(row);
    }
    tools_->setRows(rows);
    tools_->setChosen(chosen);
    setEnabledKeepingFocus(tools_, !state.locked);
    if (state.locked)
        notice_->tell(Notice::Kind::information, ToolPanel::tr("The tool can't be changed while recording."));
    else if (state.fieldBusy)
        notice_->tell(Notice::Kind::information, ToolPanel::tr("The boundary for this tool is being computed…"));
    else
        notice_->clear();
    const std::optional<Tool> tool =
        chosen < 0 ? std::nullopt : std::optional(state.tools[static_cast<std::size_t>(chosen)]);
    drawing_->setTool(tool);
    drawing_->setUnit(unit);
    if (tool) showMeasures(*tool);
    showConditions(!tool || tool->cutter.turns());
}

ToolPanel::ToolPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("toolPanel"));
    fields_->refresh();
}

void ToolPanel::setUnit(LengthUnit unit) {
    fields_->unit = unit;
    fields_->refresh();
}

void ToolPanel::setState(const ToolState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
