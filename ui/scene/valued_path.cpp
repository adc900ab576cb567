// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/valued_path.h"

#include "core/base/units.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkUnsignedCharArray.h>

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double haloWidth = 2.0; // in widths of the line
constexpr int legendMarks = 5;

/// viridis (S. van der Walt, N. Smith, 2015, matplotlib, CC0), nine of its colours.
constexpr std::array<std::array<int, 3>, 9> viridis{{{68, 1, 84},
                                                     {71, 44, 122},
                                                     {59, 81, 139},
                                                     {44, 113, 142},
                                                     {33, 144, 141},
                                                     {39, 173, 129},
                                                     {92, 200, 99},
                                                     {170, 220, 50},
                                                     {253, 231, 37}}};
const QColor withoutValue(128, 128, 122);

QColor colourOf(const ValuedPiece& piece, const PathValues& values) {
    if (!piece.value) return withoutValue;
    const double range = values.high - values.low;
    return valueColour(range > 0.0 ? (*piece.value - values.low) / range : 1.0);
}

/// The number of decimals needed to distinguish the marks of a scale.
int decimalsFor(double range) {
    if (!(range > 0.0)) return 3;
    return std::clamp(static_cast<int>(std::ceil(-std::log10(range / (legendMarks - 1)))) + 1, 0, 4);
}

/// Values and unit in the user's length unit.
struct ShownUnit {
    double factor = 1.0;
    QString text;
};
ShownUnit shownUnit(PathQuantity quantity, LengthUnit unit) {
    const bool inch = unit == LengthUnit::inch;
    switch (quantity) {
    case PathQuantity::feed:
        return inch ? ShownUnit{1.0 / millimetresPerInch, QStringLiteral("in/min")}
                    : ShownUnit{1.0, QStringLiteral("mm/min")};
    case PathQuantity::height:
    case PathQuantity::deviation:
        return inch ? ShownUnit{1.0 / millimetresPerInch, QStringLiteral("in")} : ShownUnit{1.0, QStringLiteral("mm")};
    default: {
        const std::string_view text = unitOf(quantity);
        return {1.0, QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))};
    }
    }
}

} // namespace

QColor valueColour(double share) {
    const double along = std::clamp(share, 0.0, 1.0) * static_cast<double>(viridis.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(along), viridis.size() - 2);
    std::array<int, 3> colour{};
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] = static_cast<int>(
            std::lround(std::lerp(viridis[below][i], viridis[below + 1][i], along - static_cast<double>(below))));
    return {colour[0], colour[1], colour[2]};
}

ValuedPath::ValuedPath(vtkRenderer& renderer)
    : renderer_(renderer)
    , halo_(raisedLineActor(vtkNew<vtkPolyData>(), seamHeight))
    , line_(raisedLineActor(vtkNew<vtkPolyData>(), overSeamHeight))
    , scale_(renderer) {
    line_->GetMapper()->ScalarVisibilityOn();
    renderer_.AddActor(halo_);
    renderer_.AddActor(line_);
    setVisible(true);
}

ValuedPath::~ValuedPath() {
    renderer_.RemoveActor(halo_);
    renderer_.RemoveActor(line_);
}

void ValuedPath::setPalette(const Palette& palette) {
    setColour(*halo_, palette.pathHalo);
    scale_.setPalette(palette);
}

void ValuedPath::setUnit(LengthUnit unit) {
    unit_ = unit;
    fillScale();
}

void ValuedPath::setLineWidth(double screenPixels) {
    burin::setLineWidth(*line_, screenPixels);
    burin::setLineWidth(*halo_, haloWidth * screenPixels);
}

void ValuedPath::setValues(std::shared_ptr<const PathValues> values) {
    if (values == values_) return; // called again with each change of the path
    values_ = std::move(values);
    std::vector<LineEnds> lines;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    if (values_)
        for (const ValuedPiece& piece : values_->pieces) {
            const QColor colour = colourOf(piece, *values_);
            lines.emplace_back(piece.from, piece.to);
            colours->InsertNextTuple3(colour.red(), colour.green(), colour.blue());
        }
    const vtkSmartPointer<vtkPolyData> data = lineData(lines);
    data->GetCellData()->SetScalars(colours);
    for (vtkActor* actor : {halo_.Get(), line_.Get()})
        vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->SetInputData(data);
    fillScale();
    setVisible(visible_);
}

void ValuedPath::setVisible(bool visible) {
    visible_ = visible;
    halo_->SetVisibility(shown());
    line_->SetVisibility(shown());
    scale_.setVisible(shown());
}

void ValuedPath::fillScale() {
    if (!values_) return;
    const ShownUnit unit = shownUnit(values_->quantity, unit_);
    const TextId title = titleOf(values_->quantity);
    const double low = unit.factor * values_->low, high = unit.factor * values_->high;
    const int marks = high > low ? legendMarks : 1;
    QStringList numbers;
    for (int i = 0; i < marks; ++i)
        numbers << fixedNumber(marks == 1 ? low : std::lerp(low, high, i / (marks - 1.0)), decimalsFor(high - low));
    scale_.set({QStringLiteral("%1, %2").arg(QCoreApplication::translate(title.context, title.text), unit.text),
                valueColour, std::move(numbers)});
}

} // namespace burin
