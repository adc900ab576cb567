// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/live_path.h"

#include "ui/scene/haloed_lines.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

namespace burin {

/// Lines of two points each, so that the end of a stroke needs no marker.
struct LivePath::Block {
    vtkSmartPointer<vtkFloatArray> points = vtkSmartPointer<vtkFloatArray>::New();
    vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
    HaloedLines drawn;

    explicit Block(vtkRenderer& renderer) : drawn(renderer) { drawn.setLines(data); }
    std::size_t lines() const { return static_cast<std::size_t>(points->GetNumberOfTuples()) / 2; }

    /// Updates VTK with the current data.
    void publish() {
        vtkNew<vtkTypeInt32Array> connectivity;
        const vtkIdType count = points->GetNumberOfTuples();
        connectivity->SetNumberOfValues(count);
        for (vtkIdType i = 0; i < count; ++i) connectivity->SetValue(i, static_cast<vtkTypeInt32>(i));
        vtkNew<vtkCellArray> cells;
        cells->SetData(2, connectivity);
        vtkNew<vtkPoints> places;
        places->SetData(points);
        data->SetPoints(places);
        data->SetLines(cells);
        points->Modified();
    }
};

LivePath::LivePath(vtkRenderer& renderer) : renderer_(renderer) {}
LivePath::~LivePath() = default;

std::unique_ptr<LivePath::Block> LivePath::makeBlock(std::size_t capacity) {
    auto block = std::make_unique<Block>(renderer_);
    block->points->SetNumberOfComponents(3);
    block->points->Allocate(static_cast<vtkIdType>(6 * capacity));
    block->drawn.setColours(colour_, halo_);
    block->drawn.setWidth(width_);
    block->drawn.setVisible(true);
    return block;
}

void LivePath::setColours(const QColor& line, const QColor& halo) {
    colour_ = line;
    halo_ = halo;
    for (const auto& block : closed_) block->drawn.setColours(line, halo);
    if (open_) open_->drawn.setColours(line, halo);
}

void LivePath::setLineWidth(double screenPixels) {
    width_ = screenPixels;
    for (const auto& block : closed_) block->drawn.setWidth(width_);
    if (open_) open_->drawn.setWidth(width_);
}

void LivePath::addLine(const glm::vec3& from, const glm::vec3& to) {
    if (open_ && open_->lines() >= blockLines) closeBlock();
    if (!open_) open_ = makeBlock(blockLines);
    open_->points->InsertNextTypedTuple(&from.x);
    open_->points->InsertNextTypedTuple(&to.x);
}

void LivePath::closeBlock() {
    open_->publish();
    closed_.push_back(std::move(open_));
    while (closed_.size() >= 2) {
        Block &last = *closed_.back(), &before = *closed_[closed_.size() - 2];
        if (before.lines() > last.lines() || before.lines() + last.lines() > largestBlock) return;
        std::unique_ptr<Block> merged = makeBlock(before.lines() + last.lines());
        merged->points->InsertTuples(0, before.points->GetNumberOfTuples(), 0, before.points);
        merged->points->InsertTuples(before.points->GetNumberOfTuples(), last.points->GetNumberOfTuples(), 0,
                                     last.points);
        merged->publish();
        closed_.pop_back();
        closed_.back() = std::move(merged);
    }
}

void LivePath::append(std::span<const glm::vec3> tips, bool newStroke) {
    if (newStroke) hasEnd_ = false;
    for (const glm::vec3& tip : tips) {
        if (!hasEnd_) {
            thinner_.begin(tip);
            hasEnd_ = true;
            endHasLine_ = false;
        } else if (thinner_.add(tip) || !endHasLine_) {
            addLine(end_, tip);
            endHasLine_ = true;
        } else {
            open_->points->SetTypedTuple(open_->points->GetNumberOfTuples() - 1, &tip.x);
        }
        end_ = tip;
    }
    if (open_) open_->publish();
}

void LivePath::clear() {
    closed_.clear();
    open_.reset();
    hasEnd_ = false;
}

} // namespace burin
