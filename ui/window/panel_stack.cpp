// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/panel_stack.h"

#include "ui/panels/step_bar.h"

#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <initializer_list>
#include <tuple>

namespace burin {

namespace {

constexpr int leastWidth = 344, mostWidth = 900; // pixels: a panel's 320 with margins; a program's long lines

/// Each panel scrolls separately, so that a long one does not stretch the others.
QWidget* scrolling(QWidget* panel, const char* name, const QString& title) {
    auto* area = new QScrollArea;
    area->setObjectName(QString::fromLatin1(name));
    area->setAccessibleName(title);
    area->setWidget(panel);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return area;
}

/// Combines panels, one above the other.
QWidget* stacked(std::initializer_list<QWidget*> panels) {
    auto* all = new QWidget;
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    for (QWidget* panel : panels) column->addWidget(panel);
    column->addStretch(1);
    return all;
}

} // namespace

PanelStack::PanelStack(QWidget* parent)
    : QFrame(parent)
    , part(new PartPanel)
    , setup(new SetupPanel)
    , stock(new StockPanel)
    , zero(new ZeroPanel)
    , surroundings(new SurroundingsPanel)
    , findings(new EmbeddingFindings)
    , material(new MaterialPanel)
    , layers(new LayerPanel)
    , tool(new ToolPanel)
    , allowance(new AllowancePanel)
    , mill(new MillPanel)
    , guides(new GuidePanel)
    , bounds(new BoundsPanel)
    , hand(new HandPanel)
    , path(new PathPanel)
    , program(new ProgramPanel)
    , meters(new Meters)
    , stack_(new QStackedWidget) {
    setObjectName(QStringLiteral("panelStack"));
    setMinimumWidth(leastWidth);
    setMaximumWidth(mostWidth);
    stack_->setObjectName(QStringLiteral("panelPages"));
    const std::array<std::tuple<QWidget*, const char*, QString>, 8> panels{
        {{stacked({part, setup}), "partPage", StepBar::tr("Part")},
         {stacked({stock, zero, surroundings, findings}), "stockPage", StepBar::tr("Stock")},
         {stacked({material, layers}), "materialPage", StepBar::tr("Material")},
         {tool, "toolPage", StepBar::tr("Tool")},
         {allowance, "allowancePage", StepBar::tr("Allowance")},
         {stacked({mill, guides, bounds, hand}), "millPage", StepBar::tr("Mill")},
         {path, "pathPage", StepBar::tr("Path")},
         {program, "programPage", StepBar::tr("Program")}}};
    for (const auto& [panel, name, title] : panels) stack_->addWidget(scrolling(panel, name, title));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(stack_, 1);
    layout->addWidget(meters);
    meters->hide();
}

void PanelStack::showPanel(QWidget* panel) {
    if (auto* area = qobject_cast<QScrollArea*>(stack_->currentWidget())) area->ensureWidgetVisible(panel);
}

void PanelStack::showStep(JobStep step) {
    stack_->setCurrentIndex(static_cast<int>(step));
}

} // namespace burin
