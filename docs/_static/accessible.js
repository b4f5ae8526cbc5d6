/* What the theme leaves out: the level of headings in lists of pages, and the keyboard in what scrolls sideways. */
document.querySelectorAll('[role="heading"]:not([aria-level])').forEach(title => title.setAttribute("aria-level", "2"));
document.querySelectorAll("pre, .table-wrapper").forEach(box => box.setAttribute("tabindex", "0"));
/* In German, Sphinx counts by true and false, which are no index of its sentences, and has none on what a search found. */
{
  const { PLURAL_EXPR, TRANSLATIONS } = Documentation, found = "Search finished, found one page matching the search query.";
  Documentation.PLURAL_EXPR = (count) => Number(PLURAL_EXPR(count));
  if (document.documentElement.lang === "de") TRANSLATIONS[found] = ["Eine Seite gefunden.", "${resultCount} Seiten gefunden."];
}
