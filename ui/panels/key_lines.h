// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QGridLayout;

namespace burin {

/// The effect of a key or a mouse action.
struct KeyLine {
    QString input, effect;
    QString explanation{}; ///< a tooltip
};

/// A list of key and mouse actions, in two columns.
class KeyLines final : public QWidget {
    Q_OBJECT
public:
    explicit KeyLines(const std::vector<KeyLine>& lines, QWidget* parent = nullptr);

    /// Shows only the lines that contain `text` (case-insensitive). @return whether there are any
    bool showOnly(const QString& text);

    int keyWidth() const; ///< required width of the key column, pixels
    void setKeyWidth(int pixels);

private:
    struct Row {
        QString text;
        QWidget *key, *effect;
    };
    QGridLayout* grid_;
    std::vector<Row> rows_;
};

/// Mouse and key actions in addition to the menu shortcuts.
class HandKeys final : public QObject {
    Q_OBJECT
public:
    static std::vector<KeyLine> inMillMode();
    static std::vector<KeyLine> onThePath();
    static std::vector<KeyLine> ofAFixture(); ///< while one is placed
    static std::vector<KeyLine> ofTheView();
};

} // namespace burin
