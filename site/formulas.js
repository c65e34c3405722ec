// Formulas are typeset by MathJax, which is loaded on pages that have any.
document.addEventListener('DOMContentLoaded', () => {
  const listing = location.pathname.endsWith('_source.html');
  if (listing || !/\\[[(]/.test(document.body.textContent)) return;
  window.MathJax = {
    extensions: ['tex2jax.js', 'TeX/AMSmath.js', 'TeX/AMSsymbols.js', 'TeX/boldsymbol.js'],
    jax: ['input/TeX', 'output/SVG'],
    messageStyle: 'none', showMathMenu: false, SVG: {linebreaks: {automatic: true}},
    // A comma after a formula stays on its line.
    AuthorInit: () => MathJax.Hub.Register.StartupHook('End', () => document.querySelectorAll('script[type="math/tex"]').forEach(source => {
      const after = source.nextSibling;
      const mark = after && after.nodeType === Node.TEXT_NODE && /^[.,;:!?)]+/.exec(after.data);
      const formula = source.previousSibling;
      if (!mark || !formula) return;
      const whole = document.createElement('span');
      whole.style.whiteSpace = 'nowrap';
      after.splitText(mark[0].length);
      formula.before(whole);
      whole.append(formula, source, after);
    })),
  };
  const script = document.createElement('script');
  script.src = 'mathjax/MathJax.js';
  document.head.append(script);
});
