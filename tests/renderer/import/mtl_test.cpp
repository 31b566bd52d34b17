// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/renderer/import/obj_maker.h"

namespace obscura::renderer {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using tests::first_material;
using tests::first_texel;
using tests::ObjMaker;
using tests::plain_texture;

/// A texture whose left half has other texels than its right one.
Texture two_halves(std::initializer_list<int> left, std::initializer_list<int> right) {
    Texture texture{"halves", 4, 4, true, {}};
    for (int i = 0; i < 16; ++i) {
        for (const int value : i % 4 < 2 ? left : right) {
            texture.rgba.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return texture;
}

std::vector<int> alphas_of(const ImportedScene& imported) {
    const Texture& texture = imported.scene.textures.at(
        static_cast<std::size_t>(first_material(imported).albedo_texture));
    return {texture.rgba[3], texture.rgba[4 * static_cast<std::size_t>(texture.width - 1) + 3]};
}

TEST(Mtl, TheAlphaOfAMaskIsItsAlphaChannel) {
    const ObjMaker files;
    files.add("leaf.png", two_halves({30, 140, 20, 255}, {30, 140, 20, 0}));
    for (const char* mtl : {"newmtl m\nmap_Kd leaf.png\nmap_d leaf.png\n",
                            "newmtl m\nmap_d leaf.png\nmap_Kd leaf.png\n",
                            "newmtl m\nmap_Kd leaf.png\nmap_d -imfchan m leaf.png\n"}) {
        const ImportedScene imported = files.with_materials(mtl);
        EXPECT_EQ(first_material(imported).coverage, Coverage::kCutOut);
        EXPECT_THAT(alphas_of(imported), ElementsAre(255, 0)) << mtl;
        EXPECT_THAT(first_texel(imported), ElementsAre(30, 140, 20, 255));
        EXPECT_EQ(first_material(imported).albedo, glm::vec3(1.0F));
        EXPECT_EQ(imported.files.size(), 3U) << "each is read once";
    }
}

TEST(Mtl, AMaskWithoutAlphaGivesLuminanceAndImfchanChooses) {
    const ObjMaker files;
    files.add("mask.png", two_halves({255, 0, 0, 255}, {0, 255, 0, 128}));
    const auto alphas = [&](const char* option) {
        return alphas_of(
            files.with_materials(fmt::format("newmtl m\nmap_d {} mask.png\n", option)));
    };
    EXPECT_THAT(alphas("-imfchan r"), ElementsAre(255, 0));
    EXPECT_THAT(alphas("-imfchan g"), ElementsAre(0, 255));
    EXPECT_THAT(alphas("-imfchan b"), ElementsAre(0, 0));
    EXPECT_THAT(alphas("-imfchan l"), ElementsAre(54, 182));
    EXPECT_THAT(alphas("-imfchan m"), ElementsAre(255, 128));
    EXPECT_THAT(alphas(""), ElementsAre(255, 128));
    // Opaque everywhere: its alpha says nothing.
    files.add("mask.png", two_halves({255, 0, 0, 255}, {0, 255, 0, 255}));
    EXPECT_THAT(alphas(""), ElementsAre(54, 182));
    const ImportedScene depth = files.with_materials("newmtl m\nmap_d -imfchan z mask.png\n");
    EXPECT_THAT(depth.notes, Contains(HasSubstr("-imfchan z is not obeyed")));
}

TEST(Mtl, AMaskLargerThanTheColoursKeepsItsTexels) {
    const ObjMaker files;
    files.add("mask.png", two_halves({255, 255, 255, 255}, {0, 0, 0, 255}));
    files.add("one.png", plain_texture(1, {9, 8, 7, 255}));
    const ImportedScene imported =
        files.with_materials("newmtl m\nmap_Kd one.png\nmap_d mask.png\n");
    EXPECT_THAT(alphas_of(imported), ElementsAre(255, 0));
    EXPECT_THAT(first_texel(imported), ElementsAre(9, 8, 7, 255));
}

TEST(Mtl, AnAlphaThatNoMapDUsesIsSaidAndNotShown) {
    const ObjMaker files;
    files.add("leaf.png", two_halves({30, 140, 20, 255}, {0, 0, 0, 0}));
    const ImportedScene imported = files.with_materials("newmtl m\nmap_Kd leaf.png\nd 0.5\n");
    EXPECT_THAT(imported.notes, Contains(HasSubstr("names no map_d: leaf.png of m")));
    EXPECT_THAT(alphas_of(imported), ElementsAre(255, 255));
}

TEST(Mtl, DOutranksTrInAnyOrder) {
    const ObjMaker files;
    for (const char* mtl : {"newmtl m\nd 1\nTr 1\n", "newmtl m\nTr 1\nd 1\n"}) {
        EXPECT_EQ(first_material(files.with_materials(mtl)).coverage, Coverage::kOpaque) << mtl;
    }
    EXPECT_FLOAT_EQ(first_material(files.with_materials("newmtl m\nTr .2\nd .75\n")).opacity, .75F);
}

TEST(Mtl, TrAloneMeansWhatLeavesMaterialsToBeSeen) {
    const ObjMaker files;
    const auto opacity = [&](std::string_view mtl) {
        const ImportedScene imported = files.with_materials(mtl);
        EXPECT_THAT(imported.notes, Contains(HasSubstr("Tr without d"))) << mtl;
        return first_material(imported).opacity;
    };
    EXPECT_FLOAT_EQ(opacity("newmtl m\nTr 1.000000\nnewmtl n\nTr 1\n"), 1.0F);
    EXPECT_FLOAT_EQ(opacity("newmtl m\nTr .25\nnewmtl n\nTr 1\n"), 0.25F);
    EXPECT_FLOAT_EQ(opacity("newmtl m\nTr .25\nnewmtl n\nTr 0\n"), 0.75F);
    EXPECT_FLOAT_EQ(opacity("newmtl m\nTr .25\nnewmtl n\nd .9\nTr .9\n"), 0.25F);
    EXPECT_FLOAT_EQ(opacity("newmtl m\nTr .25\nnewmtl n\nd .9\nTr .1\n"), 0.75F);
}

TEST(Mtl, OpacityOfNothingIsSaid) {
    const ObjMaker files;
    files.add("none.png", two_halves({9, 9, 9, 0}, {9, 9, 9, 60}));
    for (const char* mtl :
         {"newmtl m\nd 0\n", "newmtl m\nd -halo 0\n", "newmtl m\nmap_d none.png\n"}) {
        EXPECT_THAT(files.with_materials(mtl).notes, Contains(HasSubstr("cannot be seen"))) << mtl;
    }
    EXPECT_THAT(files.with_materials("newmtl m\nd .01\n").notes,
                Each(Not(HasSubstr("cannot be seen"))));
    EXPECT_THAT(files.with_materials("newmtl m\nd -halo .5\n").notes, Contains(HasSubstr("-halo")));
}

TEST(Mtl, AMaterialWithoutKdIsWhiteUnderItsTextureAndGreyWithoutOne) {
    const ObjMaker files;
    files.add("white.png", plain_texture(2, {255, 255, 255, 255}));
    const auto albedo = [&](const char* mtl) {
        return first_material(files.with_materials(mtl)).albedo;
    };
    EXPECT_EQ(albedo("newmtl m\nmap_Kd white.png\n"), glm::vec3(1.0F));
    EXPECT_EQ(albedo("newmtl m\n"), glm::vec3(0.8F));
    EXPECT_EQ(albedo("newmtl m\nmap_Kd white.png\nKd .5 .5 .5\n"), glm::vec3(0.5F));
    EXPECT_THAT(files.with_materials("newmtl m\nKd 0 0 0\nmap_Kd white.png\n").notes,
                Contains(HasSubstr("black: m")));
}

TEST(Mtl, OptionsTakeTheirArgumentsAndThoseNotObeyedAreSaid) {
    const ObjMaker files;
    files.add("a b.png", plain_texture(2, {9, 8, 7, 255}));
    const auto notes_of = [&](const std::string& options) {
        const ImportedScene imported =
            files.with_materials(fmt::format("newmtl m\nmap_Kd {} a b.png\n", options));
        EXPECT_THAT(first_texel(imported), ElementsAre(9, 8, 7, 255)) << options;
        return fmt::format("{}", fmt::join(imported.notes, "\n"));
    };
    for (const char* idle : {"-s 1 1 1", "-o 0", "-t 0 0", "-blendu on -blendv on", "-clamp off",
                             "-mm 0 1", "-cc off", "-S 1 1 1"}) {
        EXPECT_THAT(notes_of(idle), Not(HasSubstr("option"))) << idle;
    }
    for (const char* other : {"-s 2", "-s 2 2 2", "-o -1 -.5", "-t .1 .1 .1", "-blendu off",
                              "-blendv off", "-clamp on", "-mm -1 2", "-cc on", "-texres 512",
                              "-boost 2", "-bm .5", "-imfchan r", "-type cube_top"}) {
        const std::string word(other, std::strchr(other, ' '));
        EXPECT_THAT(notes_of(other), HasSubstr("option " + word)) << other;
        EXPECT_THAT(notes_of(other), HasSubstr("not obeyed")) << other;
        EXPECT_THAT(notes_of(other), HasSubstr("made.mtl:2")) << other;
        EXPECT_THAT(notes_of(word), HasSubstr("option " + word + " wants")) << word;
    }
    EXPECT_THAT(notes_of("-fancy on 3"), HasSubstr("option -fancy is not known"));
    EXPECT_THAT(notes_of("-s 2 2 -clamp on -o 1"),
                AllOf(HasSubstr("-s "), HasSubstr("-clamp on"), HasSubstr("-o ")));
}

TEST(Mtl, NamesOfFilesMayHoldBlanksQuotesHashesDashesAndBackslashes) {
    const ObjMaker files;
    for (const char* name : {"a #1.png", "#2.png", "x\"y.png", "it's.png", "-s.png", "a -s 2.png",
                             "back\\slash.png", "1", "\xC3\xA4.png"}) {
        files.add(name, plain_texture(2, {9, 8, 7, 255}));
        const ImportedScene imported =
            files.with_materials(fmt::format("newmtl m\nmap_Kd {}\n", name));
        EXPECT_THAT(first_texel(imported), ElementsAre(9, 8, 7, 255)) << name;
    }
    files.add("Textures/Wood.png", plain_texture(2, {1, 2, 3, 255}));
    for (const char* name :
         {"\"Textures/Wood.png\"", "Textures\\Wood.png", "textures/wood.PNG",
          ".\\TEXTURES\\wood.png", "Textures/Wood.png # oak", "Textures/Wood.png -s 1 1 1"}) {
        const ImportedScene imported =
            files.with_materials(fmt::format("newmtl m\nmap_Kd {}\n", name));
        EXPECT_THAT(first_texel(imported), ElementsAre(1, 2, 3, 255)) << name;
    }
    EXPECT_THAT(files.with_materials("newmtl m\nmap_Kd Textures/wood.png\n").notes,
                Contains(HasSubstr("differ in case are taken for those that are meant: Wood.png")));
}

TEST(Mtl, NamesOfMaterialsAreAllThatFollows) {
    const ObjMaker files;
    files.add(
        "made.mtl",
        "newmtl #1\nKd 1 0 0\nnewmtl #2\nKd 0 1 0\nnewmtl a #1\nKd 0 0 1\nnewmtl \"q\"\nKd 1 1 0\n"
        "newmtl b\\c\nKd 0 1 1\nnewmtl end\\\nKd 1 0 1\n");
    const auto colour = [&](const std::string& name) {
        return first_material(files.import("mtllib made.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl " +
                                           name + "\nf 1 2 3\n"))
            .albedo;
    };
    EXPECT_EQ(colour("#1"), glm::vec3(1, 0, 0));
    EXPECT_EQ(colour("#2  "), glm::vec3(0, 1, 0));
    EXPECT_EQ(colour("a #1"), glm::vec3(0, 0, 1));
    EXPECT_EQ(colour("a"), glm::vec3(0, 0, 1));
    EXPECT_EQ(colour("\"q\""), glm::vec3(1, 1, 0));
    EXPECT_EQ(colour("Q"), glm::vec3(1, 1, 0));
    EXPECT_EQ(colour("b\\c"), glm::vec3(0, 1, 1));
    EXPECT_EQ(colour("end\\"), glm::vec3(1, 0, 1));
    EXPECT_EQ(colour("#1 # the red one"), glm::vec3(1, 0, 0));
    EXPECT_EQ(colour("#3"), glm::vec3(0.8F));
}

TEST(Mtl, SeveralLibrariesAreReadEachOnce) {
    const ObjMaker files;
    files.add("one.mtl", "newmtl a\nKd 1 0 0\n");
    files.add("two words.mtl", "newmtl b\nKd 0 1 0\n");
    files.add("three.mtl", "newmtl m\nKd 0 0 1\n");
    std::string text;
    for (int i = 0; i < 50; ++i) {
        text += "mtllib one.mtl two words.mtl ./three.mtl\nmtllib three.mtl\nmtllib " +
                std::string(static_cast<std::size_t>(i), ' ') + "one.mtl # again\n";
    }
    const ImportedScene imported = files.import(text + std::string(ObjMaker::kSquare));
    EXPECT_EQ(first_material(imported).albedo, glm::vec3(0, 0, 1));
    EXPECT_EQ(imported.scene.materials.size(), 3U);
    EXPECT_EQ(imported.files.size(), 4U);
    EXPECT_THAT(imported.notes, Contains(HasSubstr("materials made.mtl: the file is missing")));
    EXPECT_THAT(imported.notes, Each(Not(HasSubstr("more than once"))));
}

TEST(Mtl, AStatementThatCannotBeUsedIsPassedOverWithItsPlace) {
    const ObjMaker files;
    const ImportedScene imported = files.with_materials(
        "Kd 1 1 1\nnewmtl m\nKd red\nKd .5 .5\nKd -1 0 0\nKs spectral x.rfl\nNs\nd 3\nd x\nillum "
        "many\n"
        "map_Kd\nwobble 3\nmap_Pr r.png\nKe nan 0 0\nTf .5 1 1\n");
    EXPECT_EQ(first_material(imported).albedo, glm::vec3(0.8F));
    EXPECT_EQ(first_material(imported).opacity, 1.0F);
    for (const char* note :
         {"before the first newmtl are left out: made.mtl:1 (Kd 1 1 1)",
          "Kd wants one or three numbers from 0 on; it is passed over: made.mtl:3 (Kd red)",
          "Ks wants one or three", "Ns wants a number from 0 on",
          "d is limited to 0 to 1: made.mtl:8", "d wants a number from 0 to 1", "illum wants",
          "maps without a file", "not known are left out: made.mtl:12 (wobble 3)",
          "left out: map_pr", "Ke wants", "Tf is"}) {
        EXPECT_THAT(imported.notes, Contains(HasSubstr(note))) << note;
    }
}

TEST(Mtl, MasksOfManyMaterialsCountTowardTheLimit) {
    // 40,000 materials over one mask would be 40 GB of copies; one is made.
    const ObjMaker files;
    files.add("mask.png", two_halves({255, 255, 255, 255}, {0, 0, 0, 0}));
    std::string mtl;
    for (int i = 0; i < 1000; ++i) mtl += fmt::format("newmtl m{}\nmap_d mask.png\n", i);
    const ImportedScene imported = files.with_materials(mtl + "newmtl m\nmap_d mask.png\n");
    EXPECT_EQ(imported.scene.textures.size(), 1U);
}

TEST(Mtl, AGltfMaterialThatNobodyCanSeeIsSaid) {
    for (const char* mode : {"BLEND", "MASK", "OPAQUE"}) {
        tests::GlbMaker glb = tests::triangle_glb();
        glb.json["materials"][0]["alphaMode"] = mode;
        glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
        const auto said = Contains(HasSubstr("cannot be seen"));
        if (std::string_view(mode) == "OPAQUE") {
            EXPECT_THAT(glb.import().notes, Not(said));
        } else {
            EXPECT_THAT(glb.import().notes, said) << mode;
        }
    }
}

}  // namespace
}  // namespace obscura::renderer
