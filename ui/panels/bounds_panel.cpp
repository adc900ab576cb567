// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/bounds_panel.h"

#include "ui/panels/named_switch.h"
#include "ui/panels/obstacle_card.h"
#include "ui/panels/panel_layout.h"

namespace burin {

class BoundsPanel::Fields : public QObject {
public:
    explicit Fields(BoundsPanel* panel);
    void refresh();

    SurroundingsState state;

private:
    NamedSwitch* addSwitch(QVBoxLayout* column, const QString& name);

    BoundsPanel* panel_;
    QVBoxLayout *column_, *list_;
    std::vector<NamedSwitch*> switches_;
    NamedSwitch* travel_;
};

BoundsPanel::Fields::Fields(BoundsPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(BoundsPanel::tr("Fixtures and limits"), panel));
    list_ = new QVBoxLayout;
    list_->setSpacing(4);
    column_->addLayout(list_);
    travel_ = addSwitch(column_, QStringLiteral("boundTravel"));
    connect(travel_, &NamedSwitch::switched, panel, &BoundsPanel::travelSwitched);
}

NamedSwitch* BoundsPanel::Fields::addSwitch(QVBoxLayout* column, const QString& name) {
    auto* made = new NamedSwitch(
        name, BoundsPanel::tr("Whether it keeps the tool out. If the tool is inside, it waits until the tool is clear"),
        panel_);
    column->addWidget(made);
    return made;
}

void BoundsPanel::Fields::refresh() {
    while (switches_.size() > state.obstacles.size()) {
        switches_.back()->hide();
        switches_.back()->deleteLater();
        switches_.pop_back();
    }
    while (switches_.size() < state.obstacles.size()) {
        const std::size_t place = switches_.size();
        switches_.push_back(addSwitch(list_, QStringLiteral("bound%1").arg(place)));
        connect(switches_.back(), &NamedSwitch::switched, panel_,
                [this, place](bool on) { emit panel_->obstacleSwitched(place, on); });
    }
    for (std::size_t i = 0; i < switches_.size(); ++i) {
        const ObstacleRow& row = state.obstacles[i];
        switches_[i]->show(QString::fromStdString(row.obstacle->name), row.on, boundNewsText(row.news));
    }
    travel_->show(BoundsPanel::tr("Machine's travel"), state.travelOn, boundNewsText(state.travel));
    const bool stands = !state.axis.free && state.axis.direction == glm::dvec3(0.0, 0.0, 1.0);
    travel_->setVisible(stands);
    panel_->setVisible(stands || !switches_.empty());
}

BoundsPanel::BoundsPanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("boundsPanel"));
    fields_->refresh();
}

void BoundsPanel::setState(const SurroundingsState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
