// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/html.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>

#include "analysis/presentation/html_table.h"
#include "analysis/text/embedded.h"
#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');  // with the zero that is written last
    text.resize(static_cast<std::size_t>(EVP_EncodeBlock(
        reinterpret_cast<unsigned char*>(text.data()),
        reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()))));
    return text;
}

void replace_all(std::string& text, std::string_view what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + with.size())) {
        text.replace(at, what.size(), with);
    }
}

/// The drawing without what only a file of its own may have, and with names that no other drawing
/// of the page uses.
std::string inline_svg(std::string_view file, int number) {
    const std::size_t begin = file.find("<svg");
    std::string svg(begin == std::string_view::npos ? file : file.substr(begin));
    const std::string prefix = fmt::format("d{}-", number);
    for (const char quote : {'\'', '"'}) {
        for (const std::string_view stem : {"gp", "gnuplot_", "textbox", "greybox"}) {
            replace_all(svg, fmt::format("id={}{}", quote, stem),
                        fmt::format("id={}{}{}", quote, prefix, stem));
            replace_all(svg, fmt::format("href={}#{}", quote, stem),
                        fmt::format("href={}#{}{}", quote, prefix, stem));
        }
    }
    for (const std::string_view stem : {"gp", "textbox", "greybox"}) {
        replace_all(svg, fmt::format("url(#{}", stem), fmt::format("url(#{}{}", prefix, stem));
    }
    replace_all(svg, "<svg ", "<svg role=\"img\" ");
    return svg;
}

std::string image_element(std::string_view bytes, std::string_view media_type,
                          std::string_view text) {
    return fmt::format("<img src=\"data:{};base64,{}\" alt=\"{}\">", media_type, base64(bytes),
                       html_escaped(text));
}

std::string caption_element(std::string_view caption) {
    if (caption.empty()) return "";
    return fmt::format("<figcaption>{}</figcaption>", html_escaped(caption));
}

}  // namespace

Page::Page(std::string title) : title_(std::move(title)) {}

void Page::mark(std::string_view text) { mark_ = text; }

void Page::heading(std::string_view text, int level) {
    level = std::clamp(level, 2, 4);
    if (level == 2) {
        contents_.emplace_back(text);
        html_ += fmt::format("<h2 id=\"part-{}\">{}</h2>\n", contents_.size(), html_escaped(text));
    } else {
        html_ += fmt::format("<h{0}>{1}</h{0}>\n", level, html_escaped(text));
    }
    markdown_ += fmt::format("{} {}\n\n", std::string(static_cast<std::size_t>(level), '#'),
                             markdown_escaped(text));
}

void Page::paragraph(std::string_view text) {
    html_ += fmt::format("<p>{}</p>\n", html_escaped(text));
    markdown_ += markdown_escaped(text) + "\n\n";
}

void Page::list(const std::vector<std::string>& items) {
    if (items.empty()) return;
    html_ += "<ul>\n";
    for (const std::string& item : items) {
        html_ += fmt::format("<li>{}</li>\n", html_escaped(item));
        markdown_ += "- " + markdown_escaped(item) + '\n';
    }
    html_ += "</ul>\n";
    markdown_ += '\n';
}

void Page::fine_print(std::string_view text) {
    html_ += fmt::format("<p class=\"fine\">{}</p>\n", html_escaped(text));
    markdown_ += markdown_escaped(text) + "\n\n";
}

void Page::notice(std::string_view text) {
    html_ += fmt::format("<p class=\"notice\" role=\"note\">{}</p>\n", html_escaped(text));
    markdown_ += fmt::format("> **{}**\n\n", markdown_escaped(text));
}

void Page::box(std::string_view title, const std::vector<std::string>& items) {
    html_ += "<aside class=\"box\">\n";
    heading(title, 3);
    list(items);
    html_ += "</aside>\n";
}

void Page::answer(std::string_view question, std::string_view verdict, std::string_view sentence) {
    html_ += fmt::format(
        "<section class=\"answer\"><p class=\"question\">{}</p><p class=\"verdict\">{}</p>"
        "<p>{}</p></section>\n",
        html_escaped(question), html_escaped(verdict), html_escaped(sentence));
    markdown_ += fmt::format("**{}** **{}.** {}\n\n", markdown_escaped(question),
                             markdown_escaped(verdict), markdown_escaped(sentence));
}

void Page::table(const PageTable& table, std::string_view caption) {
    html_ += html_table(table, caption);
    markdown_ += markdown_table(table, caption);
}

void Page::svg(std::string_view svg_text, std::string_view file, std::string_view caption) {
    if (svg_text.empty()) {
        paragraph(caption);
        return;
    }
    html_ += fmt::format("<figure><div class=\"plot\">{}</div>{}</figure>\n",
                         inline_svg(svg_text, ++drawings_), caption_element(caption));
    markdown_ += fmt::format("![{}]({})\n\n", markdown_escaped(caption), file);
}

void Page::image(std::string_view bytes, std::string_view media_type, std::string_view file,
                 std::string_view caption) {
    html_ += fmt::format("<figure>{}{}</figure>\n", image_element(bytes, media_type, caption),
                         caption_element(caption));
    markdown_ += fmt::format("![{}]({})\n\n", markdown_escaped(caption), file);
}

void Page::pair(const std::string (&bytes)[2], std::string_view media_type,
                const std::string (&files)[2], const std::string (&captions)[2]) {
    html_ += "<div class=\"pair\">\n";
    for (int side = 0; side < 2; ++side) {
        html_ += fmt::format("<figure>{}{}</figure>\n",
                             image_element(bytes[side], media_type, captions[side]),
                             caption_element(captions[side]));
    }
    html_ += "</div>\n";
    markdown_ += fmt::format("| {} | {} |\n| --- | --- |\n| ![{}]({}) | ![{}]({}) |\n\n",
                             markdown_escaped(captions[0]), markdown_escaped(captions[1]),
                             markdown_escaped(captions[0]), files[0], markdown_escaped(captions[1]),
                             files[1]);
}

std::string Page::html() const {
    std::string contents;
    for (std::size_t i = 0; i < contents_.size(); ++i) {
        contents += fmt::format("<li><a href=\"#part-{}\">{}</a></li>\n", i + 1,
                                html_escaped(contents_[i]));
    }
    if (!contents.empty()) {
        contents = "<nav aria-label=\"Contents\"><ol>\n" + contents + "</ol></nav>\n";
    }
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n{4}<main>\n<h1>{0}</h1>\n"
        "{2}{3}</main>\n</body>\n</html>\n",
        html_escaped(title_), embedded("presentation/page.css"), contents, html_,
        mark_.empty() ? "" : fmt::format("<p class=\"mark\">{}</p>\n", html_escaped(mark_)));
}

std::string Page::markdown() const {
    const std::string mark =
        mark_.empty() ? "" : fmt::format("> **{}**\n\n", markdown_escaped(mark_));
    return "# " + markdown_escaped(title_) + "\n\n" + mark + markdown_;
}

}  // namespace obscura::analysis
