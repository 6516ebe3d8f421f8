#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace gradmesh {

/// Returns the body of a stream object; `entries` stand in its dictionary beside Length.
inline std::string pdf_stream(const std::string& entries, const std::string& data) {
  return "<< " + entries + " /Length " + std::to_string(data.size()) + " >>\nstream\n" + data +
         "\nendstream";
}

/// A page: what stands in its dictionary, and its content.
struct PdfPageText {
  std::string entries, content;
};

/// Returns a PDF document of these pages. Page n is object 3 + 2 n; the further objects have the
/// numbers behind those of all pages. `catalog` stands in the dictionary of the document.
inline std::string pdf_document(const std::vector<PdfPageText>& pages,
                                const std::vector<std::string>& objects = {},
                                const std::string& catalog = "") {
  std::string kids;
  for (std::size_t n = 0; n < pages.size(); ++n) kids += std::to_string(3 + 2 * n) + " 0 R ";
  std::vector<std::string> all{
      "<< /Type /Catalog /Pages 2 0 R " + catalog + " >>",
      "<< /Type /Pages /Kids [" + kids + "] /Count " + std::to_string(pages.size()) + " >>"};
  for (std::size_t n = 0; n < pages.size(); ++n) {
    all.push_back("<< /Type /Page /Parent 2 0 R /Contents " + std::to_string(4 + 2 * n) + " 0 R " +
                  pages[n].entries + " >>");
    all.push_back(pdf_stream("", pages[n].content));
  }
  all.insert(all.end(), objects.begin(), objects.end());
  std::string text = "%PDF-1.7\n", table;
  for (std::size_t n = 0; n < all.size(); ++n) {
    char entry[32];
    std::snprintf(entry, sizeof entry, "%010zu 00000 n \n", text.size());
    table += entry;
    text += std::to_string(n + 1) + " 0 obj\n" + all[n] + "\nendobj\n";
  }
  const std::string size = std::to_string(all.size() + 1), start = std::to_string(text.size());
  return text + "xref\n0 " + size + "\n0000000000 65535 f \n" + table + "trailer\n<< /Size " +
         size + " /Root 1 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

/// Returns a PDF document of one page. Its further objects have the numbers from 5 on.
inline std::string pdf_document(const std::string& page_entries, const std::string& content,
                                const std::vector<std::string>& objects = {}) {
  return pdf_document(std::vector<PdfPageText>{{page_entries, content}}, objects);
}

}  // namespace gradmesh
