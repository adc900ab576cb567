// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/key_lines.h"

#include <QDialog>

class QLabel;

namespace burin {

/// Keys that belong together.
struct KeySection {
    QString title;
    std::vector<KeyLine> lines;
};

/// All keys, and what the mouse does, on one page that stays beside the window. What is typed is looked for.
class KeyList final : public QDialog {
    Q_OBJECT
public:
    explicit KeyList(const std::vector<KeySection>& sections, QWidget* parent = nullptr);

private:
    struct Shown {
        QWidget* whole;
        KeyLines* lines;
    };
    QWidget* columnsOf(const std::vector<KeySection>& sections);
    void alignKeys();
    void showOnly(const QString& text);

    std::vector<Shown> sections_;
    QLabel* nothing_ = nullptr;
};

} // namespace burin
