// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/embedding_labels.h"

#include "ui/panels/model_labels.h"
#include "ui/panels/quantity.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QStringList>

namespace burin {

namespace {

class EmbeddingLabels {
    Q_DECLARE_TR_FUNCTIONS(EmbeddingLabels)
};

/// Number and location of a finding: "scanlines: 64, X 0.000 to 10.000 mm, …"
QString whereText(const EmbeddingFinding& finding, LengthUnit unit) {
    QStringList parts{EmbeddingLabels::tr("scanlines: %1").arg(countText(finding.count))};
    for (int axis = 0; axis < 3 && !finding.place.empty(); ++axis)
        parts.append(EmbeddingLabels::tr("%1\u00a0%2 to %3", "X 0.000 to 10.000 mm")
                         .arg(QChar(u'X' + axis))
                         .arg(quantityNumber(finding.place.low[axis], Quantity::length, unit),
                              quantityText(finding.place.high[axis], Quantity::length, unit)));
    return parts.join(QStringLiteral("; "));
}

} // namespace

// No default case: the compiler then reports every kind without a sentence.
QString embeddingText(const EmbeddingFinding& finding, LengthUnit unit) {
    using Kind = EmbeddingFinding::Kind;
    const QString body = bodyName(finding.body);
    switch (finding.kind) {
    case Kind::openSurface:
        return EmbeddingLabels::tr(
                   "The surface of “%1” is open (edges: %2, rims: %3), so its inside is uncertain there "
                   "(%4); close it in the CAD program.")
            .arg(body, countText(finding.openEdges), countText(finding.rims), whereText(finding, unit));
    case Kind::unseenOpening:
        return EmbeddingLabels::tr("The surface of “%1” is open (edges: %2), but no scanline meets a gap.")
            .arg(body, countText(finding.openEdges));
    case Kind::turnedFaces:
        return EmbeddingLabels::tr("Faces of “%1” do not agree on which side is outside, so every second interval "
                                   "between them was filled (%2); make their normals agree in the CAD program.")
            .arg(body, whereText(finding, unit));
    case Kind::insideOut:
        return EmbeddingLabels::
            tr("A shell of “%1” is inside out and was filled as well (%2); a cavity has to lie within another shell.")
                .arg(body, whereText(finding, unit));
    case Kind::overlappingShells:
        return EmbeddingLabels::tr("Shells of “%1” overlap, so everything inside any of them was filled (%2).")
            .arg(body, whereText(finding, unit));
    case Kind::duplicateTriangles:
        return EmbeddingLabels::tr("Duplicate triangles of “%1” were counted once (%2).")
            .arg(body, countText(finding.count));
    case Kind::tooSmall:
        return EmbeddingLabels::tr("“%1” is too small for the voxels, so nothing of it is protected; choose smaller "
                                   "voxels.")
            .arg(body);
    case Kind::overlappingBodies:
        return EmbeddingLabels::tr("“%1” overlaps “%2” in %3; there the later body counts.")
            .arg(body, bodyName(finding.otherBody), volumeText(finding.volume, unit));
    }
    return {};
}

} // namespace burin
