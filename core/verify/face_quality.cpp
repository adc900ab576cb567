// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/face_quality.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"

#include <algorithm>
#include <tuple>

namespace burin {

namespace {

/// The triangles of all faces, and the face of each triangle.
struct JoinedFaces {
    TriangleMesh mesh;
    std::vector<std::uint32_t> faceOf;

    explicit JoinedFaces(std::span<const PartFacePatch> faces) {
        for (std::uint32_t face = 0; face < faces.size(); ++face) {
            append(mesh, faces[face].mesh);
            faceOf.resize(mesh.triangles.size(), face);
        }
    }
};

/// Returns the nearest triangle of each sample. Incomplete if cancelled.
std::vector<std::size_t> nearestTriangles(const TriangleMesh& mesh, std::span<const DeviationSample> samples,
                                          Progress& progress) {
    constexpr std::size_t grain = 1024;
    const MeshDistance distance(mesh);
    std::vector<std::size_t> nearest(samples.size(), 0);
    ParallelProgress done(progress, samples.size());
    parallelIntervals(std::size_t{0}, samples.size(), grain, [&](std::size_t from, std::size_t to) {
        if (progress.cancelled()) return;
        for (std::size_t i = from; i < to; ++i) nearest[i] = distance.closest(samples[i].place).triangle;
        done.add(to - from);
    });
    return nearest;
}

WorstPoint middleOf(const TriangleMesh& mesh) {
    LargestTriangle largest;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) largest.add(cornersOf(mesh, i));
    return {0.0, largest.centroid(), unitNormal(largest.corners())};
}

void keepWorse(WorstPoint& worst, double amount, const DeviationSample& sample, const Triangle& on) {
    if (amount > worst.amount) worst = {amount, sample.place, unitNormal(on)};
}

void add(FaceQuality& face, const DeviationSample& sample, const Triangle& on, const DeviationTolerance& tolerance) {
    ++face.samples;
    face.shares.of(bandOf(sample, tolerance)) += 1.0;
    if (sample.gouge > 0.0)
        keepWorse(face.gouge, sample.gouge, sample, on);
    else if (sample.reachable)
        keepWorse(face.excess, sample.excess - tolerance.allowance, sample, on);
}

std::string fieldsOf(const WorstPoint& worst, bool known, char separator) {
    std::string fields = known ? formatFixed(worst.amount, 4) : std::string();
    for (int axis = 0; axis < 3; ++axis) {
        fields += separator;
        if (known && worst.amount > 0.0) fields += formatFixed(worst.place[axis], 4);
    }
    return fields;
}

} // namespace

Result<std::vector<FaceQuality>> faceQualities(std::span<const PartFacePatch> faces,
                                               std::span<const DeviationSample> samples,
                                               const DeviationTolerance& tolerance, Progress& progress) {
    std::vector<FaceQuality> qualities;
    for (const PartFacePatch& patch : faces) {
        FaceQuality& face = qualities.emplace_back();
        face.number = qualities.size();
        face.kind = patch.kind;
        face.radius = patch.radius;
        face.area = patch.area;
        face.middle = middleOf(patch.mesh);
    }
    const JoinedFaces joined(faces);
    if (joined.mesh.empty()) return qualities;
    const std::vector<std::size_t> nearest = nearestTriangles(joined.mesh, samples, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "faces", {}, {}};
    for (std::size_t i = 0; i < samples.size(); ++i)
        add(qualities[joined.faceOf[nearest[i]]], samples[i], cornersOf(joined.mesh, nearest[i]), tolerance);
    for (FaceQuality& face : qualities)
        for (const DeviationBand band :
             {DeviationBand::gouge, DeviationBand::inTolerance, DeviationBand::excess, DeviationBand::unreachable})
            if (face.samples > 0) face.shares.of(band) /= static_cast<double>(face.samples);
    return qualities;
}

void sortByQuality(std::vector<FaceQuality>& faces) {
    std::ranges::stable_sort(faces, {}, [](const FaceQuality& face) {
        return std::tuple(face.samples == 0, -face.gouge.amount, -face.excess.amount, face.shares.inTolerance);
    });
}

const WorstPoint& worstPointOf(const FaceQuality& face) noexcept {
    return face.gouge.amount > 0.0 ? face.gouge : face.excess.amount > 0.0 ? face.excess : face.middle;
}

std::string faceTable(std::span<const FaceQuality> faces, char separator) {
    std::string table = "face,kind,diameter_mm,area_mm2,samples,gouge_max_mm,gouge_x_mm,gouge_y_mm,gouge_z_mm,"
                        "excess_max_mm,excess_x_mm,excess_y_mm,excess_z_mm,in_tolerance,gouge,excess,unreachable\n";
    std::ranges::replace(table, ',', separator);
    for (const FaceQuality& face : faces) {
        const bool known = face.samples > 0;
        table += std::to_string(face.number) + separator + idOf(face.kind) + separator +
                 (face.radius > 0.0 ? formatFixed(2.0 * face.radius, 4) : std::string()) + separator +
                 formatFixed(face.area, 3) + separator + std::to_string(face.samples) + separator +
                 fieldsOf(face.gouge, known, separator) + separator + fieldsOf(face.excess, known, separator);
        for (const double share :
             {face.shares.inTolerance, face.shares.gouge, face.shares.excess, face.shares.unreachable})
            table += separator + (known ? formatFixed(share, 4) : std::string());
        table += '\n';
    }
    return table;
}

} // namespace burin
