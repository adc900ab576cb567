// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/how_to_mill.h"

#include "ui/panels/panel_layout.h"

#include <QGridLayout>

namespace burin {

HowToMill::HowToMill(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    const std::pair<QString, QString> lines[] = {
        {tr("Move"), tr("The tool floats over the workpiece.")},
        {tr("Left drag"), tr("Cuts a stroke.")},
        {tr("Wheel"), tr("Raises and lowers the tool.")},
        {tr("Shift"), tr("Makes pointer and wheel fine.")},
        {tr("Right drag"), tr("Turns the view.")},
        {tr("Arrows"), tr("Move the tool by a voxel.")},
        {tr("Page up, down"), tr("Raise and lower the tool.")},
        {tr("Space"), tr("Holds the spindle on.")},
        {tr("Esc"), tr("Leaves mill mode.")},
    };
    int row = 0;
    for (const auto& [input, effect] : lines) {
        auto* key = new QLabel(input, this);
        key->setProperty("look", "key");
        QLabel* text = makeWrappedLabel(this);
        text->setProperty("look", "small");
        setWrappedText(text, effect);
        grid->addWidget(key, row, 0, Qt::AlignLeft | Qt::AlignTop);
        grid->addWidget(text, row, 1);
        ++row;
    }
}

} // namespace burin
