// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QString>

#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;

namespace burin {

class HelpBrowser;

/// A page of the help: Markdown, its first line the title.
struct HelpPage {
    QString topic; ///< the file's name without its suffix: "path"
    QString title, text;
    QString folder; ///< of the file, which the paths of the page's pictures are relative to
};

/// The pages in a language, in their order (resources/help); pages that do not exist in that language are English.
/// @param language "de", "de_AT", "zh_CN"
std::vector<HelpPage> helpPages(const QString& language);

/// The help, in a separate window: topics on the left, a page on the right. Typed text is searched in all pages.
class HelpDialog final : public QDialog {
    Q_OBJECT
public:
    explicit HelpDialog(std::vector<HelpPage> pages, QWidget* parent = nullptr);
    void showTopic(const QString& topic); ///< does nothing if there is no such topic

private:
    void showOnly(const QString& text);
    void showPage(int row);
    void mark(const QString& text);

    std::vector<HelpPage> pages_;
    QLineEdit* search_ = nullptr;
    QListWidget* topics_ = nullptr;
    HelpBrowser* page_ = nullptr;
    QLabel* nothing_ = nullptr;
};

} // namespace burin
