// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QGridLayout;

namespace burin {

/// What a key, or something done with the mouse, does.
struct KeyLine {
    QString input, effect;
    QString explanation{}; ///< a tooltip
};

/// A list of them, in two columns.
class KeyLines final : public QWidget {
    Q_OBJECT
public:
    explicit KeyLines(const std::vector<KeyLine>& lines, QWidget* parent = nullptr);

    /// Shows those lines alone that hold a text, whatever its case. @return whether there are any
    bool showOnly(const QString& text);

    int keyWidth() const; ///< pixels that the keys need
    void setKeyWidth(int pixels);

private:
    struct Row {
        QString text;
        QWidget *key, *effect;
    };
    QGridLayout* grid_;
    std::vector<Row> rows_;
};

/// Of mouse and keys beside the menus' shortcuts.
class HandKeys final : public QObject {
    Q_OBJECT
public:
    static std::vector<KeyLine> inMillMode();
    static std::vector<KeyLine> onThePath();
    static std::vector<KeyLine> ofTheView();
};

} // namespace burin
