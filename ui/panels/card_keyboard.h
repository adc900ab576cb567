// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Keeps the keyboard focus in its position in a list of cards that are disabled while work runs, or recreated. Qt
/// would pass the focus to the next widget, where a key or the wheel might change something. GUI thread.
class CardKeyboard {
public:
    /// @param list contains the cards; has the focus in the meantime, where keys have no effect
    /// @param prefix of the object names in a card: "edit" for "edit2Switch"
    CardKeyboard(QWidget* list, QString prefix) : list_(list), prefix_(std::move(prefix)) {}

    /// Call when a card is about to change its position: the focus moves with it.
    void follow(std::size_t from, std::size_t to) { moved_ = {from, to}; }
    /// Gives the focus to a part of a new card as soon as that part is enabled, and scrolls it into view.
    void await(std::size_t card, const QString& part);
    /// Call before cards are disabled or recreated.
    template <class Card>
    void take(const std::vector<Card*>& cards) {
        takeFrom({cards.begin(), cards.end()});
    }
    /// Call afterwards: returns the focus to where it was, as soon as that widget is enabled, unless the user has moved
    /// it elsewhere.
    template <class Card>
    void give(const std::vector<Card*>& cards) {
        giveTo({cards.begin(), cards.end()});
    }

private:
    void takeFrom(const std::vector<QWidget*>& cards);
    void giveTo(const std::vector<QWidget*>& cards);

    struct Move {
        std::size_t from = 0, to = 0;
    };
    struct Place {
        std::size_t card = 0;
        QString part; ///< the part of the widget's name after the card's number; empty: the card itself
        bool isNew = false;
    };

    QWidget* list_;
    QString prefix_;
    std::optional<Move> moved_;
    std::optional<Place> place_; ///< the position that waits for the focus
};

} // namespace burin
