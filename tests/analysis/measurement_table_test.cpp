// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/measurement_table.h"

#include <gmock/gmock.h>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal_of_measurement(const std::string& text) {
    try {
        (void)parse_measurement(text, "m.csv");
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

TEST(Measurement, IsReadByTheNamesOfItsColumnsInAnyOrder) {
    const MeasurementTable table = parse_measurement(
        "rmse,technique,scene,camera,validity,samples,ms_median,device,fitted,later_column,"
        "published,width\n"
        "0.125,hbao,atrium,nave,high,16,3.5,\"llvmpipe (LLVM 15, 256 bits)\",true,x,III VI,640\n"
        ",unsharp,atrium,nave,high,0,1,d,0,y,,640\n",
        "m.csv");
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.source, "m.csv");
    EXPECT_EQ(*table.rows[0].rmse, 0.125);
    EXPECT_EQ(*table.rows[0].ms_median, 3.5);
    EXPECT_EQ(table.rows[0].samples, 16);
    EXPECT_EQ(table.rows[0].device, "llvmpipe (LLVM 15, 256 bits)");
    EXPECT_TRUE(table.rows[0].fitted);
    EXPECT_EQ(table.rows[0].published, "III VI");
    EXPECT_EQ(table.rows[0].width, 640);
    // An empty cell is no error of 0.
    EXPECT_FALSE(table.rows[1].rmse.has_value());
    EXPECT_FALSE(table.rows[1].fitted);
}

TEST(Measurement, NamesEveryWrongCellWithItsLine) {
    const std::string header = "scene,camera,validity,technique,samples,ms_median,rmse,on_front\n";
    EXPECT_THAT(
        refusal_of_measurement(header + "a,b,low,hbao,1.5,nan,-1,maybe\na,b,low,hbao,4,1\n"),
        AllOf(HasSubstr("m.csv:2: samples is \"1.5\""), HasSubstr("m.csv:2: ms_median is \"nan\""),
              HasSubstr("m.csv:2: rmse is \"-1\", allowed is a finite number of at least 0"),
              HasSubstr("m.csv:2: on_front is \"maybe\""),
              HasSubstr("m.csv:3: all is \"6 cells\", allowed is 8 cells")));
    EXPECT_THAT(refusal_of_measurement("scene,camera,scene\n"),
                AllOf(HasSubstr("m.csv:1: technique is \"\", allowed is the column is needed"),
                      HasSubstr("each column once")));
    EXPECT_THAT(refusal_of_measurement(""), HasSubstr("m.csv:1: the file is empty"));
}

}  // namespace
}  // namespace obscura::analysis
