// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/flying_edges.h"

#include "core/volume/runs/voxel_runs.h"

#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstring>

namespace burin::benchmarks {

namespace {

constexpr std::int32_t samples = flyingBrickSide + 2;

} // namespace

class FlyingEdges::Filter {
public:
    explicit Filter(Kind kind) {
        image_->SetDimensions(samples, samples, samples);
        image_->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
        if (kind == Kind::discrete) {
            const vtkNew<vtkDiscreteFlyingEdges3D> filter;
            filter->SetValue(0, 1.0);
            setUp(*filter);
        } else {
            const vtkNew<vtkFlyingEdges3D> filter;
            filter->SetValue(0, 0.5);
            setUp(*filter);
        }
    }

    void expand(const VolumeSnapshot& volume, const Brick& brick) {
        const Grid& grid = volume.grid();
        auto* row = static_cast<std::uint8_t*>(image_->GetScalarPointer());
        for (std::int32_t v = brick.v - 1; v <= brick.v + flyingBrickSide; ++v)
            for (std::int32_t u = brick.u - 1; u <= brick.u + flyingBrickSide; ++u, row += samples) {
                std::memset(row, 0, samples);
                if (!grid.contains(LineIndex{u, v})) continue;
                forEachVoxelRun(volume.line({u, v}), [&](const Run& run) {
                    const std::int32_t first = std::max(run.first - brick.along + 1, 0);
                    const std::int32_t end = std::min(run.last - brick.along + 2, samples);
                    if (run.property != airProperty && first < end)
                        std::memset(row + first, 1, static_cast<std::size_t>(end - first));
                });
            }
        image_->Modified();
    }
    std::int64_t mesh() {
        algorithm_->Update();
        return vtkPolyData::SafeDownCast(algorithm_->GetOutputDataObject(0))->GetNumberOfPolys();
    }

private:
    /// Triangles only: the minimum that a caller pays.
    template <class Edges>
    void setUp(Edges& filter) {
        filter.ComputeNormalsOff();
        filter.ComputeGradientsOff();
        filter.ComputeScalarsOff();
        filter.SetInputData(image_);
        algorithm_ = &filter;
    }

    vtkNew<vtkImageData> image_;
    vtkSmartPointer<vtkAlgorithm> algorithm_;
};

FlyingEdges::FlyingEdges(Kind kind) : filter_(std::make_unique<Filter>(kind)) {}
FlyingEdges::~FlyingEdges() = default;

void FlyingEdges::expand(const VolumeSnapshot& volume, const Brick& brick) {
    filter_->expand(volume, brick);
}
std::int64_t FlyingEdges::mesh() {
    return filter_->mesh();
}

} // namespace burin::benchmarks
