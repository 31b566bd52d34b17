// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/html.h"

#include <gmock/gmock.h>

#include "analysis/presentation/html_table.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Page, EscapesEverythingThatIsTextInBothForms) {
    Page page("<b>title & \"more\"</b>");
    page.heading("a < b");
    page.paragraph("<script>alert(1)</script> *not bold* a|b");
    page.list({"<li>"});
    page.notice("5 > 4 & so on");
    page.answer("H1: <i>?", "a_b_c", "x < y");
    page.table({{"h<1>"}, {{"c&1|2"}}}, "cap<tion>");
    const std::string html = page.html();
    EXPECT_THAT(html, AllOf(HasSubstr("<title>&lt;b&gt;title &amp; &quot;more&quot;&lt;/b&gt;"),
                            HasSubstr("a &lt; b"), HasSubstr("&lt;script&gt;alert(1)"),
                            HasSubstr("&lt;li&gt;"), HasSubstr("5 &gt; 4 &amp; so on"),
                            HasSubstr("H1: &lt;i&gt;?"), HasSubstr("h&lt;1&gt;"),
                            HasSubstr("c&amp;1|2"), HasSubstr("cap&lt;tion&gt;")));
    EXPECT_THAT(html, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<b>"))));
    EXPECT_THAT(page.markdown(), AllOf(HasSubstr("\\<script\\>"), HasSubstr("\\*not bold\\* a\\|b"),
                                       HasSubstr("a\\_b\\_c"), HasSubstr("c&1\\|2")));
}

TEST(Page, IsSelfContained) {
    Page page("title");
    page.svg("<?xml version=\"1.0\"?>\n<svg width=\"9\"></svg>\n", "plots/a.svg", "a plot");
    page.image(std::string("\x89PNG\0x", 6), "image/png", "thumbs/a.png", "an image");
    const std::string html = page.html();
    EXPECT_THAT(html,
                AllOf(HasSubstr("data:image/png;base64,iVBORwB4"), Not(HasSubstr("src=\"thumbs")),
                      Not(HasSubstr("<script")), Not(HasSubstr("@import")), Not(HasSubstr("<link")),
                      Not(HasSubstr("<?xml"))));
    EXPECT_THAT(page.markdown(),
                AllOf(HasSubstr("![a plot](plots/a.svg)"), HasSubstr("![an image](thumbs/a.png)")));
}

TEST(Page, WritesBytesAsBase64WithItsPadding) {
    // RFC 4648, section 10.
    for (const auto& [bytes, text] : {std::pair<std::string, std::string>{"f", "Zg=="},
                                      {"fo", "Zm8="},
                                      {"foo", "Zm9v"},
                                      {"foob", "Zm9vYg=="},
                                      {"foobar", "Zm9vYmFy"}}) {
        Page page("t");
        page.image(bytes, "image/png", "f", "c");
        EXPECT_THAT(page.html(), HasSubstr("base64," + text + "\""));
    }
}

TEST(Page, GivesTheDrawingsOfAPageNamesOfTheirOwn) {
    const std::string svg =
        "<svg width=\"9\"><path id='gpPt1'/><use xlink:href='#gpPt1'/><g id=\"gnuplot_plot_1\" "
        "filter=\"url(#textbox)\"/></svg>";
    Page page("t");
    page.svg(svg, "a.svg", "a");
    page.svg(svg, "b.svg", "b");
    EXPECT_THAT(page.html(), AllOf(HasSubstr("id='d1-gpPt1'"), HasSubstr("href='#d1-gpPt1'"),
                                   HasSubstr("id='d2-gpPt1'"), HasSubstr("href='#d2-gpPt1'"),
                                   HasSubstr("id=\"d2-gnuplot_plot_1\""),
                                   HasSubstr("url(#d2-textbox)"), Not(HasSubstr("id='gpPt1'"))));
}

TEST(Page, SaysInWordsWhyADrawingIsMissing) {
    Page page("t");
    page.svg("", "a.svg", "No picture: gnuplot is not in the PATH.");
    EXPECT_THAT(page.html(), HasSubstr("<p>No picture: gnuplot is not in the PATH.</p>"));
    EXPECT_THAT(page.markdown(), Not(HasSubstr("a.svg")));
}

TEST(Page, ListsItsPartsAtTheTop) {
    Page page("t");
    page.heading("First");
    page.heading("Within", 3);
    page.heading("Second");
    EXPECT_THAT(page.html(),
                AllOf(HasSubstr("<a href=\"#part-2\">Second</a>"),
                      HasSubstr("<h2 id=\"part-2\">Second</h2>"), Not(HasSubstr(">Within</a>"))));
}

TEST(Tables, BringDecimalPointsBelowEachOtherWithoutChangingTheText) {
    const std::string html = html_table(
        {{"name", "p", "votes", "word"}, {{"I", "1", "18 : 18", "a"}, {"II", "0.025", "–", "b"}}},
        "");
    EXPECT_THAT(html, AllOf(HasSubstr("<td class=\"n\">1<span class=\"pad\" data-pad=\".000\">"),
                            HasSubstr("<td class=\"n\">0.025</td>"), HasSubstr("<td>a</td>"),
                            HasSubstr("<th scope=\"row\">I</th>"),
                            HasSubstr("<td class=\"n\">18 : 18</td>")));
    EXPECT_THAT(markdown_table({{"name", "p"}, {{"I", "1"}}}, ""), HasSubstr("| --- | ---: |"));
}

TEST(Tables, WithoutRowsAreStillTables) {
    EXPECT_THAT(html_table({{"a", "b"}, {}}, ""), HasSubstr("<tbody>\n</tbody>"));
}

}  // namespace
}  // namespace obscura::analysis
