// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// A table as pages and Markdown show it: every row has as many cells as there are headings.
/// Columns that hold only numbers are set to the right with their decimal points below each other.
struct PageTable {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
};

/// A page that is written once and given out as one self-contained HTML file or as Markdown: no
/// script, nothing fetched, readable without colour. All text is plain text; it is escaped.
class Page {
  public:
    explicit Page(std::string title);

    /// What stays in view on every screen and printed page, such as that data are simulated.
    void mark(std::string_view text);
    /// Level 2 to 4. Those of level 2 are listed at the top of the page with links.
    void heading(std::string_view text, int level = 2);
    void paragraph(std::string_view text);
    void list(const std::vector<std::string>& items);
    /// What only some readers want to know, in small type.
    void fine_print(std::string_view text);
    /// What must not be overlooked, framed.
    void notice(std::string_view text);
    /// Points that belong together and are read before the rest, framed, with a heading of level 3.
    void box(std::string_view title, const std::vector<std::string>& items);
    /// An answer that stands out: the question, the verdict in a few words, and a sentence.
    void answer(std::string_view question, std::string_view verdict, std::string_view sentence);
    void table(const PageTable& table, std::string_view caption = "");
    /// A drawing: inline in HTML, `![caption](file)` in Markdown. Where `svg_text` is empty, the
    /// caption alone, so that it can say why.
    void svg(std::string_view svg_text, std::string_view file, std::string_view caption);
    /// An image file's bytes: inline in HTML (base64), `![caption](file)` in Markdown.
    void image(std::string_view bytes, std::string_view media_type, std::string_view file,
               std::string_view caption);
    /// Two images side by side, such as a pair.
    void pair(const std::string (&bytes)[2], std::string_view media_type,
              const std::string (&files)[2], const std::string (&captions)[2]);

    [[nodiscard]] std::string html() const;
    [[nodiscard]] std::string markdown() const;

  private:
    std::string title_;
    std::string mark_;
    std::vector<std::string> contents_;  ///< headings of level 2
    std::string html_;
    std::string markdown_;
    int drawings_ = 0;
};

}  // namespace obscura::analysis
