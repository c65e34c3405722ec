MathJax.Hub.Config({
  messageStyle: "none", showMathMenu: false, SVG: { linebreaks: { automatic: true } }
});
