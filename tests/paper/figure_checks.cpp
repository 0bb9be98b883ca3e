#include "paper/figure_checks.h"

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::test {
namespace {

void save(const render::workers::DrawnFigure& drawn) {
  const char* folder = std::getenv("TRIBOLOG_SAVE_DRAWINGS");
  if (folder == nullptr) return;
  std::ofstream file(std::string(folder) + "/" + drawn.id + ".png", std::ios::binary);
  file.write(reinterpret_cast<const char*>(drawn.png.data()),
             static_cast<std::streamsize>(drawn.png.size()));
}

}  // namespace

void expect_complete_in_words(const std::vector<figures::ReportFigure>& figures) {
  const std::string safe = "abcdefghijklmnopqrstuvwxyz0123456789-";
  std::set<std::string> ids;
  for (const figures::ReportFigure& one : figures) {
    SCOPED_TRACE(one.id);
    EXPECT_TRUE(ids.insert(one.id).second);
    EXPECT_EQ(one.id.find_first_not_of(safe), std::string::npos);
    EXPECT_EQ(one.id, one.figure.id);
    EXPECT_EQ(one.title, one.figure.title);
    EXPECT_LE(one.title.size(), 60U);
    EXPECT_FALSE(one.title.empty());
    for (const std::string& text : {one.caption, one.how_to_read, one.alt}) {
      ASSERT_FALSE(text.empty());
      EXPECT_EQ(text.back(), '.') << text;
      EXPECT_EQ(text.find("_{"), std::string::npos) << text;
    }
  }
}

void expect_drawn_whole(const std::vector<figures::ReportFigure>& figures) {
  std::vector<render::figure::Figure> pictures;
  for (const figures::ReportFigure& one : figures) pictures.push_back(one.figure);
  for (const render::workers::DrawnFigure& drawn :
       render::workers::FigureRenderer().draw(pictures)) {
    EXPECT_EQ(wording::words(drawn.error), "") << drawn.id;
    EXPECT_FALSE(drawn.png.empty()) << drawn.id;
    for (const Statement& warning : drawn.warnings) {
      ADD_FAILURE() << drawn.id << ": " << wording::words(warning);
    }
    save(drawn);
  }
}

}  // namespace tribolog::test
