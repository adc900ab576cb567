// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include <utility>
#include <vector>

namespace burin {

/// Writes one HTML page that needs no other file and prints on A4. All text arguments are escaped.
class SheetPage {
public:
    explicit SheetPage(const QString& title);
    void section(const QString& title);
    /// The left column names the values in the right one.
    void facts(const std::vector<std::pair<QString, QString>>& rows);
    void table(const QStringList& heads, const std::vector<QStringList>& rows);
    void sentence(const QString& text, bool warns = false);
    /// @param png bytes of a PNG file
    void picture(const QByteArray& png, const QString& caption);
    /// Pictures that are HTML already, side by side.
    void marks(const QStringList& html);
    QString html() const; ///< the complete page

private:
    QString title_, body_;
};

} // namespace burin
