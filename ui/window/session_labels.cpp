// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/session_labels.h"

#include "ui/panels/texts.h"

#include <QCoreApplication>

#include <algorithm>

namespace burin {

namespace {

struct MillLabels {
    Q_DECLARE_TR_FUNCTIONS(MillLabels)
};

QString shankSentence(const SessionState& state, const MillingContext& milling) {
    const PropertyList& properties = milling.embedded.workpiece.properties();
    const bool shank = sectionOf(milling.tool.cutter, state.shankPiece) != ToolSection::holder;
    const QString what = state.shankTouches == airProperty || state.shankTouches >= properties.size()
                             ? MillLabels::tr("the workpiece")
                             : materialName(properties[state.shankTouches]);
    if (properties.isProtected(state.shankTouches))
        return shank ? MillLabels::tr("The shank touches the part.") : MillLabels::tr("The holder touches the part.");
    return (shank ? MillLabels::tr("The shank touches %1.") : MillLabels::tr("The holder touches %1.")).arg(what);
}

/// The first bound other than the part that holds the tool.
QString boundSentence(const SessionState& state, const ToolBounds& bounds) {
    if ((state.sample.flags & sampleOnObstacle) == 0) return {};
    if (state.stock && state.stock->holds) return MillLabels::tr("Shank or holder keep their distance from the stock.");
    for (std::size_t i = 1; i < std::min(state.layers.size(), bounds.layers().size()); ++i) {
        if (!state.layers[i].holds) continue;
        const BoundLayer& layer = bounds.layers()[i];
        if (layer.kind == BoundLayer::Kind::machineTravel) return MillLabels::tr("The machine's travel ends here.");
        if (layer.kind == BoundLayer::Kind::stock) return MillLabels::tr("The stock holds the tool.");
        return MillLabels::tr("“%1” holds the tool.").arg(QString::fromStdString(layer.name));
    }
    return {};
}

} // namespace

QString alarmSentence(const SessionState& state, const MillingContext& milling) {
    if ((state.sample.flags & sampleShankContact) != 0) return shankSentence(state, milling);
    if ((state.sample.flags & sampleMemoryFull) != 0)
        return MillLabels::tr("The memory for the workpiece is used up, so nothing is cut; save, and go on with larger "
                              "voxels.");
    return {};
}

QString hintSentence(const SessionState& state, const ToolBounds& bounds, const StylusDescription* stylus,
                     int forceButton) {
    const std::uint32_t flags = state.sample.flags;
    if (const QString holding = boundSentence(state, bounds); !holding.isEmpty()) return holding;
    if (stylus == nullptr) return {};
    if ((flags & sampleStylusInvalid) != 0)
        return MillLabels::tr("The stylus gives no readings: the tool does not move, and there is no force.");
    if ((flags & sampleAxisHeld) != 0)
        return MillLabels::tr("There is no room to tilt the tool like the hand: its axis does not follow.");
    if (!stylus->hasMotors()) return {};
    const bool held = forceButton == 0 || (state.sample.buttons >> static_cast<unsigned>(forceButton - 1) & 1U) != 0;
    if (!held) return MillLabels::tr("There is force while button %1 is held.").arg(forceButton);
    if ((flags & sampleForcesOff) != 0) return MillLabels::tr("Forces fade in, once the tool is clear of the part.");
    if ((flags & sampleMotorsHot) != 0)
        return MillLabels::tr("The motors are hot: forces go down until they have cooled.");
    if ((flags & sampleForceSaturated) != 0) return MillLabels::tr("The force is at the device's limit.");
    return {};
}

} // namespace burin
