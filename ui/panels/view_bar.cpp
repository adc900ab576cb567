// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/view_bar.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/length_field.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr int sliderWidth = 120, leastSliderWidth = 50, fieldWidth = 110; // pixels
constexpr int sliderSteps = 1000;                                         // over the range of the section
constexpr int transparencyStep = 5;                                       // %

QSlider* makeSlider(const QString& toolTip, const char* name, QWidget* parent) {
    auto* slider = new QSlider(Qt::Horizontal, parent);
    slider->setObjectName(QLatin1String(name));
    slider->setAccessibleName(toolTip);
    slider->setToolTip(toolTip);
    slider->setMinimumWidth(leastSliderWidth);
    slider->setMaximumWidth(sliderWidth);
    return slider;
}

/// A button that triggers an action and is down while the action is checked.
QPushButton* makeActionButton(QAction& action, const char* name, QWidget* parent) {
    QPushButton* button = makeChoiceButton(action.iconText(), action.toolTip(), QLatin1String(name), parent);
    button->setCheckable(action.isCheckable());
    const auto follow = [button, &action] {
        button->setChecked(action.isChecked());
        setEnabledKeepingFocus(button, action.isEnabled());
    };
    follow();
    QObject::connect(&action, &QAction::changed, button, follow);
    QObject::connect(button, &QPushButton::clicked, &action, [&action, follow] {
        action.trigger();
        follow();
    });
    return button;
}

} // namespace

ViewBar::ViewBar(const Offered& offered, QWidget* parent) : QFrame(parent) {
    setObjectName(QStringLiteral("viewBar"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // it adapts to the available width
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->setSpacing(8);
    transparencyTitle_ = new QLabel(tr("Transparency"), this);
    transparencyTitle_->setProperty("look", "quiet");
    layout->addWidget(transparencyTitle_);
    transparency_ = makeSlider(tr("Transparency of the workpiece."), "transparencySlider", this);
    transparency_->setRange(0, mostTransparent);
    transparency_->setSingleStep(transparencyStep);
    transparency_->setPageStep(4 * transparencyStep);
    layout->addWidget(transparency_);
    layout->addWidget(makeActionButton(offered.parallel, "parallelButton", this));
    layout->addWidget(makeActionButton(offered.section, "sectionButton", this));

    pathColours_ = new QWidget(this);
    auto* colours = new QHBoxLayout(pathColours_);
    colours->setContentsMargins(0, 0, 0, 0);
    colours->setSpacing(8);
    pathTitle_ = new QLabel(tr("Path"), pathColours_);
    pathTitle_->setProperty("look", "quiet");
    colours->addWidget(pathTitle_);
    pathColour_ = new ChoiceBox(pathColours_);
    pathColour_->setObjectName(QStringLiteral("pathColour"));
    pathColour_->setAccessibleName(tr("Colours of the path"));
    pathColour_->setToolTip(tr("What the colours of the path show."));
    colours->addWidget(pathColour_);
    layout->addWidget(pathColours_);
    pathColours_->hide();

    sectionControls_ = new QWidget(this);
    auto* row = new QHBoxLayout(sectionControls_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    axis_ = new ChoiceBox(sectionControls_);
    axis_->setObjectName(QStringLiteral("sectionAxis"));
    axis_->setAccessibleName(tr("Normal of the section plane"));
    axis_->setToolTip(tr("Axis perpendicular to the section plane."));
    axis_->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
    row->addWidget(axis_);
    position_ = makeSlider(tr("Moves the section plane along its normal."), "sectionSlider", sectionControls_);
    position_->setRange(0, sliderSteps);
    position_->setSingleStep(sliderSteps / 100);
    position_->setPageStep(sliderSteps / 10);
    row->addWidget(position_);
    place_ = new LengthField(sectionControls_);
    place_->setObjectName(QStringLiteral("sectionField"));
    place_->setAccessibleName(tr("Position of the section plane"));
    place_->setToolTip(tr("Position of the section plane along its normal."));
    place_->setFixedWidth(fieldWidth);
    row->addWidget(place_);
    row->addWidget(makeActionButton(offered.flip, "flipSectionButton", sectionControls_));
    layout->addWidget(sectionControls_);
    layout->addStretch(1);
    sectionControls_->hide();

    connect(transparency_, &QSlider::valueChanged, this, &ViewBar::transparencyChosen);
    connect(pathColour_, &QComboBox::activated, this, &ViewBar::pathColourChosen);
    connect(axis_, &QComboBox::activated, this, &ViewBar::axisChosen);
    connect(position_, &QSlider::valueChanged, this,
            [this](int step) { emit positionChosen(low_ + (high_ - low_) * step / sliderSteps); });
    connect(place_, &LengthField::valueEdited, this, &ViewBar::positionChosen);
}

void ViewBar::setUnit(LengthUnit unit) {
    place_->setLengthUnit(unit);
}

void ViewBar::setPathColours(const QStringList& names) {
    const QSignalBlocker quiet(pathColour_);
    pathColour_->clear();
    pathColour_->addItems(names);
}

void ViewBar::showPathColour(const std::optional<int>& place) {
    hasPath_ = place.has_value();
    const QSignalBlocker quiet(pathColour_);
    if (place) pathColour_->setCurrentIndex(*place);
    followRoom();
}

void ViewBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    followRoom();
}

void ViewBar::followRoom() {
    // Uses the size hints of the widgets, shown or not: showing them just to measure them would move the others
    // meanwhile.
    const int spacing = layout()->spacing();
    const auto widthOf = [spacing](const QWidget& widget) {
        return std::max(widget.minimumSizeHint().width(), widget.minimumWidth()) + spacing;
    };
    const QMargins margins = layout()->contentsMargins();
    int needed = margins.left() + margins.right();
    for (int i = 0; i < layout()->count(); ++i) {
        const QWidget* widget = layout()->itemAt(i)->widget();
        const bool own = widget == transparencyTitle_ || widget == transparency_ || widget == pathColours_;
        if (widget == nullptr || own || (widget == sectionControls_ && widget->isHidden())) continue;
        needed += widthOf(*widget);
    }
    struct Spared {
        QWidget* widget;
        int width; ///< pixels
        bool wanted = true;
    };
    std::array<Spared, 4> spared{{{transparencyTitle_, widthOf(*transparencyTitle_)},
                                  {pathTitle_, widthOf(*pathTitle_), hasPath_},
                                  {pathColours_, widthOf(*pathColour_), hasPath_},
                                  {transparency_, widthOf(*transparency_)}}};
    for (const Spared& each : spared) needed += each.wanted ? each.width : 0;
    for (Spared& each : spared) {
        if (needed > width() && each.wanted) {
            needed -= each.width;
            each.wanted = false;
        }
        each.widget->setVisible(each.wanted);
    }
}

void ViewBar::showTransparency(int percent) {
    const QSignalBlocker quiet(transparency_);
    transparency_->setValue(percent);
}

void ViewBar::showSection(const std::optional<Section>& section) {
    sectionControls_->setVisible(section.has_value());
    followRoom();
    if (!section) return;
    low_ = section->low;
    high_ = section->high;
    axis_->setCurrentIndex(section->axis);
    const QSignalBlocker quiet(position_);
    if (high_ > low_)
        position_->setValue(static_cast<int>(std::lround(sliderSteps * (section->position - low_) / (high_ - low_))));
    place_->limit(low_, high_);
    place_->showValue(section->position);
}

} // namespace burin
