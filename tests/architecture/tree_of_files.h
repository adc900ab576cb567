// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>
#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace burin::architecture {

inline QStringList listed(const std::vector<std::string>& faults) {
    QStringList result;
    for (const std::string& fault : faults) result.append(QString::fromStdString(fault));
    return result;
}

/// All faults in one text, so that a failure shows each of them.
inline QString told(const std::vector<std::string>& faults) {
    return listed(faults).join(QLatin1Char('\n'));
}

/// Writes a file of a tree on which a rule is tested.
inline void place(const QTemporaryDir& tree, const QString& file, const QString& content) {
    const std::filesystem::path path = tree.filePath(file).toStdString();
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << content.toStdString();
}

} // namespace burin::architecture
