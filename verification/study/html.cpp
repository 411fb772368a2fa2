#include "verification/study/html.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/core/read_file.h"

namespace verify {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

// Turns `mark`...`mark` into <element>...</element>; a mark without its partner stays.
void mark_up(std::string& text, std::string_view mark, const std::string& element) {
  for (std::size_t first = text.find(mark); first != std::string::npos; first = text.find(mark, first)) {
    const std::size_t second = text.find(mark, first + mark.size());
    if (second == std::string::npos) return;
    text.replace(second, mark.size(), "</" + element + ">");
    text.replace(first, mark.size(), "<" + element + ">");
  }
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// True if text[space] stands between a number and a unit of at most three letters (or %).
bool before_unit(std::string_view text, std::size_t space) {
  if (space == 0 || !is_digit(text[space - 1]) || space + 1 == text.size()) return false;
  std::size_t end = space + 1;
  while (end < text.size() && is_letter(text[end])) ++end;
  const std::string_view unit = text.substr(space + 1, end - space - 1);
  return text[space + 1] == '%' || unit == "m" || unit == "s" || unit == "ms" || unit == "mm" || unit == "kPa" ||
         unit == "GPa" || unit == "Hz" || unit == "kN" || unit == "kg" || unit == "E";
}

void keep_units(std::string& text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
    if (before_unit(text, at)) text.replace(at, 1, "&nbsp;");
}

std::string cells(const std::vector<std::string>& texts, std::string_view element) {
  std::string html;
  for (const std::string& text : texts) html += fmt::format("<{}>{}</{}>", element, inline_html(text), element);
  return html;
}

std::string group_row(const std::vector<ColumnGroup>& groups) {
  if (groups.empty()) return "";
  std::string html = "<tr class=\"groups\">";
  for (const ColumnGroup& group : groups)
    html += fmt::format("<th colspan=\"{}\"{}>{}</th>", group.columns, group.title.empty() ? " class=\"none\"" : "",
                        inline_html(group.title));
  return html + "</tr>\n";
}

class Renderer {
 public:
  explicit Renderer(const std::filesystem::path& folder) : folder_(folder) {}

  std::string operator()(const Paragraph& paragraph) const {
    return fmt::format("<p>{}</p>\n", inline_html(paragraph.text));
  }

  std::string operator()(const Bullets& bullets) const {
    std::string html = "<ul>\n";
    for (const std::string& item : bullets.items) html += fmt::format("<li>{}</li>\n", inline_html(item));
    return html + "</ul>\n";
  }

  std::string operator()(const Table& table) const {
    std::string html = fmt::format("<div class=\"table\"><table class=\"{}\">\n", table.numeric ? "numbers" : "words");
    if (!table.caption.empty()) html += fmt::format("<caption>{}</caption>\n", inline_html(table.caption));
    html +=
        fmt::format("<thead>\n{}<tr>{}</tr>\n</thead>\n<tbody>\n", group_row(table.groups), cells(table.header, "th"));
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const bool starts_part = std::ranges::count(table.breaks, static_cast<int>(i)) > 0;
      html += fmt::format("<tr{}>{}</tr>\n", starts_part ? " class=\"part\"" : "", cells(table.rows[i], "td"));
    }
    return html + "</tbody>\n</table></div>\n";
  }

  std::string operator()(const Figure& figure) const {
    const std::string prefix = std::filesystem::path(figure.file).stem().string() + "-";
    return fmt::format("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n",
                       embedded_svg(dda::read_file(folder_ / figure.file), prefix), inline_html(figure.caption));
  }

 private:
  const std::filesystem::path& folder_;
};

std::string header_of(const Document& document) {
  std::string html = fmt::format("<header>\n<h1>{}</h1>\n<p class=\"subtitle\">{}</p>\n</header>\n",
                                 inline_html(document.title), inline_html(document.subtitle));
  if (document.key_figures.empty()) return html;
  html += "<dl class=\"key\">\n";
  for (const KeyFigure& figure : document.key_figures)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", inline_html(figure.label), inline_html(figure.value));
  return html + "</dl>\n";
}

}  // namespace

std::string inline_html(std::string_view text) {
  std::string html(text);
  replace_all(html, "&", "&amp;");
  replace_all(html, "<", "&lt;");
  replace_all(html, ">", "&gt;");
  keep_units(html);
  mark_up(html, "**", "strong");
  mark_up(html, "`", "code");
  return html;
}

std::string embedded_svg(std::string svg, const std::string& prefix) {
  const std::size_t element = svg.find("<svg");
  if (element != std::string::npos) svg.erase(0, element);
  replace_all(svg, "id=\"", "id=\"" + prefix);
  replace_all(svg, "id='", "id='" + prefix);
  replace_all(svg, "href='#", "href='#" + prefix);
  replace_all(svg, "href=\"#", "href=\"#" + prefix);
  replace_all(svg, "url(#", "url(#" + prefix);
  return svg;
}

std::string to_html(const Document& document, const std::filesystem::path& folder) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n<main>\n{}",
      inline_html(document.title), report_css(), header_of(document));
  const Renderer renderer(folder);
  for (const Section& section : document.sections) {
    html += fmt::format("<section>\n<h2>{}</h2>\n", inline_html(section.title));
    for (const Piece& piece : section.pieces) html += std::visit(renderer, piece);
    html += "</section>\n";
  }
  return html + fmt::format("<footer>{}</footer>\n</main>\n</body>\n</html>\n", inline_html(document.footer));
}

}  // namespace verify
