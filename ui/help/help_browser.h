// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QTextBrowser>

namespace burin {

/// Shows a page of Markdown with its pictures, which are found relative to the page's file and reduced to the width of
/// the page where they are wider.
class HelpBrowser final : public QTextBrowser {
    Q_OBJECT
public:
    explicit HelpBrowser(QWidget* parent = nullptr);
    /// @param folder  of the page's file
    void showPage(const QString& markdown, const QString& folder);

    QVariant loadResource(int type, const QUrl& name) override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QImage fitted(const QUrl& name) const;
    QString folder_;
    QList<QUrl> pictures_; ///< shown so far; the document keeps them for pages that are shown again
};

} // namespace burin
