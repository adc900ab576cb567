// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/measure_labels.h"

#include "core/base/units.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QStringList>

namespace burin {

namespace {

using Kind = MeasuredFace::Kind;

struct MeasureLabels {
    Q_DECLARE_TR_FUNCTIONS(MeasureLabels)
};

QString angleText(double radians) {
    return fixedNumber(radians * 180.0 / pi, 3) + QStringLiteral("°");
}

QString positionText(const glm::dvec3& place, LengthUnit unit) {
    return MeasureLabels::tr("X %1, Y %2, Z %3")
        .arg(lengthText(place.x, unit), lengthText(place.y, unit), lengthText(place.z, unit));
}

QString shapeText(const MeasuredFace& face, LengthUnit unit) {
    switch (face.kind) {
    case Kind::plane:
        return MeasureLabels::tr("Plane.");
    case Kind::cylinder:
        return MeasureLabels::tr("Cylinder, Ø %1.").arg(lengthText(2.0 * face.radius, unit));
    case Kind::cone:
        return MeasureLabels::tr("Cone, Ø %1 there, half angle %2.")
            .arg(lengthText(2.0 * face.radius, unit), angleText(face.taper));
    case Kind::sphere:
        return MeasureLabels::tr("Sphere, radius %1.").arg(lengthText(face.radius, unit));
    case Kind::torus:
        return MeasureLabels::tr("Torus, radius of the tube %1.").arg(lengthText(face.radius, unit));
    case Kind::other:
        break;
    }
    return MeasureLabels::tr("Free-form face.");
}

QStringList faceSentences(const MeasuredFace& face, const glm::dvec3& zero, LengthUnit unit) {
    QStringList sentences{shapeText(face, unit)};
    sentences << MeasureLabels::tr("Position %1.").arg(positionText(face.place - zero, unit));
    if (face.thickness) sentences << MeasureLabels::tr("Wall thickness %1.").arg(lengthText(*face.thickness, unit));
    if (face.area > 0.0) sentences << MeasureLabels::tr("Face area %1.").arg(areaText(face.area, unit));
    return sentences;
}

/// A length with the bound of its deviation: "9.968 ± 0.500 mm".
QString boundedText(double value, double within, LengthUnit unit) {
    return QStringLiteral("%1 ± %2").arg(lengthNumber(value, unit), lengthText(within, unit));
}

QString boundedAngle(double radians, double within) {
    return QStringLiteral("%1 ± %2").arg(fixedNumber(radians * 180.0 / pi, 2), fixedNumber(within * 180.0 / pi, 2)) +
           QStringLiteral("°");
}

QString shapeText(const MeasuredWorkpiece& at, LengthUnit unit) {
    if (at.face.kind == Kind::cylinder)
        return MeasureLabels::tr("Cylinder, Ø %1.").arg(boundedText(2.0 * at.face.radius, 2.0 * at.radiusWithin, unit));
    if (at.face.kind == Kind::sphere)
        return MeasureLabels::tr("Sphere, radius %1.").arg(boundedText(at.face.radius, at.radiusWithin, unit));
    return shapeText(at.face, unit);
}

/// The stock that is left on the part at a point of the workpiece, or how deep it is cut.
QString excessSentence(double fromPart, double within, LengthUnit unit) {
    if (fromPart < -within)
        return MeasureLabels::tr("Cut into the part: %1.").arg(boundedText(-fromPart, within, unit));
    return MeasureLabels::tr("Stock left on the part: %1.").arg(boundedText(fromPart, within, unit));
}

QStringList pointSentences(const MeasuredWorkpiece& at, const glm::dvec3& zero, LengthUnit unit) {
    QStringList sentences{shapeText(at, unit)};
    sentences << MeasureLabels::tr("Position %1, within %2.")
                     .arg(positionText(at.face.place - zero, unit), lengthText(at.within, unit));
    sentences
        << MeasureLabels::tr("Depth below the top of the stock: %1.").arg(boundedText(at.depth, at.depthWithin, unit));
    if (at.face.thickness)
        sentences
            << MeasureLabels::tr("Wall thickness %1.").arg(boundedText(*at.face.thickness, at.thicknessWithin, unit));
    if (at.along)
        sentences << MeasureLabels::tr("Thickness along the line of sight: %1.")
                         .arg(boundedText(at.along->value, at.along->within, unit));
    if (at.opening)
        sentences << MeasureLabels::tr("Width to the opposite side: %1.")
                         .arg(boundedText(at.opening->value, at.opening->within, unit));
    if (at.fromPart) sentences << excessSentence(*at.fromPart, at.within, unit);
    return sentences;
}

} // namespace

QString kindText(MeasuredFace::Kind kind, double radius, LengthUnit unit) {
    switch (kind) {
    case Kind::plane:
        return MeasureLabels::tr("Plane");
    case Kind::cylinder:
        return MeasureLabels::tr("Cylinder, Ø %1").arg(lengthText(2.0 * radius, unit));
    case Kind::cone:
        return MeasureLabels::tr("Cone");
    case Kind::sphere:
        return MeasureLabels::tr("Sphere, Ø %1").arg(lengthText(2.0 * radius, unit));
    case Kind::torus:
        return MeasureLabels::tr("Torus, tube Ø %1").arg(lengthText(2.0 * radius, unit));
    case Kind::other:
        break;
    }
    return MeasureLabels::tr("Free-form face");
}

QString mainFigure(const PartMeasure& measure, LengthUnit unit) {
    if (measure.pair) {
        if (measure.pair->apart) return lengthText(*measure.pair->apart, unit);
        if (measure.pair->angle) return angleText(*measure.pair->angle);
        return lengthText(measure.pair->places, unit);
    }
    const MeasuredFace& face = measure.from;
    if (face.kind == Kind::cylinder || face.kind == Kind::cone)
        return QStringLiteral("Ø ") + lengthText(2.0 * face.radius, unit);
    if (face.kind == Kind::sphere || face.kind == Kind::torus)
        return QStringLiteral("R ") + lengthText(face.radius, unit);
    return face.thickness ? lengthText(*face.thickness, unit) : QString();
}

QString measureText(const PartMeasure& measure, const glm::dvec3& zero, LengthUnit unit) {
    if (!measure.pair || !measure.to) return faceSentences(measure.from, zero, unit).join(QLatin1Char(' '));
    const MeasuredPair& pair = *measure.pair;
    QStringList sentences;
    if (pair.apart)
        sentences << MeasureLabels::tr("Parallel, %1 apart.").arg(lengthText(*pair.apart, unit));
    else if (pair.angle)
        sentences << MeasureLabels::tr("Angle %1.").arg(angleText(*pair.angle));
    sentences << MeasureLabels::tr("Distance between the points: %1 (%2).")
                     .arg(lengthText(pair.places, unit), positionText(measure.to->place - measure.from.place, unit));
    if (pair.faces)
        sentences << MeasureLabels::tr("Smallest distance between the faces: %1.").arg(lengthText(*pair.faces, unit));
    if (pair.corners > 0.0) // otherwise it is the same corner
        sentences << MeasureLabels::tr("Distance between the nearest corners or circle centres: %1.")
                         .arg(lengthText(pair.corners, unit));
    return sentences.join(QLatin1Char(' '));
}

QString mainFigure(const WorkpieceMeasure& measure, LengthUnit unit) {
    if (measure.pair) {
        if (measure.pair->apart) return boundedText(*measure.pair->apart, measure.pairWithin, unit);
        if (measure.pair->angle) return boundedAngle(*measure.pair->angle, measure.angleWithin);
        return boundedText(measure.pair->places, measure.pairWithin, unit);
    }
    const MeasuredWorkpiece& from = measure.from;
    if (from.face.kind == Kind::cylinder)
        return QStringLiteral("Ø ") + boundedText(2.0 * from.face.radius, 2.0 * from.radiusWithin, unit);
    if (from.face.kind == Kind::sphere)
        return QStringLiteral("R ") + boundedText(from.face.radius, from.radiusWithin, unit);
    return from.face.thickness ? boundedText(*from.face.thickness, from.thicknessWithin, unit) : QString();
}

QString measureText(const WorkpieceMeasure& measure, const glm::dvec3& zero, LengthUnit unit) {
    if (!measure.pair || !measure.to) return pointSentences(measure.from, zero, unit).join(QLatin1Char(' '));
    const MeasuredPair& pair = *measure.pair;
    QStringList sentences;
    if (pair.apart)
        sentences << MeasureLabels::tr("Parallel, %1 apart.").arg(boundedText(*pair.apart, measure.pairWithin, unit));
    else if (pair.angle)
        sentences << MeasureLabels::tr("Angle %1.").arg(boundedAngle(*pair.angle, measure.angleWithin));
    const glm::dvec3 between = measure.to->face.place - measure.from.face.place;
    sentences << MeasureLabels::tr("Distance between the points: %1 (%2).")
                     .arg(boundedText(pair.places, measure.pairWithin, unit), positionText(between, unit));
    return sentences.join(QLatin1Char(' '));
}

} // namespace burin
