// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/bounds_panel.h"

#include "ui/panels/obstacle_card.h"
#include "ui/panels/panel_layout.h"

#include <QCheckBox>

namespace burin {

class BoundsPanel::Fields : public QObject {
public:
    explicit Fields(BoundsPanel* panel);
    void refresh();

    SurroundingsState state;

private:
    struct Row {
        QCheckBox* box;
        QLabel* news;
    };
    Row addRow(QVBoxLayout* column, const QString& name);
    static void show(const Row& row, const QString& title, bool on, BoundNews news);

    BoundsPanel* panel_;
    QVBoxLayout *column_, *list_;
    std::vector<Row> rows_;
    Row travel_;
};

BoundsPanel::Fields::Fields(BoundsPanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(BoundsPanel::tr("What keeps the tool out"), panel));
    list_ = new QVBoxLayout;
    list_->setSpacing(4);
    column_->addLayout(list_);
    travel_ = addRow(column_, QStringLiteral("boundTravel"));
    connect(travel_.box, &QCheckBox::clicked, panel, &BoundsPanel::travelSwitched);
}

BoundsPanel::Fields::Row BoundsPanel::Fields::addRow(QVBoxLayout* column, const QString& name) {
    auto* line = new QWidget(panel_);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    Row made{new QCheckBox(line), new QLabel(line)};
    made.box->setObjectName(name + QStringLiteral("Switch"));
    made.box->setToolTip(
        BoundsPanel::tr("Whether it keeps the tool out; one that the tool is inside of waits until it is clear"));
    made.news->setObjectName(name + QStringLiteral("News"));
    made.news->setProperty("look", "small");
    row->addWidget(made.box, 1);
    row->addWidget(made.news);
    column->addWidget(line);
    return made;
}

void BoundsPanel::Fields::show(const Row& row, const QString& title, bool on, BoundNews news) {
    if (row.box->text() != title) row.box->setText(title);
    row.box->setChecked(on); // `clicked` is the user's alone
    const QString text = boundNewsText(news);
    if (row.news->text() != text) row.news->setText(text);
}

void BoundsPanel::Fields::refresh() {
    while (rows_.size() > state.obstacles.size()) {
        rows_.back().box->parentWidget()->hide();
        rows_.back().box->parentWidget()->deleteLater();
        rows_.pop_back();
    }
    while (rows_.size() < state.obstacles.size()) {
        const std::size_t place = rows_.size();
        rows_.push_back(addRow(list_, QStringLiteral("bound%1").arg(place)));
        connect(rows_.back().box, &QCheckBox::clicked, panel_,
                [this, place](bool on) { emit panel_->obstacleSwitched(place, on); });
    }
    for (std::size_t i = 0; i < rows_.size(); ++i)
        show(rows_[i], QString::fromStdString(state.obstacles[i].obstacle->name), state.obstacles[i].on,
             state.obstacles[i].news);
    show(travel_, BoundsPanel::tr("Machine's travel"), state.travelOn, state.travel);
    const bool stands = !state.axis.free && state.axis.direction == glm::dvec3(0.0, 0.0, 1.0);
    travel_.box->parentWidget()->setVisible(stands);
    panel_->setVisible(stands || !rows_.empty());
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
