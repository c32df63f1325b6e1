// The engine of the HTML pages: what a value holds can be read on the page, and does nothing.
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/pages/bench_page.hpp"
#include "app/pages/compare_page.hpp"
#include "app/pages/page.hpp"
#include "app/pages/plot.hpp"
#include "app/pages/probes_page.hpp"
#include "app/pages/sweep_page.hpp"
#include "page_support.hpp"

namespace app_page_tests {

using namespace spindrift::app;
using Catch::Contains;
using spindrift::test::plots_in;

namespace {

const std::vector<std::string> hostile{"</script><script>window.hit=1</script>",
                                       "\"><img src=x onerror=window.hit=1>",
                                       "' onmouseover='window.hit=1",
                                       "{{data}}",
                                       "{{#b}}",
                                       "${window.hit=1}",
                                       "javascript:window.hit=1",
                                       "<!--",
                                       "]]>",
                                       "&lt;b&gt;",
                                       "a\xe2\x80\xa8z",
                                       "\\u003cb\\u003e \\ \n"};

std::string filled(const std::string& page, const PageValues& values) {
  return PageTemplate(page).fill(values);
}

/// Text as a browser shows it.
std::string shown(std::string text) {
  const auto replace = [&](const std::string& by, const std::string& what) {
    for (auto at = text.find(by); at != std::string::npos; at = text.find(by, at + what.size()))
      text.replace(at, by.size(), what);
  };
  replace("&lt;", "<");
  replace("&gt;", ">");
  replace("&quot;", "\"");
  replace("&#39;", "'");
  replace("&amp;", "&");
  return text;
}

}  // namespace

TEST_CASE("a text stands on the page as it is, in text and in attributes") {
  for (const std::string& text : hostile) {
    INFO(text);
    const std::string page =
        filled("<p title=\"{{a}}\">{{a}}|{{b}}</p>", {{"a", text}, {"b", "z"}});
    CHECK(std::count(page.begin(), page.end(), '<') == 2);
    CHECK(std::count(page.begin(), page.end(), '>') == 2);
    CHECK(std::count(page.begin(), page.end(), '"') == 2);
    CHECK(page.find('\'') == std::string::npos);
    CHECK(shown(page) == "<p title=\"" + text + "\">" + text + "|z</p>");
  }
}

TEST_CASE("data of a script can neither end it nor be taken for a place") {
  for (const std::string& text : hostile) {
    INFO(text);
    const std::string page =
        filled("<script type=\"application/json\">{{data}}</script><p>{{a}}</p>",
               {{"data", PageData(nlohmann::ordered_json{{text, text}})}, {"a", "z"}});
    const std::string data = page.substr(32, page.find("</script><p>z</p>") - 32);
    CHECK(data.find_first_of("<>&") == std::string::npos);
    CHECK(data.find("\u2028") == std::string::npos);
    CHECK(nlohmann::ordered_json::parse(data) == nlohmann::ordered_json{{text, text}});
  }
}

TEST_CASE("a file's address is its path, whatever is in it") {
  const auto url = [](const std::string& path) { return Url::of_file(path).text(); };
  CHECK(url("runs/a b/0001.png") == "runs/a%20b/0001.png");
  CHECK(url("javascript:alert(1)") == "javascript%3Aalert%281%29");
  CHECK(url("//host/file") == "/host/file");
  CHECK(url("a?b#c%20\"'&<\xc3\xa4") == "a%3Fb%23c%2520%22%27%26%3C%C3%A4");
  CHECK(Url::of_content("image/png", "many").text() == "data:image/png;base64,bWFueQ==");
  CHECK(filled("<a href=\"{{f}}\">{{n}}</a>", {{"f", Url::of_file("a:b")}, {"n", "a:b"}}) ==
        "<a href=\"a%3Ab\">a:b</a>");
}

TEST_CASE("pieces stand once for each record, or by a truth value") {
  const std::string page = "{{#rows}}<b>{{a}}{{#c}}!{{/c}}{{name}}</b>{{/rows}}";
  const std::vector<PageValues> rows{{{"a", "1"}, {"c", true}}, {{"a", "{{name}}"}, {"c", false}}};
  CHECK(filled(page, {{"rows", rows}, {"name", "z"}}) == "<b>1!z</b><b>{{name}}z</b>");
  CHECK(filled(page, {{"rows", std::vector<PageValues>{}}, {"name", "z"}}).empty());
}

TEST_CASE("a place without a value, a value without a place and another kind are refused") {
  CHECK_THROWS_WITH(filled("{{a}}{{b}}", {{"a", "1"}}), Contains("{{b}} has no value"));
  CHECK_THROWS_WITH(filled("{{a}}", {{"a", "1"}, {"b", "1"}}), Contains("b has no place"));
  CHECK_THROWS_WITH(filled("{{a}}", {{"a", true}}), Contains("another kind"));
  CHECK_THROWS_WITH(filled("{{a}}", {{"a", Url::of_file("x")}}), Contains("another kind"));
  CHECK_THROWS_WITH(filled("{{a}}", {{"a", PageData(nlohmann::ordered_json(1))}}),
                    Contains("another kind"));
  CHECK_THROWS_WITH(filled("<img src=\"{{a}}\">", {{"a", "x"}}), Contains("another kind"));
}

TEST_CASE("a template with a place where no value is safe is refused") {
  for (const char* page : {"<script>let a = {{a}};</script>",
                           "<style>{{a}}</style>",
                           "<p style=\"{{a}}\">",
                           "<p onclick=\"{{a}}\">",
                           "<{{a}}>",
                           "<p {{a}}>",
                           "<p class={{a}}>",
                           "<p class='{{a}}'>",
                           "<!-- {{a}} -->",
                           "<iframe src=\"{{a}}\"></iframe>",
                           "<script src=\"{{a}}\"></script>",
                           "<a href=\"x{{a}}\">",
                           "<a href=\"{{a}}x\">",
                           "<script type=\"application/json\">[{{a}}]</script>",
                           "<p class=\"{{#a}}x{{/a}}\">",
                           "{{#a}}<p>",
                           "{{/a}}",
                           "{{a",
                           "{{A b}}",
                           "<p class=\""}) {
    INFO(page);
    CHECK_THROWS_AS(PageTemplate(page), std::logic_error);
  }
}

TEST_CASE("the templates of all pages are taken") {
  for (const std::string_view page : {bench_page, compare_page, probes_page, sweep_page})
    CHECK_NOTHROW(PageTemplate(page));
}

TEST_CASE("a plot is data in its page, whatever its texts say") {
  const std::string page =
      "{{#plots}}<figure class=\"plot\"><script type=\"application/json\">{{plot}}</script>"
      "</figure>{{/plots}}";
  for (const std::string& text : hostile) {
    INFO(text);
    const Plot plot{.x_label = text,
                    .y_label = text,
                    .curves = {{.title = text, .points = {{0, 1}, {1, 2.5}}}}};
    const std::string made = filled(page, {{"plots", std::vector{plot_values(plot)}}});
    CHECK(std::count(made.begin(), made.end(), '<') == 4);
    const auto plots = plots_in(made);
    REQUIRE(plots.size() == 1);
    CHECK(plots[0]["x_label"] == text);
    CHECK(plots[0]["y_label"] == text);
    CHECK(plots[0]["curves"][0]["title"] == text);
    CHECK(plots[0]["curves"][0]["points"] == nlohmann::json{{0., 1.}, {1., 2.5}});
  }
}

TEST_CASE("a plot's data say how its axes and curves are drawn") {
  const auto data = [](const Plot& plot) {
    return nlohmann::json::parse(std::get<PageData>(plot_values(plot).at("plot").value).text);
  };
  const auto plain = data({.curves = {{}, {.points = {{0, 1}}}}});
  CHECK((!plain["log_x"] && !plain["log_y"] && plain["y_from_zero"]));
  REQUIRE(plain["curves"].size() == 1);  // without the one that has no points
  const auto& line = plain["curves"][0];
  CHECK((line["line"] && line["dashed"] && line["marker"] == "none" && line["color"] == 0));
  const auto other = data({.log_x = true,
                           .log_y = true,
                           .y_from_zero = false,
                           .curves = {{.points = {{1, 1}},
                                       .color = 9,
                                       .marker = Marker::square,
                                       .filled = true,
                                       .dashed = false}}});
  CHECK((other["log_x"] && other["log_y"] && !other["y_from_zero"]));
  const auto& points = other["curves"][0];
  CHECK((!points["line"] && !points["dashed"] && points["filled"]));
  CHECK((points["marker"] == "square" && points["color"] == 9));
}

}  // namespace app_page_tests
