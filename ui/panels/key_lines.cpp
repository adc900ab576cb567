// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/key_lines.h"

#include "ui/panels/panel_layout.h"

#include <QGridLayout>

#include <algorithm>

namespace burin {

KeyLines::KeyLines(const std::vector<KeyLine>& lines, QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(12);
    grid_->setVerticalSpacing(4);
    grid_->setColumnStretch(1, 1);
    for (const KeyLine& line : lines) {
        auto* key = new QLabel(line.input, this);
        key->setProperty("look", "key");
        QLabel* effect = makeWrappedLabel(this);
        effect->setProperty("look", "small");
        effect->setToolTip(line.explanation);
        setWrappedText(effect, line.effect);
        const auto row = static_cast<int>(rows_.size());
        grid_->addWidget(key, row, 0, Qt::AlignLeft | Qt::AlignTop);
        grid_->addWidget(effect, row, 1);
        rows_.push_back({line.input + QLatin1Char('\n') + line.effect, key, effect});
    }
}

bool KeyLines::showOnly(const QString& text) {
    bool any = false;
    for (const Row& row : rows_) {
        const bool shown = row.text.contains(text, Qt::CaseInsensitive);
        row.key->setVisible(shown);
        row.effect->setVisible(shown);
        any = any || shown;
    }
    return any;
}

int KeyLines::keyWidth() const {
    int widest = 0;
    for (const Row& row : rows_) {
        row.key->ensurePolished(); // so that the window's style sheet is taken into account
        widest = std::max(widest, row.key->sizeHint().width());
    }
    return widest;
}

void KeyLines::setKeyWidth(int pixels) {
    grid_->setColumnMinimumWidth(0, pixels);
}

std::vector<KeyLine> HandKeys::inMillMode() {
    return {
        {tr("Move"), tr("Moves the tool above the workpiece.")},
        {tr("Left drag"), tr("Cuts a stroke, or draws the rectangle of a raster.")},
        {tr("Shift and click"), tr("Cuts a straight line from the end of the last stroke.")},
        {tr("X, Y"), tr("Locks strokes to X or to Y; again to unlock.")},
        {tr("D"), tr("Locks strokes to their direction; again to unlock.")},
        {tr("Wheel"), tr("Raises and lowers the tool.")},
        {tr("Shift"), tr("Fine motion of a stroke and of the wheel.")},
        {tr("Right drag"), tr("Rotates the view.")},
        {tr("Arrows"), tr("Move the tool by a voxel.")},
        {tr("Page up, down"), tr("Raise and lower the tool.")},
        {tr("Space"), tr("Keeps the spindle on.")},
        {tr("Esc"), tr("Ends the stroke, then stops milling.")},
    };
}

std::vector<KeyLine> HandKeys::onThePath() {
    return {
        {tr("Click"), tr("Selects a point of the path, or a move of the program.")},
        {tr("Shift and click"), tr("Selects everything from the last selected point to this one.")},
        {tr("Left drag"), tr("Moves the point; while something is drawn, draws it.")},
        {tr("Right click"), tr("Opens the menu of a point of the path.")},
        {tr("Esc"), tr("Cancels the current action, else clears the selection.")},
    };
}

std::vector<KeyLine> HandKeys::ofAFixture() {
    return {
        {tr("Click, left drag"), tr("Places the fixture on the stock, or on the table beside it.")},
        {tr("Arrows"), tr("Move it by 1 mm; with Shift by 0.1 mm, with Ctrl by 10 mm.")},
        {tr("Page up, down"), tr("Raise and lower it, by the same steps.")},
        {tr("R"), tr("Rotates it by 15°; with Shift by 90°.")},
        {tr("Enter"), tr("Adds it to the setup.")},
        {tr("Esc"), tr("Cancels placing.")},
    };
}

std::vector<KeyLine> HandKeys::ofTheView() {
    return {
        {tr("Right or middle drag"), tr("Rotates the view about the point under the pointer.")},
        {tr("Shift and middle drag"), tr("Pans the view; so does a drag with both buttons.")},
        {tr("Wheel"), tr("Zooms in on the point under the pointer.")},
        {tr("Click on the cube"), tr("Looks at that side.")},
        {tr("Drag a handle"),
         tr("Moves or rotates the part or a fixture; with Shift finely, with Ctrl in steps. Esc takes it back.")},
    };
}

} // namespace burin
