// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/guide_card.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/texts.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace burin {
namespace {

constexpr double farthestGuide = 10'000.0;                         // mm
constexpr double largestDistance = 100.0, smallestDistance = 0.01; // mm
constexpr double steepest = 1.4;                                   // rad, as checkGuide

} // namespace

GuideCard::GuideCard(std::size_t place, const Guide& guide, QWidget* parent) : QFrame(parent), guide_(guide) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    const QString name = QStringLiteral("guide%1").arg(place);
    addHead(name);
    addFigures(name);
    showGuide(guide, glm::dvec3(0.0));
    showNews(nullptr, LengthUnit::millimetre);
}

void GuideCard::addHead(const QString& name) {
    switch_ = new NamedSwitch(name, tr("Switch this guide on or off"), this);
    connect(switch_, &NamedSwitch::switched, this, [this](bool on) {
        guide_.on = on;
        emit edited(guide_);
    });
    auto* remove =
        makeIconButton(QStringLiteral("remove"), tr("Delete this guide"), name + QStringLiteral("Remove"), this);
    remove->setAccessibleName(guideName(guide_.kind) + QStringLiteral(", ") + remove->toolTip());
    connect(remove, &QToolButton::clicked, this, &GuideCard::removalRequested);
    auto* head = new QHBoxLayout;
    head->addWidget(switch_, 1);
    head->addWidget(remove);
    static_cast<QVBoxLayout*>(layout())->addLayout(head);
}

void GuideCard::addDirection(const QString& name, const QString& label) {
    direction_ = new ChoiceBox(this);
    direction_->setObjectName(name + QStringLiteral("Direction"));
    direction_->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
    layout()->addWidget(
        new FieldRow(label, direction_, tr("Axis of the setup along which the levels follow each other"), this));
    connect(direction_, &QComboBox::activated, this, [this](int axis) {
        guide_.direction = glm::dvec3(0.0);
        guide_.direction[axis] = 1.0;
        showGuide(guide_, zero_);
        emit edited(guide_);
    });
}

QuantityField* GuideCard::addField(const QString& name, const QString& label, const QString& toolTip,
                                   QuantityField* field, std::function<double&(Guide&)> value, int axis) {
    field->setObjectName(name);
    layout()->addWidget(new FieldRow(label, field, toolTip, this));
    field->setAccessibleName(guideName(guide_.kind) + QStringLiteral(", ") + label);
    fields_.push_back({field, std::move(value), axis});
    connect(field, &QuantityField::valueEdited, this, [this, place = fields_.size() - 1](double wanted) {
        const Field& of = fields_[place];
        of.value(guide_) = of.axis < 0 ? wanted : wanted + zero_[of.axis];
        emit edited(guide_);
    });
    return field;
}

void GuideCard::addPlace(const QString& name, int axis, const QString& toolTip) {
    const QString letter = axisLetter(axis);
    QuantityField* field = addField(
        name + letter, letter, toolTip, new LengthField(this),
        [axis](Guide& guide) -> double& { return guide.point[axis]; }, axis);
    field->limit(-farthestGuide, farthestGuide);
}

void GuideCard::addFigures(const QString& name) {
    const auto distance = [&](const QString& label, const QString& toolTip, double least) {
        addField(name + QStringLiteral("Distance"), label, toolTip, new LengthField(this), [](Guide& guide) -> double& {
            return guide.distance;
        })->limit(least, largestDistance);
    };
    const auto places = [&](const QString& toolTip) {
        for (int axis = 0; axis < 3; ++axis) addPlace(name, axis, toolTip);
    };
    switch (guide_.kind) {
    case GuideKind::plane:
        addDirection(name, tr("Across"));
        places(tr("Where the plane is"));
        break;
    case GuideKind::levels:
        addDirection(name, tr("Across"));
        distance(tr("Spacing"), tr("Distance between levels"), smallestDistance);
        places(tr("Position of one of the levels"));
        break;
    case GuideKind::line:
        addDirection(name, tr("Along"));
        places(tr("Where the line is"));
        break;
    case GuideKind::surface:
        distance(tr("Distance"), tr("Distance of the cutter from the part"), 0.0);
        break;
    case GuideKind::stepOver:
        distance(tr("Step-over"), tr("Distance of the next pass from the last one"), smallestDistance);
        break;
    case GuideKind::axis:
        addField(name + QStringLiteral("Lead"), tr("Lead"), tr("Lead angle: the tool leans in the direction of motion"),
                 new QuantityField(Quantity::angle, this), [](Guide& guide) -> double& { return guide.lead; })
            ->limit(-steepest, steepest);
        addField(name + QStringLiteral("Tilt"), tr("Tilt"),
                 tr("Tilt angle: the tool leans to the left of the direction of motion"),
                 new QuantityField(Quantity::angle, this), [](Guide& guide) -> double& { return guide.tilt; })
            ->limit(-steepest, steepest);
        onSurface_ = new QCheckBox(tr("From the part's surface"), this);
        onSurface_->setObjectName(name + QStringLiteral("OnSurface"));
        onSurface_->setToolTip(tr("Lead and tilt start from the part's surface, else from the Z axis"));
        layout()->addWidget(onSurface_);
        connect(onSurface_, &QCheckBox::clicked, this, [this](bool on) {
            guide_.onSurface = on;
            emit edited(guide_);
        });
        break;
    case GuideKind::curve:
        break; // its position is that of the edge
    }
}

void GuideCard::showGuide(const Guide& guide, const glm::dvec3& zero) {
    guide_ = guide;
    zero_ = zero;
    switch_->show(guideName(guide.kind), guide.on, news_);
    const int along = axisOf(guide.direction);
    if (direction_) direction_->setCurrentIndex(along);
    if (onSurface_) onSurface_->setChecked(guide.onSurface);
    for (const Field& field : fields_) {
        const double value = field.value(guide_);
        field.field->showValue(field.axis < 0 ? value : value - zero[field.axis]);
        // A plane has one coordinate, a line two: only the meaningful ones are shown.
        if (field.axis >= 0)
            field.field->parentWidget()->setVisible((guide.kind == GuideKind::line) != (field.axis == along));
    }
}

void GuideCard::showNews(const GuideNews* news, LengthUnit unit) {
    news_.clear();
    if (news != nullptr && news->is == GuideNews::Is::holding)
        news_ = guide_.kind == GuideKind::levels ? tr("active on level %1").arg(news->level) : tr("active");
    if (news != nullptr && news->is == GuideNews::Is::overruled) news_ = tr("waits for another");
    if (news != nullptr && news->is == GuideNews::Is::away && guide_.kind != GuideKind::axis)
        news_ = tr("%1 off").arg(lengthText(news->distance, unit));
    switch_->show(guideName(guide_.kind), guide_.on, news_);
}

void GuideCard::setUnit(LengthUnit unit) {
    for (const Field& field : fields_) field.field->setLengthUnit(unit);
}

} // namespace burin
