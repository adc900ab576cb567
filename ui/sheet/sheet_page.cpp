// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/sheet_page.h"

#include <QByteArray>

namespace burin {

namespace {

// Dark on white, for printing; a table or picture is not split between two pages.
constexpr const char* style = R"css(
body { font: 11pt/1.4 sans-serif; color: #1a1d21; max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; margin: 0 0 0.2rem; } h2 { font-size: 1.1rem; margin: 1.6rem 0 0.5rem; border-bottom: 1px solid #bbb; }
table { border-collapse: collapse; width: 100%; break-inside: avoid; }
th, td { text-align: left; vertical-align: top; padding: 0.2rem 0.9rem 0.2rem 0; border-bottom: 1px solid #e2e2e2; }
table.facts th { width: 13rem; font-weight: normal; color: #555; } thead th { font-weight: 600; }
figure { display: inline-block; margin: 0 0.7rem 0.7rem 0; break-inside: avoid; } figure img { width: 28rem; max-width: 100%; border: 1px solid #ccc; }
figcaption { font-size: 0.85rem; color: #555; } p.warns { font-weight: 600; border-left: 4px solid #b3261e; padding-left: 0.6rem; }
div.tool { display: inline-block; margin: 0 1.2rem 0.8rem 0; vertical-align: bottom; break-inside: avoid; font-size: 0.9rem; }
svg.tool .flutes { fill: #c9a227; } svg.tool .shank { fill: #b9c0c7; } svg.tool .holder { fill: #6b747d; }
svg.tool polygon { stroke: #333; stroke-width: 0.7; } svg.tool .measure { fill: none; stroke: #777; stroke-width: 0.7; }
svg.tool text { font: 11px sans-serif; }
@media print { body { margin: 0; max-width: none; } figure img { width: 8.4cm; } }
)css";

} // namespace

SheetPage::SheetPage(const QString& title) : title_(title.toHtmlEscaped()) {
    body_ = QStringLiteral("<h1>%1</h1>\n").arg(title_);
}

void SheetPage::section(const QString& title) {
    body_ += QStringLiteral("<h2>%1</h2>\n").arg(title.toHtmlEscaped());
}

void SheetPage::facts(const std::vector<std::pair<QString, QString>>& rows) {
    body_ += QStringLiteral("<table class=\"facts\">\n");
    for (const auto& [name, value] : rows)
        body_ += QStringLiteral("<tr><th>%1</th><td>%2</td></tr>\n").arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    body_ += QStringLiteral("</table>\n");
}

void SheetPage::table(const QStringList& heads, const std::vector<QStringList>& rows) {
    body_ += QStringLiteral("<table>\n<thead><tr>");
    for (const QString& head : heads) body_ += QStringLiteral("<th>%1</th>").arg(head.toHtmlEscaped());
    body_ += QStringLiteral("</tr></thead>\n");
    for (const QStringList& row : rows) {
        body_ += QStringLiteral("<tr>");
        for (const QString& cell : row) body_ += QStringLiteral("<td>%1</td>").arg(cell.toHtmlEscaped());
        body_ += QStringLiteral("</tr>\n");
    }
    body_ += QStringLiteral("</table>\n");
}

void SheetPage::sentence(const QString& text, bool warns) {
    body_ += QStringLiteral("<p%1>%2</p>\n")
                 .arg(warns ? QStringLiteral(" class=\"warns\"") : QString(), text.toHtmlEscaped());
}

void SheetPage::picture(const QByteArray& png, const QString& caption) {
    body_ += QStringLiteral("<figure><img alt=\"%1\" src=\"data:image/png;base64,%2\"><figcaption>%1</figcaption>"
                            "</figure>\n")
                 .arg(caption.toHtmlEscaped(), QString::fromLatin1(png.toBase64()));
}

void SheetPage::marks(const QStringList& html) {
    for (const QString& mark : html) body_ += QStringLiteral("<div class=\"tool\">%1</div>\n").arg(mark);
}

QString SheetPage::html() const {
    return QStringLiteral("<!DOCTYPE html>\n<html>\n<head>\n<meta charset=\"utf-8\">\n<title>") + title_ +
           QStringLiteral("</title>\n<style>") + QString::fromLatin1(style) +
           QStringLiteral("</style>\n</head>\n<body>\n") + body_ + QStringLiteral("</body>\n</html>\n");
}

} // namespace burin
