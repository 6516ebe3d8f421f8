#include "report/report.h"

#include <string_view>

#include "report/page_data.h"
#include "report_page.h"

namespace gradmesh {
namespace {

/// Replaces the one mark in the page by the content.
void fill(std::string& page, std::string_view mark, std::string_view content) {
  page.replace(page.find(mark), mark.size(), content);
}

/// JSON that no text in it can end early: "<" occurs inside strings only.
std::string as_script(const nlohmann::ordered_json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string page_html(const Page& page) {
  std::string html(report_page::index_html);
  fill(html, "/* style */", report_page::style_css);
  fill(html, "/* script */",
       std::string(report_page::dom_js) + report_page::mesh_js + report_page::stage_js +
           report_page::inspector_js + report_page::main_js);
  fill(html, "/* data */", as_script(page_data(page)));
  return html;
}

}  // namespace gradmesh
