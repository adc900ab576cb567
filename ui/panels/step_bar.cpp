// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/step_bar.h"

#include "ui/panels/step_button.h"

#include <QHBoxLayout>
#include <QKeyEvent>

#include <algorithm>

namespace burin {

class StepBar::Fields : public QObject {
public:
    explicit Fields(StepBar* line);
    bool eventFilter(QObject* watched, QEvent* event) override;
    std::array<StepButton*, steps> buttons{};
};

StepBar::Fields::Fields(StepBar* line) : QObject(line) {
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    const std::array<std::pair<QString, const char*>, steps> titles{{{StepBar::tr("Part"), "stepPart"},
                                                                     {StepBar::tr("Stock"), "stepStock"},
                                                                     {StepBar::tr("Material"), "stepMaterial"},
                                                                     {StepBar::tr("Tool"), "stepTool"},
                                                                     {StepBar::tr("Allowance"), "stepAllowance"},
                                                                     {StepBar::tr("Mill"), "stepMill"},
                                                                     {StepBar::tr("Path"), "stepPath"},
                                                                     {StepBar::tr("Program"), "stepProgram"}}};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        auto* button = new StepButton(static_cast<JobStep>(i), titles[i].first, line);
        button->setObjectName(QLatin1String(titles[i].second));
        button->installEventFilter(this);
        connect(button, &QAbstractButton::clicked, line, [line, button] { emit line->stepChosen(button->step()); });
        row->addWidget(button, 1);
        buttons[i] = button;
    }
}

/// Left and Right move along the bar; Enter selects a step, as Space does.
bool StepBar::Fields::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return false;
    const int key = static_cast<QKeyEvent*>(event)->key();
    const auto at = std::ranges::find(buttons, watched, [](StepButton* button) -> QObject* { return button; });
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        (*at)->click();
        return true;
    }
    if (key == Qt::Key_Right && at + 1 != buttons.end()) {
        (*(at + 1))->setFocus(Qt::TabFocusReason);
        return true;
    }
    if (key == Qt::Key_Left && at != buttons.begin()) {
        (*(at - 1))->setFocus(Qt::BacktabFocusReason);
        return true;
    }
    return false;
}

StepBar::StepBar(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("jobLine"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void StepBar::setState(const std::array<JobStepState, steps>& states, JobStep shown) {
    for (std::size_t i = 0; i < states.size(); ++i)
        fields_->buttons[i]->setState(states[i], static_cast<std::size_t>(shown) == i);
}

} // namespace burin
