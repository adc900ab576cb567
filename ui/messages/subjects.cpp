// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/messages/subjects.h"

#include "core/base/text.h"

#include <QCoreApplication>
#include <array>

namespace burin {

namespace {

/// The values of `Error::subject` in core that are no file names, as in its sources.
constexpr std::array subjects{
    // what a project may lack
    BURIN_TEXT("Subject", "model"),
    BURIN_TEXT("Subject", "embedded stock"),
    BURIN_TEXT("Subject", "recording"),
    BURIN_TEXT("Subject", "checked program"),
    BURIN_TEXT("Subject", "generated moves"),
    BURIN_TEXT("Subject", "face"),
    BURIN_TEXT("Subject", "pass"),
    BURIN_TEXT("Subject", "a recording"),
    BURIN_TEXT("Subject", "a tool"),
    // kinds of named things
    BURIN_TEXT("Subject", "benchmark"),
    BURIN_TEXT("Subject", "body"),
    BURIN_TEXT("Subject", "command"),
    BURIN_TEXT("Subject", "device"),
    BURIN_TEXT("Subject", "dialect"),
    BURIN_TEXT("Subject", "edit"),
    BURIN_TEXT("Subject", "file"),
    BURIN_TEXT("Subject", "change of a fixture"),
    BURIN_TEXT("Subject", "kind of fixture"),
    BURIN_TEXT("Subject", "size of a fixture"),
    BURIN_TEXT("Subject", "insert"),
    BURIN_TEXT("Subject", "layer"),
    BURIN_TEXT("Subject", "library"),
    BURIN_TEXT("Subject", "machine"),
    BURIN_TEXT("Subject", "material"),
    BURIN_TEXT("Subject", "obstacle"),
    BURIN_TEXT("Subject", "path"),
    BURIN_TEXT("Subject", "preset"),
    BURIN_TEXT("Subject", "program"),
    BURIN_TEXT("Subject", "reference"),
    BURIN_TEXT("Subject", "setup"),
    BURIN_TEXT("Subject", "stylus"),
    BURIN_TEXT("Subject", "take"),
    BURIN_TEXT("Subject", "thread"),
    BURIN_TEXT("Subject", "tool"),
    // work that takes time or memory
    BURIN_TEXT("Subject", "boundary field of a tool"),
    BURIN_TEXT("Subject", "exact distances"),
    BURIN_TEXT("Subject", "milling"),
    BURIN_TEXT("Subject", "replaying takes"),
    BURIN_TEXT("Subject", "scoring a take"),
    BURIN_TEXT("Subject", "verification"),
    BURIN_TEXT("Subject", "volume"),
    BURIN_TEXT("Subject", "voxelisation"),
    // limits of a machine
    BURIN_TEXT("Subject", "feed"),
    BURIN_TEXT("Subject", "plunge feed"),
    BURIN_TEXT("Subject", "maximum feed"),
    BURIN_TEXT("Subject", "spindle speed"),
    BURIN_TEXT("Subject", "maximum spindle speed"),
    BURIN_TEXT("Subject", "X travel"),
    BURIN_TEXT("Subject", "Y travel"),
    BURIN_TEXT("Subject", "Z travel"),
    BURIN_TEXT("Subject", "tilt of the tool axis"),
    BURIN_TEXT("Subject", "dwell"),
    BURIN_TEXT("Subject", "arc"),
    // not supported by this version
    BURIN_TEXT("Subject", "the virtual operator with this kind of tool"),
    BURIN_TEXT("Subject", "this pass with this kind of tool"),
    BURIN_TEXT("Subject", "tilted tool axis"),
    BURIN_TEXT("Subject", "tool axis"),
    BURIN_TEXT("Subject", "a tilted tool on %1"),
    BURIN_TEXT("Subject", "a restart of a program that tilts the tool"),
    BURIN_TEXT("Subject", "a computed pass with a tool that doesn't turn"),
    BURIN_TEXT("Subject", "the virtual operator with a tool that doesn't turn"),
    BURIN_TEXT("Subject", "a program for a tool that doesn't turn"),
    BURIN_TEXT("Subject", "a path of a program for a tool that doesn't turn"),
    BURIN_TEXT("Subject", "a tilted axis of a tool that doesn't turn"),
    BURIN_TEXT("Subject", "a tilted axis of a tool with a hollow tip"),
    BURIN_TEXT("Subject", "axes other than X, Y and Z"),
    BURIN_TEXT("Subject", "a program with a tool change"),
    BURIN_TEXT("Subject", "a restart of a program that sets its own zero"),
    BURIN_TEXT("Subject", "a restart over a change of the path mode (G61, G64)"),
    BURIN_TEXT("Subject", "a restart over a change of the work offset"),
    // user input
    BURIN_TEXT("Subject", "restart line"),
    BURIN_TEXT("Subject", "interrupted program"),
    BURIN_TEXT("Subject", "MODEL"),
    BURIN_TEXT("Subject", "FORCES"),
    BURIN_TEXT("Subject", "trace"),
    BURIN_TEXT("Subject", "paths"),
    BURIN_TEXT("Subject", "tool number"),
    // properties of a setup
    BURIN_TEXT("Subject", "voxel"),
    BURIN_TEXT("Subject", "margin"),
    BURIN_TEXT("Subject", "part"),
    BURIN_TEXT("Subject", "faces"),
    BURIN_TEXT("Subject", "test force"),
    BURIN_TEXT("Subject", "test strength"),
    BURIN_TEXT("Subject", "gain of axis"),
    BURIN_TEXT("Subject", "dead zone of axis"),
    BURIN_TEXT("Subject", "rest of axis"),
    BURIN_TEXT("Subject", "buttons"),
    BURIN_TEXT("Subject", "stock"),
};

} // namespace

QString subjectText(const std::string& subject) {
    for (const TextId& known : subjects)
        if (subject == known.text) return QCoreApplication::translate(known.context, known.text);
    return QString::fromStdString(subject);
}

QString deviceReasonText(const std::string& reason) {
    return QCoreApplication::translate("DeviceReason", reason.c_str());
}

QString ownerText(const std::string& owner) {
    const QString text = QString::fromStdString(owner);
    const QString start = QStringLiteral("process ");
    if (!text.startsWith(start)) return QCoreApplication::translate("Subject", "another process");
    return QCoreApplication::translate("Subject", "process %1").arg(text.mid(start.size()));
}

} // namespace burin
