// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

namespace burin {

/// Keeps the keyboard at its place in a list of cards that are disabled while work runs, or made anew. Qt would hand it
/// on to what comes next, where a key or the wheel may change something. GUI thread.
class CardKeyboard {
public:
    /// @param list holds the cards; the keyboard waits there, and does nothing
    /// @param prefix of the names in a card: "edit" for "edit2Switch"
    CardKeyboard(QWidget* list, QString prefix) : list_(list), prefix_(std::move(prefix)) {}

    /// A card is about to change its place: the keyboard goes with it.
    void follow(std::size_t from, std::size_t to) { moved_ = {from, to}; }
    /// A part of a card that was just made gets the keyboard as soon as it is enabled, and is brought into view.
    void await(std::size_t card, const QString& part);
    /// Before cards are disabled or made anew.
    template <class Card>
    void take(const std::vector<Card*>& cards) {
        takeFrom({cards.begin(), cards.end()});
    }
    /// Afterwards: back to where it was, as soon as that is enabled, unless the user took it elsewhere.
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
        QString part; ///< what the widget's name says behind the card's number; empty: the card itself
        bool isNew = false;
    };

    QWidget* list_;
    QString prefix_;
    std::optional<Move> moved_;
    std::optional<Place> place_; ///< that waits
};

} // namespace burin
