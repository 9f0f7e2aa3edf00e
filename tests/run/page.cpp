// A page of a result needs no other file, holds every picture, and shows text as text.
#include "run/page/page.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "fake_experiment.hpp"
#include "run/ensemble.hpp"
#include "run/page/html.hpp"
#include "run/plot/gallery.hpp"
#include "scratch.hpp"

namespace shmoo::run {
namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Page, HoldsEveryPictureAndNeedsNoOtherFile) {
  for (const int dimension : {1, 2, 3}) {
    const Scratch scratch;
    FakeExperiment fake(dimension, 6, 3);
    run_ensemble(fake, {.output = scratch / "r.h5", .realisations = 3});
    const ResultFile result(scratch / "r.h5");
    const auto page = result_page(result, 2);
    EXPECT_EQ(count(page, "<img "), gallery(result, {.times = {2}}).size());
    EXPECT_EQ(count(page, "src=\"data:image/png;base64,iVBORw0KGgo"), count(page, "<img "));
    EXPECT_EQ(count(page, "http:") + count(page, "https:") + count(page, "<link") + count(page, "<script"), 0u);
    EXPECT_EQ(count(page, "<table"), count(page, "</table>"));
    for (const auto* heading : {"Observables", "Pictures at", "Where the molecules went", "The model"})
      EXPECT_EQ(count(page, heading), 1u) << heading;
  }
}

TEST(Page, TextIsShownAsText) {
  const Scratch scratch;
  FakeExperiment fake(2, 4, 2);
  fake.scene_.title = "<script>alert(\"x\")</script> & more";
  run_ensemble(fake, {.output = scratch / "r.h5", .realisations = 1});
  const auto page = result_page(ResultFile(scratch / "r.h5"), 0);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_GE(count(page, "&lt;script&gt;alert(&quot;x&quot;)&lt;/script&gt; &amp; more"), 2u);
}

TEST(Page, BytesBecomeBase64) {  // RFC 4648, section 10
  const Scratch scratch;
  for (const auto& [bytes, digits] :
       {std::pair{"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}}) {
    std::ofstream(scratch / "x.png") << bytes;
    EXPECT_EQ(count(html::image(scratch / "x.png", ""), std::string("base64,") + digits + "\""), 1u) << bytes;
  }
}

}  // namespace
}  // namespace shmoo::run
