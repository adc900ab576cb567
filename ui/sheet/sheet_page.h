// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

namespace burin {

/// Writes one HTML page that needs no other file and prints on A4. Every text that it is given is escaped.
class SheetPage {
public:
    explicit SheetPage(const QString& title);
    void section(const QString& title);
    /// What stands on the left names what stands on the right.
    void facts(const std::vector<std::pair<QString, QString>>& rows);
    void table(const QStringList& heads, const std::vector<QStringList>& rows);
    void sentence(const QString& text, bool warns = false);
    /// @param png bytes of a PNG file
    void picture(const QByteArray& png, const QString& caption);
    /// Marks that are HTML already, beside each other.
    void marks(const QStringList& html);
    QString html() const; ///< all of it

private:
    QString title_, body_;
};

} // namespace burin
