// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/obstacle_card.h"

#include "core/setup/obstacle_motion.h"
#include "ui/messages/messages.h"
#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/field_row.h"
#include "ui/panels/fixture_labels.h"
#include "ui/panels/focus_keeper.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/length_field.h"
#include "ui/panels/named_switch.h"
#include "ui/panels/panel_layout.h"
#include "ui/panels/texts.h"

#include <utility>

namespace burin {
namespace {

constexpr double farthestCoordinate = 10'000.0, smallest = 0.01, widestMargin = 100.0; // mm

Box& boxOf(Obstacle& obstacle) {
    return std::get<burin::Box>(obstacle.shape);
}
const Box& boxOf(const Obstacle& obstacle) {
    return std::get<burin::Box>(obstacle.shape);
}
CylinderShape& cylinderOf(Obstacle& obstacle) {
    return std::get<CylinderShape>(obstacle.shape);
}
const CylinderShape& cylinderOf(const Obstacle& obstacle) {
    return std::get<CylinderShape>(obstacle.shape);
}

} // namespace

QString boundNewsText(BoundNews news) {
    switch (news) {
    case BoundNews::waits:
        return ObstacleCard::tr("waits until the tool is out");
    case BoundNews::holds:
        return ObstacleCard::tr("holds the tool");
    case BoundNews::none:
        break;
    }
    return {};
}

ObstacleCard::ObstacleCard(std::size_t place, const Obstacle& obstacle, QWidget* parent)
    : QFrame(parent), name_(QStringLiteral("obstacle%1").arg(place)), obstacle_(obstacle) {
    setProperty("look", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 6, 8, 8);
    column->setSpacing(4);
    addHead();
    figures_ = new QWidget(this);
    auto* inner = new QVBoxLayout(figures_);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(4);
    column->addWidget(figures_);
    addShape();
    addRow(tr("Clearance"), tr("Distance that every point of the tool keeps from it"),
           addField(
               QStringLiteral("Margin"), tr("Clearance"), -1, [](const Obstacle& of) { return of.margin; },
               [](Obstacle& of, double value) { of.margin = value; }));
    fields_.back().field->limit(0.0, widestMargin);
    setUnit(LengthUnit::millimetre);
}

void ObstacleCard::addHead() {
    switch_ = new NamedSwitch(name_, tr("Whether it keeps the tool out"), this);
    connect(switch_, &NamedSwitch::switched, this, &ObstacleCard::switched);
    remove_ = makeIconButton(QStringLiteral("remove"), tr("Delete it"), name_ + QStringLiteral("Remove"), this);
    remove_->setAccessibleName(QString::fromStdString(obstacle_.name) + QStringLiteral(", ") + remove_->toolTip());
    connect(remove_, &QToolButton::clicked, this, &ObstacleCard::removalRequested);
    auto* head = new QHBoxLayout;
    head->addWidget(switch_, 1);
    change_ = makeIconButton(QStringLiteral("edit"), changeTip(), name_ + QStringLiteral("Change"), this);
    change_->setAccessibleName(QString::fromStdString(obstacle_.name) + QStringLiteral(", ") + change_->toolTip());
    change_->setCheckable(!obstacle_.design); // while it is moved in the view
    connect(change_, &QToolButton::clicked, this, &ObstacleCard::changeRequested);
    head->addWidget(change_);
    head->addWidget(remove_);
    static_cast<QVBoxLayout*>(layout())->addLayout(head);
}

QuantityField* ObstacleCard::addField(const QString& name, const QString& label, int axis, Get get, Set set) {
    auto* field = new LengthField(figures_);
    field->setObjectName(name_ + name);
    field->setAccessibleName(QString::fromStdString(obstacle_.name) + QStringLiteral(", ") + label);
    fields_.push_back({field, std::move(get), axis});
    connect(field, &QuantityField::valueEdited, this, [this, axis, set = std::move(set)](double wanted) {
        set(obstacle_, axis < 0 ? wanted : wanted + zero_[axis]);
        shown_.reset();
        emit edited(obstacle_);
    });
    return field;
}

void ObstacleCard::addRow(const QString& label, const QString& toolTip, QuantityField* field) {
    const QString accessible = field->accessibleName();
    figures_->layout()->addWidget(new FieldRow(label, field, toolTip, figures_));
    field->setAccessibleName(accessible);
}

/// Three fields side by side below a label.
void ObstacleCard::addTriple(const QString& name, const QString& label, const QString& toolTip, bool place,
                             const std::function<Get(int)>& get, const std::function<Set(int)>& set) {
    auto* title = new QLabel(figures_);
    titles_.push_back({title, label});
    title->setProperty("look", "quiet");
    title->setToolTip(toolTip);
    figures_->layout()->addWidget(title);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (int axis = 0; axis < 3; ++axis) {
        const QString letter = axisLetter(axis);
        QuantityField* field =
            addField(name + letter, label + QLatin1Char(' ') + letter, place ? axis : -1, get(axis), set(axis));
        field->limit(place ? -farthestCoordinate : smallest, farthestCoordinate);
        field->setToolTip(toolTip);
        field->setMinimumWidth(40);
        fields_.back().bare = true;
        row->addWidget(field, 1);
    }
    static_cast<QVBoxLayout*>(figures_->layout())->addLayout(row);
}

void ObstacleCard::addShape() {
    kind_ = new ChoiceBox(figures_);
    kind_->setObjectName(name_ + QStringLiteral("Kind"));
    kind_->addItems({tr("Fixture"), tr("Keep-out volume")}); // in the order of ObstacleKind
    figures_->layout()->addWidget(new FieldRow(
        tr("Kind"), kind_, tr("A fixture is a solid object; a keep-out volume has to stay clear of the tool"), figures_,
        FieldRow::choiceWidth));
    connect(kind_, &QComboBox::activated, this, [this](int index) {
        obstacle_.kind = static_cast<ObstacleKind>(index);
        shown_.reset();
        emit edited(obstacle_);
    });
    if (std::holds_alternative<burin::Box>(obstacle_.shape)) {
        addTriple(
            QStringLiteral("Place"), tr("From"), tr("The corner with the lowest coordinates, from program zero"), true,
            [](int axis) -> Get { return [axis](const Obstacle& of) { return boxOf(of).low[axis]; }; },
            [](int axis) -> Set {
                return [axis](Obstacle& of, double value) {
                    boxOf(of).high[axis] += value - boxOf(of).low[axis]; // moves the box without changing its size
                    boxOf(of).low[axis] = value;
                };
            });
        addTriple(
            QStringLiteral("Size"), tr("Size"), tr("Length of its edges"), false,
            [](int axis) -> Get { return [axis](const Obstacle& of) { return boxOf(of).size()[axis]; }; },
            [](int axis) -> Set {
                return [axis](Obstacle& of, double value) { boxOf(of).high[axis] = boxOf(of).low[axis] + value; };
            });
    } else if (std::holds_alternative<CylinderShape>(obstacle_.shape)) {
        addTriple(
            QStringLiteral("Place"), tr("Base"), tr("The middle of its lower face, from program zero"), true,
            [](int axis) -> Get { return [axis](const Obstacle& of) { return cylinderOf(of).base[axis]; }; },
            [](int axis) -> Set { return [axis](Obstacle& of, double value) { cylinderOf(of).base[axis] = value; }; });
        addRow(tr("Diameter"), tr("Of the cylinder"),
               addField(
                   QStringLiteral("Diameter"), tr("Diameter"), -1,
                   [](const Obstacle& of) { return 2.0 * cylinderOf(of).radius; },
                   [](Obstacle& of, double value) { cylinderOf(of).radius = 0.5 * value; }));
        fields_.back().field->limit(smallest, farthestCoordinate);
        addRow(tr("Height"), tr("Of the cylinder"),
               addField(
                   QStringLiteral("Height"), tr("Height"), -1, [](const Obstacle& of) { return cylinderOf(of).height; },
                   [](Obstacle& of, double value) { cylinderOf(of).height = value; }));
        fields_.back().field->limit(smallest, farthestCoordinate);
    } else {
        QLabel* origin = makeWrappedLabel(figures_);
        origin->setObjectName(name_ + QStringLiteral("Origin"));
        origin->setProperty("look", "small");
        figures_->layout()->addWidget(origin);
        setWrappedText(origin, obstacle_.design
                                   ? tr("From the library: %1").arg(Messages::text(rowOf(obstacle_.design->kind).title))
                                   : tr("From a file, %1 triangles")
                                         .arg(countText(std::get<TriangleMesh>(obstacle_.shape).triangles.size())));
        if (!obstacle_.design) addMeshPlace();
    }
    notFitting_ = makeWrappedLabel(figures_);
    notFitting_->setObjectName(name_ + QStringLiteral("Fit"));
    notFitting_->setProperty("look", "small");
    figures_->layout()->addWidget(notFitting_);
}

void ObstacleCard::addMeshPlace() {
    addTriple(
        QStringLiteral("Place"), tr("From"), tr("The corner with the lowest coordinates, from program zero"), true,
        [](int axis) -> Get {
            return [axis](const Obstacle& of) {
                const burin::Box box = boundsOf(of);
                return box.empty() ? 0.0 : box.low[axis];
            };
        },
        [](int axis) -> Set {
            return [axis](Obstacle& of, double value) {
                glm::dvec3 shift(0.0);
                shift[axis] = value - boundsOf(of).low[axis];
                if (Result<Obstacle> there = moved(of, movedBy(shift))) of = *std::move(there);
            };
        });
}

QString ObstacleCard::changeTip() const {
    return obstacle_.design ? tr("Change its sizes and its position")
                            : tr("Move it in the view, with the mouse or the keys");
}

void ObstacleCard::showFit() {
    const QString text = fitText(obstacle_.name, fit_, unit_);
    notFitting_->setVisible(!text.isEmpty());
    setWrappedText(notFitting_, text);
}

void ObstacleCard::showRow(const ObstacleRow& row, const glm::dvec3& zero, bool locked) {
    if (shown_ != row.obstacle) obstacle_ = *row.obstacle;
    shown_ = row.obstacle;
    zero_ = zero;
    fit_ = row.fit;
    showFit();
    change_->setChecked(row.moving);
    switch_->show(title(), row.on, boundNewsText(row.news));
    kind_->setCurrentIndex(static_cast<int>(obstacle_.kind));
    for (const Field& field : fields_) {
        const double value = field.get(obstacle_);
        field.field->showValue(field.axis < 0 ? value : value - zero[field.axis]);
    }
    setEnabledKeepingFocus(figures_, !locked);
    enableUnless(change_, locked ? tr("Stop the recording first.") : QString(), changeTip());
    enableUnless(remove_, locked ? tr("Stop the recording first.") : QString(), tr("Delete it"));
}

void ObstacleCard::setUnit(LengthUnit unit) {
    unit_ = unit;
    showFit();
    for (const Field& field : fields_) {
        field.field->setLengthUnit(unit);
        if (field.bare) field.field->setSuffix({}); // three fields side by side have no room for it
    }
    for (const Title& title : titles_) title.label->setText(tr("%1 X, Y, Z, in %2").arg(title.text, unitText(unit)));
}

} // namespace burin
