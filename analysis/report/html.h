// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// A table as pages and Markdown show it: every row has as many cells as there are headings.
struct Table {
    std::vector<std::string> headings;
    std::vector<std::vector<std::string>> rows;
};

/// A page that is written once and given out as one self-contained HTML file or as Markdown: no
/// script, nothing fetched, readable without colour.
class Page {
  public:
    explicit Page(std::string title);

    void heading(std::string_view text, int level = 2);
    void paragraph(std::string_view text);  ///< plain text; it is escaped
    void list(const std::vector<std::string>& items);
    void table(const Table& table, std::string_view caption = "");
    /// A drawing: inline in HTML, `![caption](file)` in Markdown.
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
    std::string html_;
    std::string markdown_;
};

/// Text with & < > " made safe for HTML.
[[nodiscard]] std::string html_escaped(std::string_view text);

}  // namespace obscura::analysis
