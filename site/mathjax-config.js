MathJax.Hub.Config({
  messageStyle: "none", showMathMenu: false, SVG: { linebreaks: { automatic: true } }
});
// A comma after a formula stays on its line.
MathJax.Hub.Queue(() => document.querySelectorAll('script[type="math/tex"]').forEach((source) => {
  const after = source.nextSibling;
  const mark = after && after.nodeType === Node.TEXT_NODE && /^[.,;:!?)]+/.exec(after.data);
  const formula = source.previousSibling;
  if (!mark || !formula) return;
  const whole = document.createElement("span");
  whole.style.whiteSpace = "nowrap";
  after.splitText(mark[0].length);
  formula.before(whole);
  whole.append(formula, source, after);
}));
