// What is given in place of a scene is named, with the command that reads it.
#include "engine/scene/file_kind.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <tuple>

#include "engine/core/error.h"
#include "engine/core/temporary_folder.h"
#include "engine/scene/scene.h"

namespace dda {
namespace {

using std::string_literals::operator""s;

std::string complaint(const std::string& name, const std::string& content) {
  const TemporaryFolder folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  try {
    scene_text(folder / name);
  } catch (const InputError& error) {
    const std::string text = error.what();
    return text.substr(text.find(name));
  }
  return "taken";
}

TEST(FileKind, DrawingsAreCut) {
  const std::string advice = ", expected a scene (JSON); dda cut ";
  EXPECT_EQ(complaint("plan.xlsx", "PK\x03\x04 and more"),
            "plan.xlsx: the scene file is a workbook (XLSX)" + advice +
                "plan.xlsx --out DIR cuts it, and a scene takes it as the drawing of its rock");
  for (const auto& [name, content, what] :
       {std::tuple("plan.dxf", "  0\nSECTION\n  2\nENTITIES\n", "a drawing (DXF)"),
        std::tuple("PLAN.DXF", "  0\r\nSECTION\r\n", "a drawing (DXF)"),
        std::tuple("export.txt", "999\nby a program\n  0\nSECTION\n", "a drawing (DXF)"),
        std::tuple("plan.csv", "layer,x1,y1,x2,y2\n", "a table (CSV)"),
        std::tuple("plan.geojson", R"({"type": "FeatureCollection"})", "a drawing (GeoJSON)"),
        std::tuple("plan.dc", "0.001\n6 0\n", "a drawing (lines of dc)"),
        std::tuple("blck", "1 0 8\n", "a drawing (blocks of dc)")}) {
    const std::string said = complaint(name, content);
    EXPECT_NE(said.find("the scene file is " + std::string(what) + advice), std::string::npos) << said;
  }
}

TEST(FileKind, FilesOfRunsAndOfOtherPrograms) {
  EXPECT_NE(complaint("checkpoint.bin", "DDASTATE...").find("is a checkpoint"), std::string::npos);
  EXPECT_NE(complaint("frames.pvd", "<VTKFile type=\"Collection\">").find("dda view DIR"), std::string::npos);
  EXPECT_NE(complaint("histories.csv", "time [s],a [m]\n").find("a table of measurements"), std::string::npos);
  EXPECT_NE(complaint("plan.dwg", "AC1032").find("saved as DXF"), std::string::npos);
  EXPECT_NE(complaint("plan.zip", "PK\x03\x04").find("a packed file (zip)"), std::string::npos);
  EXPECT_NE(complaint("scene.json", "\xFF\xFE{\0"s).find("is text in UTF-16"), std::string::npos);
  EXPECT_NE(complaint("plan.pdf", "%PDF-1.4").find("a PDF document"), std::string::npos);
}

// They hold numbers alone, and are no JSON.
TEST(FileKind, DataOfRunsForDfGoBesideBlocks) {
  const std::string said =
      "the scene file is data of a run for df, expected a scene (JSON); dda cut BLOCKS.blck --run-data FILE.df --out "
      "DIR "
      "reads it beside blocks or lines of dc";
  for (const char* name : {"x.df", "RUN.DF", "x.ana"})
    EXPECT_EQ(complaint(name, "0\n1 2 3\n"), std::string(name) + ": " + said);
}

// Whatever their names: what is wrong with them is said as of any scene.
TEST(FileKind, WhatMayBeASceneIsTaken) {
  for (const char* name : {"scene.json", "scene.csv", "scene.df", "scene"})
    for (const char* content : {"{\"dda\": 1}", "\xEF\xBB\xBF {}", " \n{", ""})
      EXPECT_EQ(complaint(name, content), "taken") << name << ' ' << content;
  EXPECT_EQ(complaint("scene.json", "no JSON"), "taken");
}

}  // namespace
}  // namespace dda
