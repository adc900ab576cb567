// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/card_keyboard.h"

#include "ui/panels/focus_keeper.h"
#include "ui/panels/panel_layout.h"

#include <algorithm>

namespace burin {

void CardKeyboard::await(std::size_t card, const QString& part) {
    place_ = Place{card, part, true};
    forgetKeptFocus(list_); // where the focus of the pressed button is held while work runs
    list_->setFocus(Qt::OtherFocusReason);
}

void CardKeyboard::takeFrom(const std::vector<QWidget*>& cards) {
    QWidget* const focus = list_->window()->focusWidget();
    for (std::size_t i = 0; focus != nullptr && i < cards.size(); ++i) {
        const QString name = prefix_ + QString::number(i);
        const bool isPart = cards[i]->isAncestorOf(focus) && focus->objectName().startsWith(name);
        if (!isPart && focus != cards[i]) continue;
        const QString part = isPart ? focus->objectName().mid(name.size()) : QString();
        place_ = Place{moved_ && moved_->from == i ? moved_->to : i, part, false};
        list_->setFocus(Qt::OtherFocusReason);
    }
    moved_.reset();
}

void CardKeyboard::giveTo(const std::vector<QWidget*>& cards) {
    if (!place_) return;
    if (list_->window()->focusWidget() != list_) { // the user has moved the focus
        place_.reset();
        return;
    }
    if (cards.empty()) return;
    const std::size_t place = std::min(place_->card, cards.size() - 1);
    if (!cards[place]->isEnabled()) return;
    auto* target = cards[place]->findChild<QWidget*>(prefix_ + QString::number(place) + place_->part);
    // A button that is disabled at the end of the list: the next key press must not trigger another one.
    if (target == nullptr || !target->isEnabled()) target = cards[place];
    target->setFocus(Qt::OtherFocusReason);
    if (place_->isNew) bringIntoView(cards[place]);
    place_.reset();
}

} // namespace burin
