// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/guide_panel.h"

#include "ui/panels/buttons.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/guide_card.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/panel_layout.h"

#include <QCheckBox>

#include <array>

namespace burin {
namespace {

constexpr std::array offered{GuideKind::levels,  GuideKind::plane,    GuideKind::line, GuideKind::curve,
                             GuideKind::surface, GuideKind::stepOver, GuideKind::axis};

} // namespace

class GuidePanel::Fields : public QObject {
public:
    explicit Fields(GuidePanel* panel);
    void refresh();
    void setUnit(LengthUnit wanted);

    GuideState state;

private:
    void addHead();
    void rebuildCards();
    void refreshAdd();
    GuideKind wanted() const { return offered[static_cast<std::size_t>(kind_->currentIndex())]; }

    GuidePanel* panel_;
    QVBoxLayout *column_, *list_;
    QCheckBox* on_;
    ChoiceBox* kind_;
    QPushButton *add_, *above_, *below_;
    QLabel* none_;
    std::vector<GuideCard*> cards_;
    LengthUnit unit_ = LengthUnit::millimetre;
};

GuidePanel::Fields::Fields(GuidePanel* panel) : QObject(panel), panel_(panel), column_(makePanelLayout(panel)) {
    column_->addWidget(makeSectionTitle(GuidePanel::tr("Guides"), panel));
    addHead();
    none_ = makeWrappedLabel(panel);
    none_->setProperty("look", "quiet");
    setWrappedText(
        none_, GuidePanel::tr(
                   "There is no guide yet. A guide attracts the tool nearby, and releases it when it is pushed away."));
    column_->addWidget(none_);
    list_ = new QVBoxLayout;
    list_->setSpacing(8);
    column_->addLayout(list_);
    column_->addStretch(1);
}

void GuidePanel::Fields::addHead() {
    on_ = new QCheckBox(GuidePanel::tr("Guides on"), panel_);
    on_->setObjectName(QStringLiteral("guidesSwitch"));
    on_->setToolTip(GuidePanel::tr("Switch all guides on or off"));
    column_->addWidget(on_);
    connect(on_, &QCheckBox::clicked, panel_, &GuidePanel::guidesToggled);
    kind_ = new ChoiceBox(panel_);
    kind_->setObjectName(QStringLiteral("guideKind"));
    kind_->setAccessibleName(GuidePanel::tr("Kind of guide"));
    kind_->setToolTip(GuidePanel::tr("Kind of guide to add"));
    for (const GuideKind kind : offered) kind_->addItem(guideName(kind));
    add_ = makeButton(GuidePanel::tr("Add"), QStringLiteral("add"), QStringLiteral("addGuideButton"), panel_);
    connect(kind_, &QComboBox::currentIndexChanged, this, [this] { refreshAdd(); });
    connect(add_, &QPushButton::clicked, this, [this] { emit panel_->guideRequested(wanted()); });
    auto* both = new QHBoxLayout;
    both->setSpacing(8);
    both->addWidget(kind_, 1);
    both->addWidget(add_);
    column_->addLayout(both);
    above_ = makeButton(GuidePanel::tr("Level above"), {}, QStringLiteral("levelAboveButton"), panel_);
    below_ = makeButton(GuidePanel::tr("Level below"), {}, QStringLiteral("levelBelowButton"), panel_);
    connect(above_, &QPushButton::clicked, this, [this] { emit panel_->levelStepped(1); });
    connect(below_, &QPushButton::clicked, this, [this] { emit panel_->levelStepped(-1); });
    auto* steps = new QHBoxLayout;
    steps->setSpacing(8);
    steps->addWidget(above_, 1);
    steps->addWidget(below_, 1);
    column_->addLayout(steps);
}

void GuidePanel::Fields::rebuildCards() {
    for (GuideCard* card : cards_) {
        list_->removeWidget(card);
        card->hide();
        card->deleteLater(); // one of them may be emitting its own removal request
    }
    cards_.clear();
    for (std::size_t i = 0; i < state.guides.size(); ++i) {
        auto* card = new GuideCard(i, state.guides[i], panel_);
        card->setUnit(unit_);
        addCard(list_, card);
        connect(card, &GuideCard::edited, this, [this, i](const Guide& guide) { emit panel_->guideEdited(i, guide); });
        connect(card, &GuideCard::removalRequested, this, [this, i] { emit panel_->guideRemovalRequested(i); });
        cards_.push_back(card);
    }
}

void GuidePanel::Fields::refreshAdd() {
    const bool edge = wanted() == GuideKind::curve;
    const QString reason = state.full             ? GuidePanel::tr("No more guides can be added. Delete one first.")
                           : edge && !state.edges ? GuidePanel::tr("This part is a mesh, which has no edges to follow.")
                                                  : QString();
    enableUnless(add_, reason,
                 edge ? GuidePanel::tr("A guide along the edge of the part that is nearest to the tool")
                      : GuidePanel::tr("Adds a guide. If guides contradict each other, the upper one applies"));
}

void GuidePanel::Fields::refresh() {
    const bool same = std::equal(cards_.begin(), cards_.end(), state.guides.begin(), state.guides.end(),
                                 [](const GuideCard* card, const Guide& guide) { return card->kind() == guide.kind; });
    if (!same) rebuildCards();
    bool steps = false;
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        cards_[i]->showGuide(state.guides[i], state.zero);
        cards_[i]->showNews(state.live ? &state.news[i] : nullptr, unit_);
        steps = steps || state.guides[i].kind == GuideKind::levels || state.guides[i].kind == GuideKind::stepOver;
    }
    on_->setChecked(state.on);
    none_->setVisible(state.guides.empty());
    refreshAdd();
    const QString noLevel = !steps        ? GuidePanel::tr("No guide has levels or passes.")
                            : !state.live ? GuidePanel::tr("Press Mill first.")
                                          : QString();
    enableUnless(above_, noLevel, GuidePanel::tr("The guide takes the next level above, or ends the pass"));
    enableUnless(below_, noLevel, GuidePanel::tr("The guide takes the next level below, or ends the pass"));
}

void GuidePanel::Fields::setUnit(LengthUnit wanted) {
    unit_ = wanted;
    for (GuideCard* card : cards_) card->setUnit(wanted);
}

GuidePanel::GuidePanel(QWidget* parent) : QWidget(parent), fields_(new Fields(this)) {
    setObjectName(QStringLiteral("guidePanel"));
    fields_->refresh();
}

void GuidePanel::setUnit(LengthUnit unit) {
    fields_->setUnit(unit);
}

void GuidePanel::setState(const GuideState& state) {
    fields_->state = state;
    fields_->refresh();
}

} // namespace burin
