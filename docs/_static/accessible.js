/* What the theme leaves out: the level of headings in lists of pages, and the keyboard in what scrolls sideways. */
document.querySelectorAll('[role="heading"]:not([aria-level])').forEach(title => title.setAttribute("aria-level", "2"));
document.querySelectorAll("pre, .table-wrapper").forEach(box => box.setAttribute("tabindex", "0"));
