// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/gnuplot.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "analysis/plot/child_process.h"
#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Plot three_points() {
    return {"points",
            "Three <points> & a title",
            600,
            400,
            "set xlabel \"time (ms)\"\nplot 'points.tsv' using 1:2 with linespoints lt 1 title " +
                gnuplot_text("it's_one"),
            {{"points.tsv", "1\t2\n2\t3\n3\t5\n"}}};
}

TEST(Gnuplot, DrawsAnSvgWithItsScriptAndDataBesideIt) {
    const tests::TemporaryFolder folder;
    const DrawnPlot drawn = draw(three_points(), folder.path(), true);
    EXPECT_EQ(drawn.note, "");
    EXPECT_THAT(drawn.svg, AllOf(HasSubstr("time (ms)"), HasSubstr("it's_one"),
                                 HasSubstr("<title>Three &lt;points&gt; &amp; a title</title>"),
                                 Not(HasSubstr("<title>Gnuplot"))));
    EXPECT_EQ(base::read_file(folder / "points.svg"), drawn.svg);
    EXPECT_EQ(base::read_file(folder / "points.tsv"), "1\t2\n2\t3\n3\t5\n");
    EXPECT_EQ(base::read_file(folder / "points.png").substr(1, 3), "PNG");
    // The script stands alone.
    std::filesystem::remove(folder / "points.svg");
    EXPECT_EQ(
        run_process({"gnuplot", "points.gnuplot"}, folder.path(), std::chrono::seconds(20)).problem,
        "");
    EXPECT_TRUE(std::filesystem::exists(folder / "points.svg"));
}

TEST(Gnuplot, DrawsTheSameBytesAgain) {
    const tests::TemporaryFolder folder;
    const std::string first = draw(three_points(), folder / "one").svg;
    EXPECT_EQ(first, draw(three_points(), folder / "two").svg);
    EXPECT_FALSE(first.empty());
}

TEST(Gnuplot, WithoutTheProgramLeavesScriptAndDataAndSaysWhy) {
    const tests::TemporaryFolder folder;
    const std::string path = std::getenv("PATH");
    ASSERT_EQ(::setenv("PATH", folder.path().c_str(), 1), 0);
    const DrawnPlot drawn = draw(three_points(), folder / "plots");
    ASSERT_EQ(::setenv("PATH", path.c_str(), 1), 0);
    EXPECT_EQ(drawn.svg, "");
    EXPECT_EQ(drawn.note, "gnuplot is not in the PATH");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "plots" / "points.tsv"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "plots" / "points.gnuplot"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "plots" / "points.svg"));
}

TEST(Gnuplot, AWrongScriptIsANoteWithItsComplaintAndNoPicture) {
    const tests::TemporaryFolder folder;
    Plot plot = three_points();
    plot.script = "plot 'absent.tsv' using 1:2\n";
    const DrawnPlot drawn = draw(plot, folder.path());
    EXPECT_EQ(drawn.svg, "");
    EXPECT_THAT(drawn.note, AllOf(HasSubstr("gnuplot ended with"), HasSubstr("absent.tsv")));
    EXPECT_FALSE(std::filesystem::exists(folder / "points.svg"));
}

TEST(Gnuplot, TakesAnyNameAsText) {
    const tests::TemporaryFolder folder;
    Plot plot = three_points();
    plot.script = "set xlabel " + gnuplot_text("a'b\"c\n`date` @x {/:Bold y} $z \\n") +
                  "\nplot 'points.tsv' using 1:2:xtic(3) with points notitle\n";
    plot.data[0].text = "1\t2\t" + plot_cell("tab\there \"quoted\" _x^2 #3") + "\n2\t3\t\"b\"\n";
    const DrawnPlot drawn = draw(plot, folder.path());
    EXPECT_EQ(drawn.note, "");
    EXPECT_THAT(drawn.svg, AllOf(HasSubstr("a'b\"c `date` @x {/:Bold y} $z \\n"),
                                 HasSubstr("tab here 'quoted' _x^2 #3")));
}

TEST(ChildProcess, IsKilledWhenItsTimeIsOver) {
    const tests::TemporaryFolder folder;
    const ProcessResult result =
        run_process({"sleep", "60"}, folder.path(), std::chrono::milliseconds(50));
    EXPECT_EQ(result.problem, "sleep did not end within 50 ms");
}

TEST(ChildProcess, PassesMuchOutputAndSaysHowItFailed) {
    const tests::TemporaryFolder folder;
    const auto limit = std::chrono::seconds(20);
    EXPECT_EQ(run_process({"head", "-c", "300000", "/dev/zero"}, folder.path(), limit).out.size(),
              300000U);
    EXPECT_THAT(run_process({"sh", "-c", "echo no luck >&2; exit 3"}, folder.path(), limit).problem,
                "sh ended with 3: no luck");
    EXPECT_THAT(run_process({"sh", "-c", "kill -9 $$"}, folder.path(), limit).problem,
                "sh was ended by signal 9");
}

}  // namespace
}  // namespace obscura::analysis
